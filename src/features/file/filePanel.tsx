import { useUi } from '../../ui/context.ts';
import { formatCount } from '../../ui/kit/format.ts';
import { words } from './words.ts';

const SHOWN = 100;

/** The open file: what it holds, and every line that could not be used. */
export function FilePanel() {
  const { state } = useUi().app;
  void state.rowsVersion.value;
  const motion = state.motion.value;
  if (motion?.source !== 'file') return <p class="hint pad">{words.none}</p>;
  const issues = motion.issues;
  return (
    <div class="file">
      <p class="file-title">{motion.title}</p>
      <p class="hint">
        {formatCount(motion.trajectory.length)} {words.rows}, {motion.trajectory.columns.length} {words.columns}
      </p>
      {issues.length === 0 ? (
        <p class="hint">{words.clean}</p>
      ) : (
        <details data-testid="issues" open={issues.length <= 8}>
          <summary>{words.issues(issues.length)}</summary>
          <ol class="issues">
            {issues.slice(0, SHOWN).map((issue, i) => (
              <li key={i}>
                <b>
                  {issue.line > 0 ? `${words.line} ${issue.line}` : words.whole}
                  {issue.column !== '' && `, ${words.column} ${issue.column}`}
                </b>
                <span>{issue.message}</span>
              </li>
            ))}
          </ol>
          {issues.length > SHOWN && <p class="hint">{words.more(issues.length - SHOWN)}</p>}
        </details>
      )}
    </div>
  );
}

/** The same beside the numbers of the moment, while a file is on the stage. */
export function FileNotes() {
  if (useUi().app.state.motion.value?.source !== 'file') return null;
  return (
    <section class="file-section" aria-label={words.title}>
      <h3>{words.title}</h3>
      <FilePanel />
    </section>
  );
}
