/** What of a controller's computer is too much for fields of its own: sensors, actuators and path, as JSON. */
import type { LqrControl } from '../../core/scenario/types.ts';
import { lqrWords as words } from './lqrWords.ts';
import { TextSetting } from './textSetting.tsx';

const KEYS = ['sensors', 'process', 'seed', 'actuators', 'path'] as const;
type Program = Pick<LqrControl, (typeof KEYS)[number]>;

const textOf = (control: LqrControl): string => {
  const present = KEYS.filter((key) => control[key] !== undefined);
  return present.length === 0 ? '' : JSON.stringify(Object.fromEntries(present.map((k) => [k, control[k]])), null, 1);
};

export function ProgramField({ control, change }: { control: LqrControl; change(part: Partial<LqrControl>): void }) {
  return (
    <details class="lqr-program" open={control.path !== undefined || control.process !== undefined}>
      <summary>{words.program}</summary>
      <p class="hint">{words.programNote}</p>
      <TextSetting
        testId="lqr-program"
        label={words.programLabel}
        rows={6}
        text={textOf(control)}
        read={readProgram}
        change={(program) => change({ ...Object.fromEntries(KEYS.map((key) => [key, undefined])), ...program })}
      />
    </details>
  );
}

/** The keys, or in words why they are none; what they say is checked with the scenario. */
export function readProgram(text: string): Program | string {
  if (text.trim() === '') return {};
  let read: unknown;
  try {
    read = JSON.parse(text);
  } catch (error) {
    return words.notJson((error as Error).message);
  }
  if (typeof read !== 'object' || read === null || Array.isArray(read)) return words.notObject;
  const unknown = Object.keys(read).filter((key) => !(KEYS as readonly string[]).includes(key));
  return unknown.length > 0 ? words.unknownKeys(unknown.join(', ')) : (read as Program);
}
