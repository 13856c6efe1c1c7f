/** How the file on the stage was read: what was understood, each column, the first rows. Every change is read at once. */
import './import.css';
import type { Motion } from '../../app/runs/motion.ts';
import type { ImportPlan } from '../../csv/plan.ts';
import { useUi } from '../../ui/context.ts';
import { Section } from '../../ui/kit/controls.tsx';
import { TableScroll } from '../../ui/kit/tableScroll.tsx';
import { drafted } from './choices.ts';
import { ColumnsTable } from './columnsTable.tsx';
import { FileFacts } from './fileNotes.tsx';
import { Questions } from './questions.tsx';
import { Understood } from './understood.tsx';
import { words } from './words.ts';

export function ImportTool() {
  const motion = useUi().app.state.motion.value;
  if (motion?.source !== 'file') return <p class="hint pad">{words.none}</p>;
  return (
    <div class="scroll" tabIndex={0} role="region" aria-label={words.title} data-testid="import-tool">
      <div class="import">
        <Questions place="tool" />
      </div>
      <div class="file">
        <FileFacts motion={motion} />
      </div>
      {motion.imported && <Reading motion={motion} imported={motion.imported} />}
    </div>
  );
}

function Reading({
  motion,
  imported: { plan: found, choices },
}: {
  motion: Motion;
  imported: NonNullable<Motion['imported']>;
}) {
  const { state, actions, systemOf } = useUi().app;
  const refused = state.refusedReading.value;
  const pending = state.readingAgain.value ?? refused?.choices;
  const system = pending?.system === undefined ? found.system : pending.system;
  const meta = system === null ? null : (systemOf(system)?.meta ?? motion.system.meta);
  const plan = pending ? drafted(found, pending, meta) : found;
  const chosen = Object.keys(choices).length > 0;
  const busy = state.readingAgain.value !== null;
  return (
    <div class="import" aria-busy={busy}>
      {refused && (
        <div class="question refused" role="alert" data-testid="import-refused">
          <p>{words.refused(refused.message)}</p>
          <div class="question-answers">
            <button type="button" data-testid="import-keep" onClick={() => actions.keepReading()}>
              {words.keep}
            </button>
          </div>
        </div>
      )}
      <Section title={words.columnsTitle} open>
        <ColumnsTable plan={plan} meta={meta} />
      </Section>
      <Section title={words.found} open>
        <p class="hint">{words.foundHint}</p>
        <Understood plan={plan} meta={meta} />
        {chosen && (
          <div class="import-reset">
            <button type="button" data-testid="import-as-found" onClick={() => actions.readAgain(null)}>
              {words.asFound}
            </button>
            <p class="hint">{words.asFoundHint}</p>
          </div>
        )}
      </Section>
      <Section title={words.preview} open>
        <Preview plan={plan} />
      </Section>
      <p class="hidden" role="status">
        {busy ? words.readingAgain : ''}
      </p>
    </div>
  );
}

function Preview({ plan: { columns, preview } }: { plan: ImportPlan }) {
  return (
    <TableScroll label={words.previewRegion}>
      <table class="import-preview" data-testid="import-preview">
        <thead>
          <tr>
            {columns.map(({ index, title, source }) => (
              <th key={index} scope="col">
                {title || source}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {preview.map((row, i) => (
            <tr key={i}>
              {row.map((cell, c) => (
                <td key={c}>{cell}</td>
              ))}
            </tr>
          ))}
        </tbody>
      </table>
    </TableScroll>
  );
}
