/** One lesson: its text, its live parts, its questions. */
import { useSignal, type Signal } from '@preact/signals';
import { useState } from 'preact/hooks';
import { isRight, readTyped } from '../../core/lessons/typed.ts';
import type { Block, Lesson, Subject, Vary } from '../../core/lessons/lesson.ts';
import { useUi } from '../../ui/context.ts';
import { Markdown } from '../../ui/kit/markdown.tsx';
import { LessonChart } from './lessonChart.tsx';
import { answered, progress } from './progress.ts';
import { reasonOf, scenarioOf } from './subject.ts';
import { words } from './words.ts';

export function LessonView({ lesson }: { lesson: Lesson & { id: string } }) {
  let questions = 0;
  const active = useSignal<{ block: Block; origin: unknown } | null>(null);
  return (
    <article class="help-text lesson">
      {lesson.blocks.map((block, k) => {
        if (block.kind === 'text') return <Markdown key={k} text={block.text} linkOf={() => null} />;
        if (block.kind === 'live') return <Live key={k} block={block} active={active} />;
        return <Question key={k} block={block} lesson={lesson.id} number={questions++} />;
      })}
    </article>
  );
}

interface LiveProps {
  block: Extract<Block, { kind: 'live' }>;
  /** The part that was shown last, and what it put into the panel. */
  active: Signal<{ block: Block; origin: unknown } | null>;
}

function Live({ block, active }: LiveProps) {
  const { app } = useUi();
  const { vary, title, subject, plot } = block;
  const given = vary ? valueIn(subject, vary) : null;
  const [value, setValue] = useState(vary ? Number((given ?? (vary.from + vary.to) / 2).toPrecision(3)) : 0);
  const [moved, setMoved] = useState(false);
  const [fault, setFault] = useState('');
  const show = async (change: number | null): Promise<void> => {
    try {
      const path = vary && change !== null ? { path: vary.path, value: change } : null;
      const { draft } = await scenarioOf(app, subject, path);
      if ('case' in subject && !path) app.actions.loadCase(subject.case);
      else app.actions.loadScenario(draft, title);
      active.value = { block, origin: app.state.origin.peek() };
      setFault('');
    } catch (error) {
      setFault(words.loadFailed(reasonOf(error)));
    }
  };
  return (
    <div class="lesson-live" role="group" aria-label={title}>
      <span>{title}</span>
      <button
        type="button"
        data-testid="lesson-show"
        onClick={() => void show(vary && (given === null || moved) ? value : null)}
      >
        {words.load}
      </button>
      {vary && (
        <label class="lesson-slider">
          <span>{words.value(vary.path[1], String(value))}</span>
          <input
            type="range"
            min={vary.from}
            max={vary.to}
            step="any"
            value={value}
            onInput={({ currentTarget }) => {
              setMoved(true);
              setValue(Number(Number(currentTarget.value).toPrecision(3)));
            }}
            onChange={({ currentTarget }) => void show(Number(Number(currentTarget.value).toPrecision(3)))}
          />
        </label>
      )}
      {fault && <p role="alert">{fault}</p>}
      {plot && active.value?.block === block && active.value.origin === app.state.origin.value && (
        <LessonChart plot={plot} title={title} />
      )}
    </div>
  );
}

/** What the scenario says of the value that a slider moves; null where it says nothing that is a number. */
function valueIn(subject: Subject, { path: [group, name] }: Vary): number | null {
  const values = 'scenario' in subject ? (subject.scenario[group] as Record<string, unknown> | undefined) : undefined;
  const raw = values?.[name];
  if (typeof raw === 'number') return raw;
  if (typeof raw !== 'string') return null;
  const typed = readTyped(raw, 'rad');
  return 'value' in typed ? typed.value : null;
}

interface QuestionProps {
  block: Extract<Block, { kind: 'question' }>;
  lesson: string;
  number: number;
}

function Question({ block, lesson, number }: QuestionProps) {
  const { app } = useUi();
  const { unit, hint, subject, ask, times, tolerance } = block;
  const [text, setText] = useState('');
  const [told, setTold] = useState('');
  const [hinted, setHinted] = useState(false);
  const [busy, setBusy] = useState(false);
  const right = progress.value[lesson]?.includes(number) ?? false;
  const check = async (): Promise<void> => {
    const typed = readTyped(text, unit);
    if ('fault' in typed) return setTold(words.fault(typed.fault));
    setBusy(true);
    try {
      const { checked } = await scenarioOf(app, subject);
      const answer = await app.mechanics.answer(checked, ask);
      if (!answer) return;
      if (!answer.ok) return setTold(words.noAnswer(answer.message));
      const value = times * answer.value;
      if (!isRight(typed.value, value, tolerance)) return setTold(words.wrong);
      answered(lesson, number);
      setTold(words.right(`${value.toPrecision(4)}${unit === '1' ? '' : ` ${unit}`}`));
    } catch (error) {
      setTold(words.noAnswer(reasonOf(error)));
    } finally {
      setBusy(false);
    }
  };
  const title = words.question(number + 1);
  return (
    <form
      class="lesson-question"
      data-testid={`question-${number}`}
      data-right={right}
      aria-label={title}
      onSubmit={(event) => {
        event.preventDefault();
        void check();
      }}
    >
      <strong>
        {title}
        {right ? ' ✓' : ''}
      </strong>
      <Markdown text={block.text} linkOf={() => null} />
      <label>
        <span>
          {words.answer} {unit === '1' ? '' : words.inUnit(unit)}
        </span>
        <input
          type="text"
          value={text}
          autocomplete="off"
          maxLength={100}
          onInput={({ currentTarget }) => setText(currentTarget.value)}
        />
      </label>
      <div class="lesson-buttons">
        <button type="submit" disabled={busy}>
          {words.check}
        </button>
        {hint && (
          <button type="button" aria-expanded={hinted} onClick={() => setHinted(!hinted)}>
            {words.hint}
          </button>
        )}
      </div>
      {hinted && <p class="hint">{hint}</p>}
      <p role="status">{busy ? words.computing : told}</p>
    </form>
  );
}
