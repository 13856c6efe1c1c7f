import { useUi } from '../context.ts';
import { formatCount } from '../kit/format.ts';
import { text } from '../words.ts';

const SHOWN = 100;

/** The open file: what it holds, and every line that could not be used. */
export function FilePanel() {
  const { state } = useUi().app;
  void state.rowsVersion.value;
  const motion = state.motion.value;
  if (motion?.source !== 'file') return <p class="hint pad">{text.file.none}</p>;
  const issues = motion.issues;
  return (
    <div class="file">
      <p class="file-title">{motion.title}</p>
      <p class="hint">
        {formatCount(motion.trajectory.length)} {text.status.rows}, {motion.trajectory.columns.length}{' '}
        {text.status.columns}
      </p>
      {issues.length === 0 ? (
        <p class="hint">{text.file.clean}</p>
      ) : (
        <details data-testid="issues" open={issues.length <= 8}>
          <summary>{text.file.issues(issues.length)}</summary>
          <ol class="issues">
            {issues.slice(0, SHOWN).map((issue, i) => (
              <li key={i}>
                <b>
                  {issue.line > 0 ? `${text.file.line} ${issue.line}` : text.file.whole}
                  {issue.column !== '' && `, ${text.file.column} ${issue.column}`}
                </b>
                <span>{issue.message}</span>
              </li>
            ))}
          </ol>
          {issues.length > SHOWN && <p class="hint">{text.file.more(issues.length - SHOWN)}</p>}
        </details>
      )}
    </div>
  );
}
