/** The list of lessons, and one that is open beside the stage. */
import './lessons.css';
import { useRef, useState } from 'preact/hooks';
import { readLesson, type Lesson } from '../../core/lessons/lesson.ts';
import { ownId } from '../../core/scenario/own.ts';
import { LoadingPart } from '../../ui/kit/loadingPart.tsx';
import { LessonView } from './lessonView.tsx';
import { progress } from './progress.ts';
import { reasonOf } from './subject.ts';
import { words } from './words.ts';

const loaders = import.meta.glob<string>('../../../lessons/*.md', { query: '?raw', import: 'default' });
const shipped = Object.entries(loaders)
  .map(([path, load]) => ({ id: path.split('/').at(-1)!.replace(/\.md$/, ''), load }))
  .sort((a, b) => a.id.localeCompare(b.id));
/** Titles and numbers of questions are needed for the list: all six are 20 kB. */
let texts: Promise<readonly (Lesson & { id: string })[]> | null = null;
const readAll = (): Promise<readonly (Lesson & { id: string })[]> =>
  (texts ??= Promise.all(shipped.map(async ({ id, load }) => ({ ...readLesson(await load()), id }))));

/** More is refused before it is read. */
const LARGEST = 200_000;

export function LessonsTool() {
  const [list, setList] = useState<readonly (Lesson & { id: string })[] | null>(null);
  const [failed, setFailed] = useState(false);
  const [open, setOpen] = useState<(Lesson & { id: string }) | null>(null);
  const [fault, setFault] = useState('');
  const asked = useRef(false);
  const file = useRef<HTMLInputElement>(null);
  if (!asked.current) {
    asked.current = true;
    readAll().then(setList, () => {
      texts = null;
      setFailed(true);
    });
  }
  const take = async (given: File | undefined): Promise<void> => {
    if (!given) return;
    try {
      const text = given.size > LARGEST ? 'x'.repeat(LARGEST) : await given.text();
      setOpen({ ...readLesson(text), id: ownId(text) });
      setFault('');
    } catch (error) {
      setFault(words.ownFailed(reasonOf(error)));
    }
  };
  if (open)
    return (
      <div class="lessons pad scroll" data-testid="lesson">
        <button type="button" class="link" data-testid="lessons-back" onClick={() => setOpen(null)}>
          {words.back}
        </button>
        <LessonView key={open.id} lesson={open} />
      </div>
    );
  return (
    <div class="lessons pad scroll" data-testid="lessons">
      <p class="hint">{words.about}</p>
      {list ? (
        <ul class="lessons-list">
          {list.map((lesson) => (
            <li key={lesson.id}>
              <button type="button" class="link" data-testid={`lesson-${lesson.id}`} onClick={() => setOpen(lesson)}>
                {lesson.title}
              </button>
              <span class="hint">
                {words.progress(
                  progress.value[lesson.id]?.length ?? 0,
                  lesson.blocks.filter(({ kind }) => kind === 'question').length,
                )}
              </span>
            </li>
          ))}
        </ul>
      ) : (
        <LoadingPart failed={failed} />
      )}
      <button type="button" onClick={() => file.current?.click()}>
        {words.own}
      </button>
      <input
        ref={file}
        type="file"
        accept=".md,text/markdown"
        hidden
        data-testid="lesson-file"
        onChange={({ currentTarget }) => void take(currentTarget.files?.[0])}
      />
      <p role="alert">{fault}</p>
    </div>
  );
}
