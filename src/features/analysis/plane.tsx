/** The complex plane: axes, the growing half, and what is drawn into it. */
import type { ComponentChildren } from 'preact';
import { ChartView } from '../../charts/chartView.tsx';
import { toX, toY, type Axis, type Picture } from '../../charts/frame.ts';
import { growingBand, lineAcross } from '../../charts/marks.ts';
import type { Complex } from '../../core/control/linearization/spectrum.ts';
import { words as plain } from '../../core/motion/symbols.ts';
import { useUi } from '../../ui/context.ts';
import { words } from './words.ts';
import { bendOf, extent } from './planeScale.ts';

/** What an open-loop eigenvalue is drawn as. */
export const CROSS = 'M-4.5 -4.5L4.5 4.5M4.5 -4.5L-4.5 4.5';

export type Place = (eigenvalue: Complex) => { x: number; y: number };

export function Plane({
  eigenvalues,
  logarithmic,
  label,
  testId,
  children,
}: {
  /** What must fit in. */
  eigenvalues: readonly Complex[];
  logarithmic: boolean;
  label: string;
  testId: string;
  children(place: Place): ComponentChildren;
}) {
  const { app } = useUi();
  return (
    <ChartView
      class="plane"
      label={label}
      options={{}}
      values={() => [
        { title: plain(words.realPart), values: eigenvalues.map(([re]) => re) },
        { title: plain(words.imaginaryPart), values: eigenvalues.map(([, im]) => im) },
      ]}
      // The theme's colours are in force after the page's own effect: draw in the next frame.
      attach={(chart) => app.state.theme.subscribe(() => void requestAnimationFrame(() => chart.redraw()))}
      update={(chart) => chart.setPicture(pictureOf(eigenvalues, logarithmic))}
    >
      {(frame) => (
        <svg
          width={frame.left + frame.width}
          height={frame.top + frame.height}
          role="group"
          aria-label={label}
          data-testid={testId}
        >
          {children(([re, im]) => ({ x: toX(frame, re), y: toY(frame, im) }))}
        </svg>
      )}
    </ChartView>
  );
}

function pictureOf(eigenvalues: readonly Complex[], logarithmic: boolean): Picture {
  const [re, im] = [eigenvalues.map((e) => e[0]), eigenvalues.map((e) => Math.abs(e[1]))];
  const [left, right] = extent(re);
  const top = extent([...im, 0.2 * Math.max(...re.map(Math.abs), 0)])[1];
  const bend = bendOf([...re, ...im].map(Math.abs));
  const scale: Pick<Axis, 'kind' | 'bend'> = logarithmic ? { kind: 'bent', bend } : {};
  return {
    x: {
      ...scale,
      title: plain(words.realPart),
      range: logarithmic ? [2 * left, Math.max(2 * right, bend)] : [left, right],
    },
    y: {
      ...scale,
      title: plain(words.imaginaryPart),
      range: logarithmic ? [-2 * top, 2 * top] : [-top, top],
    },
    marks: [growingBand('x'), lineAcross('x', 0), lineAcross('y', 0)],
  };
}
