/** How far a regulator is from losing its stability, input by input, and what its sensors see. */
import type { EstimatorReport, MarginsReport, SampledReport } from '../../core/control/sampled/computerReport.ts';
import { useUi } from '../../ui/context.ts';
import { formatShort } from '../../ui/kit/format.ts';
import { movers } from './movers.ts';
import { lqrWords as words } from './lqrWords.ts';

/** Moduli that are shown; the slowest are those that matter. */
const SHOWN = 4;

const listed = (moduli: readonly number[]): string =>
  moduli
    .slice(0, SHOWN)
    .map((m) => formatShort(m, 4))
    .join(', ') + (moduli.length > SHOWN ? ' and smaller ones' : '');

export function Margins({
  margins,
  sampled,
  estimator,
}: {
  margins: MarginsReport;
  sampled: SampledReport | null;
  estimator: EstimatorReport | null;
}) {
  const meta = useUi().system.value!.meta;
  const labelOf = (name: string): string => meta.inputs.find((i) => i.name === name)?.label ?? name;
  const factor = (x: number | null): string => (x === null ? words.unbounded : `× ${formatShort(x, 3)}`);
  return (
    <>
      <table class="lqr-margins" data-testid="lqr-margins">
        <caption>{words.margins}</caption>
        <thead>
          <tr>
            {words.marginColumns.slice(0, 4).map((name) => (
              <th key={name} scope="col">
                {name}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {Object.entries(margins.gain).map(([name, [down, up]]) => {
            const phase = margins.phase[name] ?? null;
            return (
              <tr key={name}>
                <th scope="row">{labelOf(name)}</th>
                <td class="number">{factor(down)}</td>
                <td class="number">{factor(up)}</td>
                <td class="number">
                  {phase === null ? words.unbounded : `${formatShort((phase * 180) / Math.PI, 3)}°`}
                </td>
              </tr>
            );
          })}
        </tbody>
      </table>
      <p class="hint">{words.disc(formatShort(margins.disc, 3))}</p>
      {sampled && <p class="hint">{words.moduli(listed(sampled.moduli))}</p>}
      {estimator && (
        <p class="hint" data-testid="lqr-estimator">
          {words.sees(estimator.dimension, estimator.dimension + estimator.unseen.length)}{' '}
          {estimator.unseen.length > 0 && `${words.unseenBySensors(movers(meta, estimator.unseen))} `}
          {estimator.moduli && words.filterPoles(listed(estimator.moduli))}
        </p>
      )}
    </>
  );
}
