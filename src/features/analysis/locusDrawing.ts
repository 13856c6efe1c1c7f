import type { App } from '../../app/app.ts';
import type { LocusCurve, LocusPlot } from '../../charts/locusPlot.ts';
import { token } from '../../charts/tokens.ts';
import type { ScenarioLocus } from '../../core/control/locus/scenarioLocus.ts';

/** How a locus is drawn: axis labels, a factor from SI to the unit shown, and for a scale that bends to logarithmic, where and its ticks. */
export interface LocusDrawing {
  xLabel: string;
  yLabel: string;
  factor: number;
  bend?: number;
  ticks?: readonly number[];
  onPoint(index: number | null): void;
}

/** Draws real parts against what is varied into an element, again when the theme changes. Returns how to end it. */
export function plotLocus(app: App, host: HTMLElement, locus: ScenarioLocus, drawing: LocusDrawing): () => void {
  let plot: LocusPlot | null = null;
  let ended = false;
  let stop = (): void => {};
  const observer = new ResizeObserver(() => plot?.resize(host.clientWidth, host.clientHeight));
  void import('../../charts/locusPlot.ts').then(({ createLocusPlot }) => {
    if (ended) return;
    const draw = (): void => {
      plot?.destroy();
      const { factor, ...rest } = drawing;
      plot = createLocusPlot(host, {
        ...rest,
        values: locus.values.map((x) => x * factor),
        marks: locus.critical.map(({ value }) => value * factor),
        curves: curvesOf(locus, token('--accent'), token('--text')),
        colors: { ink: token('--muted'), line: token('--line'), mark: token('--text'), above: token('--growing') },
      });
    };
    // The theme's colours are in force after the page's own effect: draw in the next frame.
    stop = app.state.theme.subscribe(() => requestAnimationFrame(() => !ended && draw()));
    observer.observe(host);
  });
  return () => {
    ended = true;
    stop();
    observer.disconnect();
    plot?.destroy();
  };
}

/** Each branch as two curves: where it swings (imaginary part) and where it does not. */
function curvesOf({ branches }: ScenarioLocus, swinging: string, plain: string): LocusCurve[] {
  return branches.flatMap((branch) => {
    const swings = branch.map(([, im]) => im !== 0);
    // A neighbour's point is shared, so that the two kinds meet.
    const part = (kind: boolean): number[] =>
      branch.map(([re], i) =>
        swings[i] === kind || (kind && (swings[i - 1] === kind || swings[i + 1] === kind)) ? re : NaN,
      );
    const curves = [
      { color: plain, y: part(false) },
      { color: swinging, width: 2, y: part(true) },
    ];
    return curves.filter(({ y }) => y.some((v) => !Number.isNaN(v)));
  });
}
