/** The path of every eigenvalue in the complex plane; marks stand where the pointer or the slider is. */
import type { Signal } from '@preact/signals';
import { useMemo } from 'preact/hooks';
import type { ScenarioLocus } from '../../core/control/locus/scenarioLocus.ts';
import type { Complex } from '../../core/control/linearization/spectrum.ts';
import { CROSS, Plane, type Place } from './plane.tsx';

export function LocusPlane({
  locus,
  index,
  logarithmic,
  label,
}: {
  locus: ScenarioLocus;
  index: Signal<number>;
  logarithmic: boolean;
  label: string;
}) {
  const eigenvalues = useMemo(() => locus.branches.flat(), [locus]);
  return (
    <Plane eigenvalues={eigenvalues} logarithmic={logarithmic} label={label} testId="locus-plane">
      {(place) => (
        <>
          <Paths locus={locus} place={place} />
          {locus.branches.map((branch, i) => {
            const { x, y } = place(branch[Math.min(index.value, branch.length - 1)]!);
            return <circle key={i} class="mode-closed" cx={x} cy={y} r="4" />;
          })}
        </>
      )}
    </Plane>
  );
}

function Paths({ locus, place }: { locus: ScenarioLocus; place: Place }) {
  const points = (branch: readonly Complex[]) =>
    branch
      .map((e) => {
        const { x, y } = place(e);
        return `${x.toFixed(1)},${y.toFixed(1)}`;
      })
      .join(' ');
  return (
    <>
      {locus.branches.map((branch, i) => {
        const start = place(branch[0]!);
        return (
          <g key={i}>
            <polyline class="locus-path" points={points(branch)} />
            <path class="mode-open" d={CROSS} transform={`translate(${start.x} ${start.y}) scale(0.8)`} />
          </g>
        );
      })}
    </>
  );
}
