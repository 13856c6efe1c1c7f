/** The gain by input and state, its residual, and everything as files for other programs. */
import { useSignal } from '@preact/signals';
import { useUi } from '../../ui/context.ts';
import { TableScroll } from '../../ui/kit/tableScroll.tsx';
import { MathSymbol } from '../../charts/textView.tsx';
import type { ControlAnalysis } from '../../core/control/analysis.ts';
import { exportFormats, type ExportFormat } from '../../core/control/design/exports.ts';
import type { SystemMeta } from '../../core/model/system.ts';
import { Section } from '../../ui/kit/controls.tsx';
import { formatScientific, formatShort } from '../../ui/kit/format.ts';
import { words } from './words.ts';
import type { Column } from '../../core/motion/columns.ts';
import { InputHead } from './reachSection.tsx';

/** Gains below this share of the largest are rounding. */
const ROUNDING = 1e-12;

export type SaveText = (name: string, content: string, type: string) => void;

export function GainSection({
  analysis,
  names,
  meta,
  save,
}: {
  analysis: ControlAnalysis;
  names: ReadonlyMap<string, Column>;
  meta: SystemMeta;
  save: SaveText;
}) {
  const write = (format: ExportFormat) =>
    save(
      `${analysis.system}-${analysis.K ? 'lqr' : 'linear'}.${format.extension}`,
      format.write(analysis),
      format.type,
    );
  return (
    <Section title={words.gain} open>
      {analysis.K ? (
        <Gains analysis={analysis} K={analysis.K} names={names} meta={meta} />
      ) : (
        <p class="hint">{words.noGain}</p>
      )}
      <div class="export-row" role="group" aria-label={words.exports(analysis.K !== null)}>
        <span>{words.exports(analysis.K !== null)}</span>
        {exportFormats.map((format) => (
          <button
            key={format.id}
            type="button"
            data-testid={`analysis-export-${format.id}`}
            onClick={() => write(format)}
          >
            {words.formats[format.id]}
          </button>
        ))}
      </div>
      {analysis.K && <ProgramExports name={analysis.system} save={save} />}
    </Section>
  );
}

/** The sampled controller as a program; nothing without a sample time. */
function ProgramExports({ name, save }: { name: string; save: SaveText }) {
  const { app } = useUi();
  const problem = useSignal('');
  const draft = app.state.draft.value;
  if (draft.control?.type !== 'lqr' || !draft.control.sample) return <p class="hint">{words.noProgram}</p>;
  if (draft.control.path) return <p class="hint">{words.noPathProgram}</p>;
  const write = async (id: string): Promise<void> => {
    const answer = await app.control.computer(draft, 'program');
    if (answer === null) return;
    problem.value = answer.ok ? '' : answer.message;
    if (!answer.ok || !answer.value.controller) return;
    const { programFormats } = await import('../../core/control/design/programExports.ts');
    const format = programFormats.find((f) => f.id === id)!;
    save(`${name}-controller.${format.extension}`, format.write(answer.value.controller), format.type);
  };
  return (
    <div class="export-row" role="group" aria-label={words.program}>
      <span>{words.program}</span>
      {(['c', 'python', 'matlab', 'json'] as const).map((id) => (
        <button key={id} type="button" data-testid={`program-export-${id}`} onClick={() => void write(id)}>
          {words.programFormats[id]}
        </button>
      ))}
      {problem.value && (
        <p class="error" role="alert">
          {problem.value}
        </p>
      )}
    </div>
  );
}

function Gains({
  analysis: { inputs, states, Q, R, careResidual },
  K,
  names,
  meta,
}: {
  analysis: ControlAnalysis;
  K: readonly (readonly number[])[];
  names: ReadonlyMap<string, Column>;
  meta: SystemMeta;
}) {
  const largest = Math.max(...K.flat().map(Math.abs));
  const show = (x: number) => (Math.abs(x) <= ROUNDING * largest ? '0' : formatShort(x, 4));
  return (
    <>
      <p class="hint">{words.gainNote}</p>
      <TableScroll label={words.gain}>
        <table data-testid="gains">
          <thead>
            <tr>
              <th scope="col">{words.state}</th>
              <th scope="col">{words.per}</th>
              {inputs.map((name) => (
                <InputHead key={name} name={name} meta={meta} unit />
              ))}
              <th scope="col">{words.weight}</th>
            </tr>
          </thead>
          <tbody>
            {states.map((name, i) => {
              const state = names.get(name);
              return (
                <tr key={name}>
                  <th scope="row" title={state?.label}>
                    <MathSymbol of={state?.symbol ?? name} rate={state?.rate} />
                    <span class="hidden">{state?.label ?? name}</span>
                  </th>
                  <td class="hint">{state?.unit}</td>
                  {K.map((row, k) => (
                    <td key={inputs[k]} class="number">
                      {show(row[i]!)}
                    </td>
                  ))}
                  <td class="number">{formatShort(Q?.[i] ?? 0)}</td>
                </tr>
              );
            })}
          </tbody>
          <tfoot>
            <tr>
              <th scope="row" colSpan={2}>
                {words.effort}
              </th>
              {inputs.map((name, k) => (
                <td key={name} class="number">
                  {formatShort(R?.[k] ?? 1)}
                </td>
              ))}
              <td />
            </tr>
          </tfoot>
        </table>
      </TableScroll>
      <p>
        {words.care} <b data-testid="care-residual">{formatScientific(careResidual ?? NaN)}</b>
      </p>
    </>
  );
}
