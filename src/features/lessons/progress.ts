/** Which questions were answered rightly, by lesson, as it is kept in the browser. */
import { signal } from '@preact/signals';
import { browserStorage } from '../../app/persistence/browserStorage.ts';

const NAME = 'lessons';
/** A teacher's lessons are kept too, and no browser keeps thousands. */
const MOST_LESSONS = 200;

type Progress = Readonly<Record<string, readonly number[]>>;

function stored(): Progress {
  try {
    const raw: unknown = JSON.parse(browserStorage.text(NAME) ?? '{}');
    if (typeof raw !== 'object' || raw === null) return {};
    const right = ([, list]: [string, unknown]): boolean =>
      Array.isArray(list) && list.every((n) => Number.isInteger(n));
    return Object.fromEntries(Object.entries(raw).filter(right)) as Progress;
  } catch {
    return {};
  }
}

export const progress = signal<Progress>(stored());

/** @param question its number in the lesson, from 0 */
export function answered(lesson: string, question: number): void {
  const known = progress.peek()[lesson] ?? [];
  if (known.includes(question)) return;
  const { [lesson]: _, ...others } = progress.peek();
  const kept = Object.entries(others).slice(1 - MOST_LESSONS);
  progress.value = { ...Object.fromEntries(kept), [lesson]: [...known, question] };
  browserStorage.putText(NAME, JSON.stringify(progress.peek()));
}
