/** The open file: what it holds, and what of it could not be used. */
import './open.css';
import type { Motion } from '../../app/runs/motion.ts';
import { useUi } from '../../ui/context.ts';
import { formatCount } from '../../ui/kit/format.ts';
import { words } from './words.ts';

const SHOWN = 100;

export function FileFacts({ motion }: { motion: Motion }) {
  const { trajectory } = motion;
  const whole = motion.issues.filter(({ line }) => line === 0);
  const issues = motion.issues.filter(({ line }) => line > 0);
  return (
    <>
      <p class="file-title">{motion.title}</p>
      <p class="hint">
        {formatCount(trajectory.length)} {words.rows}, {trajectory.columns.length} {words.columns}
      </p>
      {whole.length > 0 && (
        <p class="hint" data-testid="file-notes">
          {sentence(whole.map(({ message }) => message))}
        </p>
      )}
      {issues.length === 0 ? (
        <p class="hint">{words.clean}</p>
      ) : (
        <details data-testid="issues" open={issues.length <= 8}>
          <summary>{words.issues(issues.length)}</summary>
          <ol class="issues">
            {issues.slice(0, SHOWN).map((issue, i) => (
              <li key={i}>
                <b>
                  {words.lines(issue.line, issue.to)}
                  {issue.column !== '' && `, ${words.column} ${issue.column}`}
                </b>
                <span>{issue.message}</span>
              </li>
            ))}
          </ol>
          {issues.length > SHOWN && <p class="hint">{words.more(issues.length - SHOWN)}</p>}
        </details>
      )}
    </>
  );
}

/** Notes on the whole file, one after another. */
function sentence(notes: readonly string[]): string {
  const text = notes.join('; ');
  return `${text.charAt(0).toUpperCase()}${text.slice(1)}.`;
}

/** Beside the numbers of the moment, while a file is on the stage. */
export function FileNotes() {
  const { state, actions } = useUi().app;
  const motion = state.motion.value;
  if (motion?.source !== 'file') return null;
  return (
    <section class="file-section" aria-label={words.title}>
      <h3>{words.title}</h3>
      <div class="file">
        <FileFacts motion={motion} />
        {motion.imported && (
          <div>
            <button type="button" data-testid="how-read" onClick={() => actions.set('tool', 'import')}>
              {words.how}
            </button>
          </div>
        )}
      </div>
    </section>
  );
}
