/** What the weights amount to: eigenvalues in the complex plane, time constants, what no input reaches. */
import { effect, signal } from '@preact/signals';
import { useEffect } from 'preact/hooks';
import type { Answer } from '../../app/app.ts';
import type { ControlAnalysis } from '../../core/control/analysis.ts';
import { useUi } from '../../ui/context.ts';
import { formatScientific, formatShort } from '../../ui/kit/format.ts';
import { Term } from '../../ui/kit/term.tsx';
import { LqrEffect } from './lqrEffect.tsx';
import { movers } from './movers.ts';
import { lqrWords as words } from './lqrWords.ts';

const WIDTH = 288;
const HEIGHT = 116;
const MARGIN = 10;

/** The design of what stands in the panel, asked for as the weight moves; the last one while the next is computed. */
const design = signal<Answer<ControlAnalysis> | null>(null);

export function useAskForDesign(): void {
  const { app } = useUi();
  // Not useSignalEffect, which waits for a frame.
  useEffect(() => {
    design.value = null;
    return effect(() => {
      const draft = app.state.draft.value;
      if (draft.control?.type !== 'lqr') return;
      void app.control.analyse(draft, 'panel').then((found) => {
        if (found) design.value = found;
      });
    });
  }, []);
}

const useDesign = () => design.value;

export function LqrReadout() {
  const now = useDesign();
  if (!now)
    return (
      <p class="hint" data-testid="lqr-readout">
        {words.computing}
      </p>
    );
  if (!now.ok)
    return (
      <p class="error" role="alert" data-testid="lqr-readout">
        {now.message}
      </p>
    );
  const { closedLoop } = now.value;
  return (
    <div class="lqr-readout" data-testid="lqr-readout">
      <ComplexPlane open={now.value.eigenvalues} closed={now.value.closedLoopEigenvalues ?? []} />
      <p class="poles" data-testid="lqr-poles">
        <span class="poles-title">
          <Term id="pole">{words.poles}</Term>
        </span>{' '}
        {(closedLoop ?? [])
          .filter(({ eigenvalue }) => eigenvalue[1] >= 0)
          .map(({ eigenvalue, damping }, i) => (
            <span key={i} class="pole" title={words.poleDamping(formatShort(damping ?? 1, 2))}>
              {poleInWords(eigenvalue)}
            </span>
          ))}
      </p>
      <LqrEffect />
    </div>
  );
}

/** What else is known of the design: how fast and how damped it is, and what it leaves as it is. */
export function LqrFacts() {
  const ui = useUi();
  const answer = useDesign();
  if (!answer?.ok) return null;
  const { closedLoop, careResidual, reachability, uncontrollable, unseen, eigenvalues } = answer.value;
  const slowest = closedLoop?.reduce((a, b) => (b.eigenvalue[0] > a.eigenvalue[0] ? b : a), closedLoop[0]!);
  const leastDamped = closedLoop?.reduce((a, b) => ((b.damping ?? 1) < (a.damping ?? 1) ? b : a), closedLoop[0]!);
  const untouched = [...uncontrollable, ...(unseen ?? [])];
  // A coordinate that no input reaches, and that is part of all sums that a person looks at.
  const { sums = [], coordinates } = ui.system.value!.meta;
  const free = coordinates.find(
    ({ name }) =>
      sums.length > 0 &&
      sums.every(({ of }) => of.includes(name)) &&
      uncontrollable.some(({ moves }) => moves[0] === name),
  );
  return (
    <div data-testid="lqr-facts">
      <dl class="facts">
        <dt>{words.slowest}</dt>
        <dd>{slowest ? `${formatShort(slowest.timeConstant ?? Infinity, 3)} s` : '–'}</dd>
        <dt>{words.damping}</dt>
        <dd>{leastDamped ? formatShort(leastDamped.damping ?? 1, 3) : '–'}</dd>
        <dt>
          {words.reachedBefore} <Term id="reachable">{words.reachedTerm}</Term>
        </dt>
        <dd>{words.of(reachability.dimension, eigenvalues.length)}</dd>
        <dt>{words.residual}</dt>
        <dd>{formatScientific(careResidual ?? NaN)}</dd>
      </dl>
      {untouched.length > 0 && <p class="hint">{words.untouched(movers(ui.system.value!.meta, untouched))}</p>}
      {free && <p class="hint">{words.rollsFreely(free.label, sums.map((s) => s.label).join('; '))}</p>}
    </div>
  );
}

/** `−1.2 ± 3.4i`, 1/s. */
function poleInWords([re, im]: readonly [number, number]): string {
  return `${formatShort(re, 3)}${im === 0 ? '' : ` ± ${formatShort(Math.abs(im), 3)}i`}`;
}

/** Open loop as crosses, closed loop as dots; what is farther out points over the edge it stands at. */
function ComplexPlane({
  open,
  closed,
}: {
  open: readonly (readonly [number, number])[];
  closed: readonly (readonly [number, number])[];
}) {
  const all = [...open, ...closed].map(([re, im]) => Math.hypot(re, im)).sort((a, b) => a - b);
  // Half of the modes and the fastest within four times that decide the scale: one very fast mode must not hide the others.
  const middle = all[Math.floor(all.length * 0.6)] || 1;
  const reach = niceAbove(Math.min(all.at(-1) || 1, 4 * middle));
  const x = (re: number) =>
    MARGIN + ((Math.max(-reach, Math.min(reach, re)) + reach) / (2 * reach)) * (WIDTH - 2 * MARGIN);
  const y = (im: number) => HEIGHT / 2 - (Math.max(-reach, Math.min(reach, im)) / reach) * (HEIGHT / 2 - MARGIN);
  return (
    <svg
      class="complex-plane"
      viewBox={`0 0 ${WIDTH} ${HEIGHT}`}
      role="img"
      aria-label={words.plane(closed.map(poleInWords).join('; '))}
    >
      <rect x={WIDTH / 2} y="0" width={WIDTH / 2} height={HEIGHT} class="unstable" />
      <line x1="0" x2={WIDTH} y1={HEIGHT / 2} y2={HEIGHT / 2} class="axis" />
      <line x1={WIDTH / 2} x2={WIDTH / 2} y1="0" y2={HEIGHT} class="axis" />
      <text x="4" y={HEIGHT / 2 - 6}>
        {formatShort(-reach, 2)}
      </text>
      <text x={WIDTH - 4} y={HEIGHT / 2 - 6} text-anchor="end">{`Re ${formatShort(reach, 2)} 1/s`}</text>
      <text x={WIDTH / 2 + 4} y="11">
        {`Im ${formatShort(reach, 2)} 1/s`}
      </text>
      {open.map(([re, im], i) => (
        <path key={`o${i}`} d={`M${x(re) - 3.5} ${y(im) - 3.5}l7 7m0-7l-7 7`} class="open" />
      ))}
      {closed.map(([re, im], i) =>
        Math.max(Math.abs(re), Math.abs(im)) <= reach ? (
          <circle key={`c${i}`} cx={x(re)} cy={y(im)} r="3.2" class="closed" />
        ) : (
          <path
            key={`c${i}`}
            d="M4 0l-8 4.5v-9z"
            transform={`translate(${x(re)} ${y(im)}) rotate(${(Math.atan2(-im, re) * 180) / Math.PI})`}
            class="closed"
          />
        ),
      )}
      <text x="4" y={HEIGHT - 5}>
        {words.legend}
      </text>
    </svg>
  );
}

function niceAbove(value: number): number {
  const power = 10 ** Math.floor(Math.log10(value));
  return [1, 2, 5, 10].map((m) => m * power).find((m) => m >= value)!;
}
