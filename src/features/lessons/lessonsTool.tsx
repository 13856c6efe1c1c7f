/** The list of lessons, and one that is open beside the stage. */
import './lessons.css';
import { useEffect, useRef, useState } from 'preact/hooks';
import { lessonIn, lessonLink, type OwnLesson } from '../../app/files/ownLesson.ts';
import { readLesson, type Lesson } from '../../core/lessons/lesson.ts';
import { useUi } from '../../ui/context.ts';
import { FileButton } from '../../ui/kit/fileButton.tsx';
import { LoadingPart } from '../../ui/kit/loadingPart.tsx';
import { LessonView } from './lessonView.tsx';
import { progress } from './progress.ts';
import { faultsIn, reasonOf, type Fault } from './subject.ts';
import { words } from './words.ts';

const loaders = import.meta.glob<string>('../../../lessons/*.md', { query: '?raw', import: 'default' });
const shipped = Object.entries(loaders)
  .map(([path, load]) => ({ id: path.split('/').at(-1)!.replace(/\.md$/, ''), load }))
  .sort((a, b) => a.id.localeCompare(b.id));
/** Titles and numbers of questions are needed for the list: all six are 20 kB. */
let texts: Promise<readonly (Lesson & { id: string })[]> | null = null;
const readAll = (): Promise<readonly (Lesson & { id: string })[]> =>
  (texts ??= Promise.all(shipped.map(async ({ id, load }) => ({ ...readLesson(await load()), id }))));

export function LessonsTool() {
  const { app } = useUi();
  const own = app.state.lesson.value;
  const [list, setList] = useState<readonly (Lesson & { id: string })[] | null>(null);
  const [failed, setFailed] = useState(false);
  const [open, setOpen] = useState<(Lesson & { id: string }) | null>(null);
  const [fault, setFault] = useState('');
  const asked = useRef(false);
  if (!asked.current) {
    asked.current = true;
    readAll().then(setList, () => {
      texts = null;
      setFailed(true);
    });
  }
  const take = async (given: File): Promise<void> => {
    try {
      app.actions.setLesson(await lessonIn(given));
      setFault('');
    } catch (error) {
      setFault(words.ownFailed(reasonOf(error)));
    }
  };
  const shown = own ?? open;
  const back = (): void => {
    setOpen(null);
    app.actions.setLesson(null);
  };
  if (shown)
    return (
      <div class="lessons pad scroll" data-testid="lesson">
        <button type="button" class="link" data-testid="lessons-back" onClick={back}>
          {words.back}
        </button>
        {own && <OwnNotes key={own.id} lesson={own} />}
        <LessonView key={shown.id} lesson={shown} />
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
      <FileButton
        label={words.own}
        accept=".md,text/markdown"
        testId="lesson-file"
        onFile={(file) => void take(file)}
      />
      <p role="alert">{fault}</p>
    </div>
  );
}

/** Of a lesson that is no part of the page: what in it can't be used, for whoever wrote it, and its link. */
function OwnNotes({ lesson }: { lesson: OwnLesson }) {
  const { app } = useUi();
  const [faults, setFaults] = useState<readonly Fault[]>([]);
  const [told, setTold] = useState('');
  useEffect(() => void faultsIn(app, lesson).then(setFaults), []);
  const copy = async (): Promise<void> => {
    const link = lessonLink(lesson);
    if (link === null) return setTold(words.longLink);
    const address = `${location.origin}${location.pathname}#${link}`;
    await navigator.clipboard.writeText(address).then(
      () => setTold(words.copied),
      () => setTold(words.notCopied(address)),
    );
  };
  return (
    <>
      <button type="button" class="link" data-testid="lesson-link" onClick={() => void copy()}>
        {words.copyLink}
      </button>
      <p role="status">{told}</p>
      {faults.length > 0 && (
        <div role="alert" class="lesson-faults" data-testid="lesson-faults">
          <p>{words.faults(faults.length)}</p>
          <ul>
            {faults.map(({ line, why }) => (
              <li key={line}>{words.faultIn(line, why)}</li>
            ))}
          </ul>
        </div>
      )}
    </>
  );
}
