/** The complex plane: axes, the growing half, and what is drawn into it. */
import type { ComponentChildren } from 'preact';
import { useEffect, useRef, useState } from 'preact/hooks';
import type { Complex } from '../../core/control/linearization/spectrum.ts';
import { formatShort } from '../../ui/kit/format.ts';
import { words } from './words.ts';
import { bendOf, extent, linearScale, logarithmicScale } from './planeScale.ts';

const MARGIN = { left: 52, right: 12, top: 12, bottom: 34 };
const LEAST_GAP = { x: 44, y: 20 };

/** What an open-loop eigenvalue is drawn as. */
export const CROSS = 'M-4.5 -4.5L4.5 4.5M4.5 -4.5L-4.5 4.5';

export type Place = (eigenvalue: Complex) => { x: number; y: number };

export function Plane({
  eigenvalues,
  logarithmic,
  height = 300,
  label,
  testId,
  children,
}: {
  /** What must fit in. */
  eigenvalues: readonly Complex[];
  logarithmic: boolean;
  height?: number;
  label: string;
  testId: string;
  children(place: Place): ComponentChildren;
}) {
  const host = useRef<HTMLDivElement>(null);
  const width = useWidth(host);
  const frame = {
    x: MARGIN.left,
    y: MARGIN.top,
    width: Math.max(40, width - MARGIN.left - MARGIN.right),
    height: height - MARGIN.top - MARGIN.bottom,
  };
  const { real, imaginary } = scales(eigenvalues, logarithmic);
  const x = (re: number) => frame.x + frame.width * real.place(re);
  const y = (im: number) => frame.y + frame.height * (1 - imaginary.place(im));
  const [axisX, axisY] = [x(0), y(0)];
  return (
    <div ref={host} class="plane" style={{ height: `${height}px` }}>
      <svg width={width} height={height} role="group" aria-label={label} data-testid={testId}>
        <rect
          class="growing"
          x={axisX}
          y={frame.y}
          width={Math.max(0, frame.x + frame.width - axisX)}
          height={frame.height}
        />
        {spaced(real.ticks, x, LEAST_GAP.x).map((tick) => (
          <g key={`x${tick}`}>
            <line class="grid" x1={x(tick)} x2={x(tick)} y1={frame.y} y2={frame.y + frame.height} />
            <text class="tick" x={x(tick)} y={frame.y + frame.height + 14} text-anchor="middle">
              {formatShort(tick)}
            </text>
          </g>
        ))}
        {spaced(imaginary.ticks, y, LEAST_GAP.y).map((tick) => (
          <g key={`y${tick}`}>
            <line class="grid" x1={frame.x} x2={frame.x + frame.width} y1={y(tick)} y2={y(tick)} />
            <text class="tick" x={frame.x - 6} y={y(tick) + 4} text-anchor="end">
              {formatShort(tick)}
            </text>
          </g>
        ))}
        <line class="axis" x1={frame.x} x2={frame.x + frame.width} y1={axisY} y2={axisY} />
        <line class="axis" x1={axisX} x2={axisX} y1={frame.y} y2={frame.y + frame.height} />
        <text class="tick" x={frame.x + frame.width} y={height - 4} text-anchor="end">
          {words.realPart}
        </text>
        <text
          class="tick"
          x={4}
          y={frame.y + frame.height / 2}
          text-anchor="middle"
          transform={`rotate(-90 10 ${frame.y + frame.height / 2})`}
        >
          {words.imaginaryPart}
        </text>
        {children(([re, im]) => ({ x: x(re), y: y(im) }))}
      </svg>
    </div>
  );
}

function scales(eigenvalues: readonly Complex[], logarithmic: boolean) {
  const [re, im] = [eigenvalues.map((e) => e[0]), eigenvalues.map((e) => Math.abs(e[1]))];
  const [left, right] = extent(re);
  const top = extent([...im, 0.2 * Math.max(...re.map(Math.abs), 0)])[1];
  if (!logarithmic) return { real: linearScale(left, right), imaginary: linearScale(-top, top) };
  const small = bendOf([...re, ...im].map(Math.abs));
  return {
    real: logarithmicScale(2 * left, Math.max(2 * right, small), small),
    imaginary: logarithmicScale(-2 * top, 2 * top, small),
  };
}

/** Ticks that leave room for their numbers; zero first. */
function spaced(ticks: readonly number[], place: (x: number) => number, gap: number): number[] {
  const kept: number[] = [];
  for (const tick of [...ticks].sort((a, b) => Math.abs(a) - Math.abs(b) || a - b)) {
    if (kept.every((other) => Math.abs(place(other) - place(tick)) >= gap)) kept.push(tick);
  }
  return kept;
}

function useWidth(host: { current: HTMLElement | null }): number {
  const [width, setWidth] = useState(480);
  useEffect(() => {
    const observer = new ResizeObserver(([entry]) => {
      if (entry && entry.contentRect.width > 0) setWidth(Math.round(entry.contentRect.width));
    });
    observer.observe(host.current!);
    return () => observer.disconnect();
  }, []);
  return width;
}
