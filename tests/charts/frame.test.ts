import { expect, test } from 'vitest';
import { tableOf } from '../../src/charts/chart.ts';
import { curveMark } from '../../src/charts/curves.ts';
import { frameOf, fromX, fromY, paint, toX, toY, type Picture } from '../../src/charts/frame.ts';
import { cells, growingBand, stops } from '../../src/charts/marks.ts';
import { chartSheet } from '../../src/charts/sheet.ts';
import { PRINT } from '../../src/charts/surface.ts';
import { symbolText, words } from '../../src/core/motion/symbols.ts';
import { seeded } from '../helpers.ts';
import { recorder } from './recorder.ts';

const SEED = 31;

const line = (x: readonly number[], y: readonly number[], color = '#111111') =>
  curveMark({ label: symbolText('α_fp'), color, x: Float64Array.from(x), y: Float64Array.from(y), rising: true });

const picture = (more: Partial<Picture> = {}): Picture => ({
  x: { title: words('t, s'), air: 0 },
  y: { title: [...symbolText('α_fp', true), ...words(', °/s')] },
  marks: [line([0, 1, 2], [-5, 0, 5])],
  ...more,
});

test('the frame lies within the picture, places come back as values, whatever the size', () => {
  const random = seeded(SEED);
  for (let k = 0; k < 200; k++) {
    const size = { width: 200 + 900 * random(), height: 120 + 400 * random() };
    const scale = 10 ** (8 * random() - 4);
    const frame = frameOf(
      recorder().surface,
      picture({ marks: [line([0, 1, 2], [-5 * scale, 0, 5 * scale])], equal: random() < 0.3 }),
      size,
    );
    const where = `seed ${SEED}, ${k}`;
    expect(frame.left % 8, where).toBe(0);
    expect(frame.left + frame.width, where).toBeLessThanOrEqual(size.width);
    expect(frame.top + frame.height, where).toBeLessThan(size.height);
    const [x, y] = [3 * random(), scale * (random() - 0.5)];
    expect(fromX(frame, toX(frame, x)), where).toBeCloseTo(x, 9);
    expect(fromY(frame, toY(frame, y)) / scale, where).toBeCloseTo(y / scale, 9);
  }
});

test('equal scales show a unit as long on both axes, and all that must be seen', () => {
  const frame = frameOf(recorder().surface, picture({ equal: true }), { width: 500, height: 200 });
  expect(toX(frame, 1) - toX(frame, 0)).toBeCloseTo(toY(frame, 0) - toY(frame, 1), 9);
  expect([frame.y.low <= -5, frame.y.high >= 5, frame.x.low <= 0, frame.x.high >= 2]).not.toContain(false);
});

test('the y axis follows the part of x that is looked at', () => {
  const zoomed = frameOf(recorder().surface, picture(), { width: 400, height: 200 }, { x: [0, 1], y: null });
  expect([zoomed.x.low, zoomed.x.high]).toEqual([0, 1]);
  expect(zoomed.y.high).toBeLessThan(1);
  expect(zoomed.y.low).toBeLessThan(-5);
});

test('titles are typeset: letters in italics, a subscript below, a dot for a rate; numbers have true minus signs', () => {
  const { surface, texts, circles } = recorder();
  const chart = picture();
  paint(surface, frameOf(surface, chart, { width: 400, height: 200 }), chart, PRINT);
  const of = (text: string) => texts.find((t) => t.text === text)!;
  expect(of('α').font).toMatch(/italic/);
  expect(of('fp').y).toBeGreaterThan(of('α').y);
  expect(circles).toHaveLength(1);
  expect(texts.map((t) => t.text)).toContain('\u22125');
  expect(texts.map((t) => t.text).join(' ')).not.toMatch(/-\d|alpha|_/);
});

test('what lies under the grid is drawn before it, and every tick has its number beside its line', () => {
  const { surface, rects, strokes, texts } = recorder();
  const chart = picture({ marks: [line([0, 1, 2], [-5, 0, 5], '#abcdef'), growingBand('y')] });
  const frame = frameOf(surface, chart, { width: 400, height: 200 });
  paint(surface, frame, chart, PRINT);
  expect(rects[0]).toMatchObject({ style: PRINT.growing, y: frame.top });
  expect(rects[0]!.h).toBeCloseTo(toY(frame, 0) - frame.top, 9);
  expect(strokes.at(-1)!.style).toBe('#abcdef');
  for (const tick of frame.y.ticks(frame.height / 32)) {
    const at = Math.round(toY(frame, tick)) + 0.5;
    expect(strokes.some((s) => s.points.some((p) => p[1] === at))).toBe(true);
    expect(texts.some((t) => t.text === frame.y.text(tick) && t.y === at)).toBe(true);
  }
});

test('cells fill the frame without gaps, the pointer finds each, and a missing value is empty', () => {
  const values = Float64Array.of(1, 2, 3, 4, NaN, 6);
  const map = cells(3, 2, values, 4);
  const chart: Picture = {
    x: { title: [], kind: 'steps', names: ['a', 'b', 'c'], air: 0 },
    y: { title: [], kind: 'steps', names: ['p', 'q'], air: 0 },
    marks: [map],
    bar: { low: 1, high: 6, colour: () => '#000' },
  };
  const { surface, rects } = recorder();
  const frame = frameOf(surface, chart, { width: 400, height: 200 });
  paint(surface, frame, chart, PRINT);
  const drawn = rects.slice(0, 6);
  expect(drawn.reduce((sum, r) => sum + r.w * r.h, 0)).toBeCloseTo(
    Math.round(frame.width) * Math.round(frame.height),
    -2,
  );
  expect(drawn[4]!.style).toBe(PRINT.empty);
  for (let i = 0; i < 6; i++) expect(map.pick!(frame, toX(frame, i % 3), toY(frame, Math.floor(i / 3)))).toBe(i);
  expect(map.pick!(frame, 2, 2)).toBe(null);
});

test('of places along x the nearest is picked', () => {
  const frame = frameOf(recorder().surface, picture(), { width: 400, height: 200 });
  const mark = stops([0, 0.5, 2]);
  expect([0.1, 0.4, 1.9].map((x) => mark.pick!(frame, toX(frame, x), 50))).toEqual([0, 1, 2]);
});

test('the table has the numbers of the curves at even places; outside of its rows a curve has none', () => {
  const short = curveMark({
    label: words('short'),
    color: '',
    x: Float64Array.of(0, 1),
    y: Float64Array.of(0, 2),
    yFactor: 10,
    rising: true,
  });
  const table = tableOf(picture({ marks: [line([0, 1, 2], [-5, 0, 5]), short] }), [0, 2]);
  expect(table.map((c) => c.values.length)).toEqual([21, 21, 21]);
  expect(table[1]!.values[5]).toBeCloseTo(-2.5, 12);
  expect(table[2]!.values[5]).toBeCloseTo(10, 12);
  expect(table[2]!.values[20]).toBeNaN();
});

test('an SVG file says the same as the page, well formed, with its title, legend and symbols', () => {
  const svg = chartSheet([
    {
      title: 'A < B & C',
      picture: picture({ marks: [line([0, 1, 2], [-5, 0, 5], '#d55e00'), line([0, 2], [1, 1], '#0072b2')] }),
      legend: [
        { label: symbolText('α_fp'), color: '#d55e00' },
        { label: symbolText('ψ'), color: '#0072b2', dash: [5, 3] },
      ],
    },
  ]);
  expect(svg).toContain('A &lt; B &amp; C');
  expect(svg).toMatch(/<path d="M[^"]+" fill="none" stroke="#d55e00"/);
  expect(svg).toMatch(/font-style="italic"[^>]*>ψ</);
  const opened = svg.match(/<(g|svg|clipPath)\b/g)!.length;
  expect(svg.match(/<\/(g|svg|clipPath)>/g)!.length).toBe(opened);
  expect(svg).not.toMatch(/NaN|undefined|Infinity/);
});

test('a range that is tiny beside its values is drawn small and said, an ordinary one fills the chart', () => {
  const size = { width: 400, height: 200 };
  const drawn = (y: readonly number[], more: Partial<Picture> = {}) => {
    const { surface, texts } = recorder();
    const chart = picture({ marks: [line([0, 1, 2], y)], ...more });
    const frame = frameOf(surface, chart, size);
    paint(surface, frame, { ...chart, y: { ...chart.y, unit: 'J' } }, PRINT);
    return {
      share: (Math.max(...y) - Math.min(...y)) / (frame.y.high - frame.y.low),
      said: texts.find(({ text }) => text.startsWith('varies'))?.text,
    };
  };
  const still = drawn([7.5, 7.5 + 3e-9, 7.5 + 1e-9]);
  expect(still.share).toBeCloseTo(0.25, 3);
  expect(still.said).toBe('varies by only 3e\u22129\u202fJ');
  // About zero, what is less than anything measured.
  expect(drawn([-4e-13, 0, 6e-13]).said).toContain('1e\u221212');
  for (const y of [
    [0.5, 0.4873],
    [-1, 1],
    [0, 0],
    [3, 3],
    [1e-6, 3e-6],
  ])
    expect(drawn(y).said, String(y)).toBe(undefined);
  expect(drawn([0.5, 0.4873]).share).toBeGreaterThan(0.8);
  expect(drawn([7.5, 7.5 + 3e-9], { equal: true }).said).toBe(undefined);
});
