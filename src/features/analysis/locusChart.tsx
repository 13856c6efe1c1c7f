/** Real parts against what is varied: the half above zero is tinted, critical values are marked. */
import type { Chart } from '../../charts/chart.ts';
import { ChartView } from '../../charts/chartView.tsx';
import { curveMark, type Curve } from '../../charts/curves.ts';
import type { Axis, Picture } from '../../charts/frame.ts';
import { growingBand, lineAcross, stops } from '../../charts/marks.ts';
import { token } from '../../charts/tokens.ts';
import type { ScenarioLocus } from '../../core/control/locus/scenarioLocus.ts';
import { words, type Text } from '../../core/motion/symbols.ts';
import { useUi } from '../../ui/context.ts';

export interface LocusChartProps {
  locus: ScenarioLocus;
  xTitle: Text;
  yLabel: string;
  label: string;
  /** From SI to the unit shown. */
  factor: number;
  /** Where the scale bends to logarithmic; linear without it. */
  bend: number | undefined;
  onPoint(index: number | null): void;
  /** For what saves it. */
  onChart(chart: Chart | null): void;
}

export function LocusChart(props: LocusChartProps) {
  const { app } = useUi();
  // Drawn again in another theme's colours, which are in force after the page's own effect: in the next frame.
  void app.state.theme.value;
  return (
    <ChartView
      class="locus-plot"
      testId="locus-plot"
      label={props.label}
      options={{ alongX: true, onHover: props.onPoint }}
      attach={(chart) => {
        props.onChart(chart);
        return () => props.onChart(null);
      }}
      update={(chart) => void requestAnimationFrame(() => chart.setPicture(pictureOf(props)))}
    />
  );
}

function pictureOf({ locus, xTitle, yLabel, factor, bend }: LocusChartProps): Picture {
  const x = Float64Array.from(locus.values, (value) => value * factor);
  const scale: Pick<Axis, 'kind' | 'bend'> = bend === undefined ? {} : { kind: 'bent', bend };
  return {
    x: { title: xTitle, air: 0 },
    y: { ...scale, title: words(yLabel), zero: true },
    marks: [
      growingBand('y'),
      lineAcross('y', 0),
      ...curvesOf(locus, x, yLabel).map(curveMark),
      ...locus.critical.map(({ value }) => lineAcross('x', value * factor, token('--text'), [4, 3])),
      stops(x),
    ],
  };
}

/** Each branch as two curves: where it swings (imaginary part) and where it does not. */
function curvesOf({ branches }: ScenarioLocus, x: Float64Array, label: string): Curve[] {
  const [swinging, plain] = [token('--accent'), token('--text')];
  return branches.flatMap((branch, b) => {
    const swings = branch.map(([, im]) => im !== 0);
    // A neighbour's point is shared, so that the two kinds meet.
    const part = (kind: boolean): Float64Array =>
      Float64Array.from(branch, ([re], i) =>
        swings[i] === kind || (kind && (swings[i - 1] === kind || swings[i + 1] === kind)) ? re : NaN,
      );
    const common = { x, rising: true, label: words(`${label}, ${b + 1}`) };
    const curves: Curve[] = [
      { ...common, color: plain, y: part(false) },
      { ...common, color: swinging, width: 2, y: part(true) },
    ];
    return curves.filter(({ y }) => Array.from(y).some((v) => !Number.isNaN(v)));
  });
}
