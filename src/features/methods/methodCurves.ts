import { effect } from '@preact/signals';
import type { Comparison, Outcome } from '../../app/runs/comparison.ts';
import { download } from '../../app/files/download.ts';
import type { App } from '../../app/app.ts';
import { token } from '../../charts/tokens.ts';
import type { LinePlot } from '../../charts/linePlot.ts';

/** Ends after which a curve's last values mean nothing. */
const ABANDONED: ReadonlySet<string> = new Set(['non-finite', 'newton', 'step-too-small']);

/** Draws one column of every method's run into an element, renewed as rows come. Returns how to end it. */
export function plotComparison(
  app: App,
  host: HTMLElement,
  comparison: Comparison,
  column: string,
  style: (index: number) => { color: string; dash?: readonly number[] },
): () => void {
  let plot: LinePlot | null = null;
  let ended = false;
  let stop = (): void => {};
  void import('../../charts/linePlot.ts').then(({ createLinePlot }) => {
    if (ended) return;
    plot = createLinePlot(host, {
      xLabel: 't, s',
      yLabel: column,
      logarithmic: column === 'residual',
      ink: token('--muted'),
      line: token('--line'),
    });
    plot.resize(host.clientWidth, host.clientHeight);
    let frame = 0;
    const draw = (): void => {
      frame = 0;
      plot?.setData(
        comparison.outcomes.peek().flatMap(({ contender, trajectory, state, reason }, i) => {
          const y = trajectory?.column(column);
          return y
            ? [
                {
                  label: contender.label,
                  ...style(i),
                  x: trajectory!.column('t')!,
                  y,
                  loose: state === 'ended' && ABANDONED.has(reason),
                },
              ]
            : [];
        }),
      );
    };
    stop = effect(() => {
      void comparison.version.value;
      void comparison.outcomes.value;
      void app.state.theme.value;
      if (frame === 0) frame = requestAnimationFrame(draw);
    });
  });
  return () => {
    ended = true;
    stop();
    plot?.destroy();
  };
}

const HEADINGS = [
  'method',
  'name',
  'formulation',
  'rtol',
  'atol',
  'step',
  'stages',
  'computing_s',
  'output_s',
  'steps',
  'rejected',
  'evaluations',
  'jacobians',
  'energy_drift',
  'residual',
  'ended',
];

/** The table as CSV. */
export function saveOutcomes(outcomes: readonly Outcome[]): void {
  const rows = outcomes.map(({ contender: { label, method }, seconds, reached, counts, reason, message, state }) =>
    [
      label,
      method.name,
      method.formulation ?? (method.name === 'ida' ? '' : 'multipliers'),
      method.rtol,
      method.atol,
      method.step,
      method.stages,
      seconds,
      reached,
      counts?.steps,
      counts?.rejected,
      counts?.evaluations,
      counts?.jacobians,
      counts?.energyDrift,
      counts?.residual,
      state === 'ended' ? reason : message || state,
    ]
      .map((cell) =>
        typeof cell === 'string' && /[",\n]/.test(cell) ? `"${cell.replaceAll('"', '""')}"` : String(cell ?? ''),
      )
      .join(','),
  );
  download('methods.csv', [[HEADINGS.join(','), ...rows].join('\n') + '\n'], 'text/csv');
}

/** The curves as they stand, as a PNG. */
export function savePicture(host: HTMLElement): void {
  host.querySelector('canvas')?.toBlob((blob) => {
    if (blob) download('methods.png', [blob], 'image/png');
  });
}
