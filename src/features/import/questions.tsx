/** What the file leaves open, over the stage and in the tool: one press reads it the other way. */
import './open.css';
import type { Question } from '../../csv/plan.ts';
import { useUi } from '../../ui/context.ts';
import { words } from './words.ts';

/** Of the file on the stage, those that were not asked before it was read. */
export function useQuestions(): readonly Question[] {
  const motion = useUi().app.state.motion.value;
  return motion?.imported?.plan.questions.filter(({ first }) => !first) ?? [];
}

export function Questions({ place }: { place: 'stage' | 'tool' }) {
  const { state, actions } = useUi().app;
  const questions = useQuestions();
  const busy = state.readingAgain.value !== null;
  return (
    <div role="status" class={`questions on-${place}`}>
      {questions.map(({ id, text, answers, safest }) => (
        <div key={id} class="question" role="group" aria-label={text} data-testid={`${place}-question-${id}`}>
          <p>{text}</p>
          <div class="question-answers">
            {answers.map(({ label, choices }, i) => (
              <button
                key={label}
                type="button"
                disabled={busy}
                data-testid={`${place}-answer-${id}-${i}`}
                onClick={() => actions.readAgain(choices)}
              >
                {i === safest ? words.shown(label) : label}
              </button>
            ))}
          </div>
        </div>
      ))}
    </div>
  );
}

/** Under the title of what is on the stage, unless they stand in the open tool. */
export function StageQuestions() {
  const open = useUi().app.state.tool.value === 'import';
  return useQuestions().length > 0 && !open ? <Questions place="stage" /> : null;
}
