import { expect, test } from 'vitest';
import { Pen, type LineStyle } from '../../src/charts/pen.ts';

interface Stroke {
  width: number;
  dash: readonly number[];
  offset: number;
  points: [number, number][];
}

/** The strokes that a line becomes. */
function strokes(style: LineStyle, draw: (pen: Pen) => void): Stroke[] {
  const list: Stroke[] = [];
  let points: [number, number][] = [];
  let dash: readonly number[] = [];
  const context = {
    lineWidth: 0,
    lineDashOffset: 0,
    beginPath: () => void (points = []),
    moveTo: (x: number, y: number) => void points.push([x, y]),
    lineTo: (x: number, y: number) => void points.push([x, y]),
    setLineDash: (next: readonly number[]) => void (dash = next),
    stroke: () => void list.push({ width: context.lineWidth, dash, offset: context.lineDashOffset, points }),
  };
  const pen = new Pen(context as unknown as CanvasRenderingContext2D, style);
  draw(pen);
  pen.end();
  return list;
}

const along = (n: number, y: (x: number) => number) => (pen: Pen) => {
  pen.moveTo(0, y(0));
  for (let x = 1; x < n; x++) pen.lineTo(x, y(x));
};

test('a line is drawn whole, in short pieces, and its dashes go on from piece to piece', () => {
  const list = strokes(
    { width: 1.5, dash: [7, 4], hair: 1 },
    along(100, () => 0),
  );
  expect(list.length).toBeGreaterThan(3);
  let at = 0;
  for (const { width, dash, offset, points } of list) {
    expect({ width, dash }).toEqual({ width: 1.5, dash: [7, 4] });
    expect(offset).toBe(at);
    expect(points[0]).toEqual([at, 0]);
    at = points.at(-1)![0];
  }
  expect(at).toBe(99);
});

test('the dashes begin anew after a gap', () => {
  const list = strokes({ width: 1, dash: [2], hair: 1 }, (pen) => {
    along(10, () => 0)(pen);
    pen.moveTo(20, 5);
    pen.lineTo(24, 5);
  });
  expect(list.map(({ offset, points }) => [offset, points.length])).toEqual([
    [0, 10],
    [0, 2],
  ]);
});

test('what fills an area is drawn thin and solid there, and only there; a loop is none of it', () => {
  const list = strokes(
    { width: 2, dash: [7, 4], hair: 0.5 },
    along(300, (x) => (x < 150 ? 40 * Math.sin(x / 30) : (x % 2) * 80)),
  );
  expect(list[0]).toMatchObject({ width: 2, dash: [7, 4] });
  expect(list.at(-2)).toMatchObject({ width: 0.5, dash: [] });
  const loop = strokes({ width: 2, dash: [7, 4], hair: 0.5 }, (pen) => {
    pen.moveTo(50, 0);
    for (let k = 1; k <= 64; k++) pen.lineTo(50 * Math.cos(k / 3), 50 * Math.sin(k / 3));
  });
  expect(loop.every(({ width }) => width === 2)).toBe(true);
});
