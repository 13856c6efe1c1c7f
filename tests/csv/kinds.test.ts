// Kinds of files, one motion in all: what another tool would write, made here.
import { describe, expect, test } from 'vitest';
import { readStream } from '../../src/csv/reading/stream.ts';
import { orderOf } from '../../src/csv/time/order.ts';
import { clockSeconds, moment } from '../../src/csv/time/clock.ts';
import { EpochClock } from '../../src/csv/time/epoch.ts';
import { anglesOf } from '../../src/csv/reading/angles.ts';
import { ratesOf } from '../../src/csv/reading/rates.ts';
import { metas } from '../helpers.ts';
import { base, comma, deg, expectCircle, f, motionOf, N, readBytes, states, table } from './circle.ts';

const scaled = states.map(([t, x, y, a]) => [f(t), f(1000 * x), f(1000 * y), deg(a)]);
const at = (clock: (t: number) => string): string[][] => states.map(([t], i) => [clock(t), ...base[i]!.slice(1)]);
const seconds = (t: number): string => t.toFixed(3).padStart(6, '0');

const KINDS: Record<string, string> = {
  'German names, units and commas': comma(
    table(
      'Zeit [s];x [m];y [m];theta [Grad]\n',
      base.map((b, i) => [...b.slice(0, 3), deg(states[i]![3])]),
      ';',
    ),
  ),
  'Spanish names': table(
    'Tiempo (s)\tx (m)\ty (m)\ttheta (°)\n',
    base.map((b, i) => [...b.slice(0, 3), deg(states[i]![3])]),
    '\t',
  ),
  'French names': table('temps;x;y;theta\n', base, ';'),
  'ISO 80000 units': table('t/s,x/mm,y/mm,theta/deg\n', scaled),
  'units behind colons': table('t: s,x: mm,y: mm,theta: deg\n', scaled),
  'units behind underscores': table('t_s,x_mm,y_mm,theta_deg\n', scaled),
  'a row of units in brackets': table('t;x;y;theta\n[s];[mm];[mm];[deg]\n', scaled, ';'),
  'a row of units with gaps': table(
    't,x,y,theta,note\ns,mm,mm,°,\n',
    scaled.map((r) => [...r, 'a']),
  ),
  'a row of units, one of them unheard of': table(
    't,x,y,theta,way\ns,mm,mm,°,furlong\n',
    scaled.map((r) => [...r, '1']),
  ),
  'an index column': table(
    ',t,x,y,theta\n',
    base.map((b, i) => [String(i), ...b]),
  ),
  'names in two levels': table(',board,board,board\n,x,y,theta\ntime,,,\n', base),
  "R's row names": table(
    '"t" "x" "y" "theta"\n',
    base.map((b, i) => [`"${i + 1}"`, ...b]),
    ' ',
  ),
  'frames and a rate above': table(
    'Recorder,X\nFrame rate,50 fps\nframe,x,y,theta\n',
    base.map((b, i) => [String(i + 7), ...b.slice(1)]),
  ),
  'slashes for comments, packets': table(
    '// Update Rate: 50.0Hz\n// Filter Profile: human\nPacketCounter\tx\ty\tYaw\n',
    base.map((b, i) => [String(i), b[1]!, b[2]!, deg(states[i]![3])]),
    '\t',
  ),
  'elapsed h:m:s': table(
    'elapsed,x,y,theta\n',
    at((t) => `0:00:${seconds(t)}`),
  ),
  'a clock without a date, past midnight': table(
    'time,x,y,theta\n',
    at((t) => (t < 1 ? `23:59:${seconds(59 + t)}` : `00:00:${seconds(t - 1)}`)),
  ),
  'am and pm': table(
    't,x,y,theta\n',
    at((t) => `2025-04-17 11:59:${seconds(t)} AM`),
  ),
  'a German date and clock': comma(
    table(
      'Datum;Uhrzeit;x;y;theta\n',
      at((t) => `17#04#2025;10:00:${seconds(t)}`),
      ';',
    ),
  ).replaceAll('#', '.'),
  'epoch seconds of nine decimals': table(
    'timestamp,x,y,theta\n',
    base.map((b, i) => [
      `${1744909208 + Math.floor(i / 50)}.${String(20 * (i % 50)).padStart(3, '0')}000000`,
      ...b.slice(1),
    ]),
  ),
  'a column of name unix': table(
    'unix,x,y,theta\n',
    at((t) => `${1744909208 + Math.floor(t)}.${String(Math.round(1000 * (t - Math.floor(t)))).padStart(3, '0')}`),
  ),
  'epoch milliseconds': table(
    'time,x,y,theta\n',
    at((t) => String(1744909208000 + Math.round(1000 * t))),
  ),
  'epoch microseconds': table(
    'stamp,x,y,theta\n',
    at((t) => String(1744909208000000 + Math.round(1e6 * t))),
  ),
  'nanoseconds from zero': table(
    'time_ns,x,y,theta\n',
    at((t) => String(Math.round(1e9 * t))),
  ),
  minutes: table(
    't [min],x,y,theta\n',
    at((t) => (t / 60).toFixed(9)),
  ),
  backwards: table('t,x,y,theta\n', [...base].reverse()),
  'two runs': table('t,x,y,theta\n', [...base, ...base]),
  'whole seconds as a clock': table(
    'time,x,y,theta\n',
    at((t) => `10:00:0${Math.floor(t)}`),
  ),
  'a clock set after four rows': table(
    't,x,y,theta\n',
    states.map(([t], i) => [f(i < 4 ? t : 1.7e9 + t), ...base[i]!.slice(1)]),
  ),
  'upright bars': table('t|x|y|theta\n', base, '|'),
  'runs of blanks': table(
    '   t     x       y      theta\n',
    base.map((b) => [`  ${b.join('    ')}`]),
  ),
  'numpy with a header': table(
    '# t x y theta\n',
    states.map((row) => row.map((x) => x.toExponential(18))),
    ' ',
  ),
  'a percent sign before names': table('% t, x, y, theta\n', base),
  'names behind a prefix': table('/robot/t,/robot/x,/robot/y,/robot/theta\n', base),
  'names with dots': table('board.t,board.x,board.y,board.theta\n', base),
  'scalar first': table(
    't,x,y,q0,q1,q2,q3\n',
    base.map((b, i) => [...b.slice(0, 3), f(Math.cos(states[i]![3] / 2)), '0', '0', f(Math.sin(states[i]![3] / 2))]),
  ),
  'scalar last, doubled length': table(
    't,x,y,quat_x,quat_y,quat_z,quat_w\n',
    base.map((b, i) => [
      ...b.slice(0, 3),
      '0',
      '0',
      f(2 * Math.sin(states[i]![3] / 2)),
      f(2 * Math.cos(states[i]![3] / 2)),
    ]),
  ),
  'one value a row, name by name': table(
    'time,variable,value\n',
    ['x', 'y', 'theta'].flatMap((name, k) => base.map((b) => [b[0]!, name, b[k + 1]!])),
  ),
  'localized spreadsheet errors beside': table(
    't;x;y;theta;energy\n',
    base.map((b, i) => [...b, ['#BEZUG!', '#WERT!', '#NV', '1'][i % 4]!]),
    ';',
  ),
};

describe('the same motion', () => {
  test.each(Object.entries(KINDS))('%s', (_, text) => expectCircle(motionOf(text)));

  test.each([
    [
      'UTF-16 with a mark',
      (text: string) => new Uint8Array(Uint16Array.from(`\ufeff${text}`, (c) => c.charCodeAt(0)).buffer),
    ],
    ['UTF-16 without', (text: string) => new Uint8Array(Uint16Array.from(text, (c) => c.charCodeAt(0)).buffer)],
    [
      'UTF-16, big end first',
      (text: string) => Uint8Array.from([...text].flatMap((c) => [c.charCodeAt(0) >> 8, c.charCodeAt(0) & 255])),
    ],
    ['Latin-1', (text: string) => Uint8Array.from(text, (c) => c.charCodeAt(0))],
  ])('%s', (_, encode) => expectCircle(motionOf(encode(KINDS['Spanish names']!))));

  const streamed = async (blob: Blob) => {
    const result = await readStream(blob.stream(), { systems: metas, data: true, unasked: true });
    if (result.kind !== 'motion') throw new Error(JSON.stringify(result));
    return result;
  };
  const records = base.map(([t, x, y, theta]) => ({ t: +t!, pose: { x: +x!, y: +y!, theta: +theta! } }));
  test.each([
    ['records', JSON.stringify(records)],
    ['lines', records.map((r) => JSON.stringify(r)).join('\n')],
    [
      'arrays',
      JSON.stringify({
        t: records.map((r) => r.t),
        x: base.map((b) => +b[1]!),
        y: base.map((b) => +b[2]!),
        theta: base.map((b) => +b[3]!),
      }),
    ],
  ])('JSON %s', async (_, text) => expectCircle(await streamed(new Blob([text]))));

  test('gzip', async () => {
    const packed = new Blob([table('t,x,y,theta\n', base)]).stream().pipeThrough(new CompressionStream('gzip'));
    const bytes = await new Response(packed).arrayBuffer();
    expectCircle(await streamed(new Blob([bytes])));
    const cut = await readStream(new Blob([bytes.slice(0, 12)]).stream(), { systems: metas });
    expect(cut).toMatchObject({ kind: 'unusable', issues: [{ message: expect.stringContaining('gzip') }] });
  });
});

test('a row of units is one, too, where a coordinate has a unit that is not known: it is told, not passed over', () => {
  expect(() => motionOf(table('t,x,y,theta\nmin,km,km,grad\n', base))).toThrow(
    /grad.*is not understood for theta; right would be rad, deg/,
  );
});

test('what names no system is data by its own names, in SI where units are known', () => {
  const motion = motionOf(
    table('Time,Temperature [°C],Speed (km/h)\n', [
      ['0', '20', '36'],
      ['1', '21', '72'],
      ['2', '22', ''],
    ]),
  );
  expect(motion).toMatchObject({ systemId: null, columns: ['t', 'Temperature', 'Speed'], rows: 3 });
  expect([...motion.data[2]!]).toEqual([10, 20, NaN]);
});

test('plates of ten degrees without a unit are asked for; radians that a heading follows are not', () => {
  const names = 't,X,Y,Z,alpha,psi,theta,alpha_fp,alpha_bp,theta_fc,theta_bc\n';
  const plates = (size: number) =>
    table(
      names,
      states.map(([t, x, y, a]) => [
        f(t),
        f(x),
        f(y),
        '0.14',
        '0',
        '0',
        f(a),
        f(size * Math.sin(9 * t)),
        f(-size * Math.sin(9 * t)),
        '0',
        '0',
      ]),
    );
  expect(motionOf(plates(10)).questions.map((q) => q.id)).toEqual(['degrees']);
  expect(motionOf(plates(25)).questions.map((q) => q.id)).toEqual(['degrees']);
  expect(motionOf(plates(0.2)).questions).toEqual([]);
  expect(
    motionOf(
      table(
        't,x,y,theta\n',
        states.map(([t]) => [f(t), f(Math.sin(4 * t)), f(-Math.cos(4 * t)), f(4 * t)]),
      ),
    ).questions,
  ).toEqual([]);
});

test('rows at an event stay, the second at once after the first', () => {
  const motion = motionOf(
    table('t,x,y,theta\n', [...base.slice(0, 50), [base[49]![0]!, '9', '9', '1'], ...base.slice(50)]),
  );
  expect(motion.rows).toBe(N + 1);
  const [t, x] = motion.data as [Float64Array, Float64Array];
  expect(t[50]! - t[49]!).toBeGreaterThan(0);
  expect(t[50]! - t[49]!).toBeLessThan(1e-12);
  expect(x[50]).toBe(9);
});

const heights = (cells: readonly string[], by: string): ReturnType<typeof readBytes> =>
  readBytes(
    new TextEncoder().encode(
      table(
        ['t', 'x', 'y', 'theta'].join(by) + '\n',
        cells.map((cell, i) => [String(i), cell, '1', '0']),
        by,
      ),
    ),
  );

test.each<[cells: string[], by: string, numbers: number[]]>([
  [['1.234,5', '-12.345,25', '0,5'], ';', [1234.5, -12345.25, 0.5]],
  [["1'234.5", '1’234’567', '2'], ',', [1234.5, 1234567, 2]],
  [['"1,234.5"', '"1,235"', '"999.25"'], ',', [1234.5, 1235, 999.25]],
  [['"12,34,567.8"', '1', '2'], ',', [1234567.8, 1, 2]],
  [['1 234,5', '1\u202f234,5', '1\u00a0234'], ';', [1234.5, 1234.5, 1234]],
  [['1,234,567', '1,234', '2'], ';', [1234567, 1234, 2]],
  // From 1000 on and nothing below, beside decimal points.
  [['"1,234"', '999', '998', '"0.5"'], ',', [1234, 999, 998, 0.5]],
])('thousands that have one meaning are read: %j', (cells, by, numbers) => {
  const result = heights(cells, by);
  if (result.kind !== 'motion') throw new Error(JSON.stringify(result));
  expect([...result.data[1]!]).toEqual(numbers);
  expect(result.issues).toEqual([]);
});

test.each([
  [['"1,234"', '0.5', '0.25'], ',', 'could be 1234 or 1.234'],
  [['1.234', '0,5', '12,25'], ';', 'could be 1234 or 1.234'],
  [['1.234.5', '0,5', '2'], ';', 'has a point where'],
])('thousands that could be decimals are refused by name: %j', (cells, by, reason) => {
  expect(JSON.stringify(heights(cells, by))).toContain(reason);
});

test('times in order: what can be kept is kept', () => {
  const order = (list: number[]) => orderOf(Float64Array.from(list), () => false);
  expect(order([5, 0, 1, 2, 3]).rows).toEqual(Int32Array.of(1, 2, 3, 4));
  expect(order([3, 2, 1]).rows).toEqual(Int32Array.of(2, 1, 0));
  expect(order([0, 4, 2, 1, 5, 3]).rows).toEqual(Int32Array.of(0, 3, 2, 5, 1, 4));
  expect(order([0, 1, 2, 0, 1, 2, 0, 1, 2]).runs).toEqual([0, 3, 6]);
});

test('text of times', () => {
  expect(clockSeconds('1:02:03.5')).toBe(3723.5);
  expect(clockSeconds('PT1.5S')).toBe(1.5);
  expect(clockSeconds('1h 2m 3s')).toBe(3723);
  expect(clockSeconds('2 days 01:00:00')).toBe(176400);
  expect(clockSeconds('abc')).toBeNull();
  expect(moment('1970-01-02T00:00:01+01:00')).toEqual({ days: 1, seconds: -3599 });
  expect(moment('2025-02-30')).toBeNull();
  const clock = new EpochClock();
  expect([clock.since('1744909208000000001'), clock.since('1744909208000000002'), clock.since('999')][1]).toBe(1);
});

test('angles of quaternions: Rz Ry Rx, through the seam', () => {
  const column = (list: number[]): Float64Array => Float64Array.from(list);
  const [a, b, c] = [3.1, 0.4, -0.3];
  const quaternion = (yaw: number): number[] => {
    const [cy, sy, cp, sp, cr, sr] = [yaw, b, c].flatMap((angle) => [Math.cos(angle / 2), Math.sin(angle / 2)]) as [
      number,
      number,
      number,
      number,
      number,
      number,
    ];
    return [
      sr * cp * cy - cr * sp * sy,
      cr * sp * cy + sr * cp * sy,
      cr * cp * sy - sr * sp * cy,
      cr * cp * cy + sr * sp * sy,
    ];
  };
  const rows = [a, a + 0.1, a + 0.2].map(quaternion);
  const made = [0, 1, 2].map(() => new Float64Array(3)) as [Float64Array, Float64Array, Float64Array];
  anglesOf(
    [0, 1, 2, 3].map((k) => column(rows.map((r) => r[k]!))) as [Float64Array, Float64Array, Float64Array, Float64Array],
    ...made,
  );
  made[0].forEach((yaw, i) => expect(yaw).toBeCloseTo(a + i / 10, 12));
  expect(made[1][2]).toBeCloseTo(b, 12);
  expect(made[2][2]).toBeCloseTo(c, 12);
});

test('rates by differentiation: exact for a line over uneven times, close for a sine', () => {
  const t = Float64Array.from({ length: 60 }, (_, i) => i / 50 + 0.004 * Math.sin(7 * i));
  ratesOf(
    t.map((s) => 3 * s + 1),
    t,
  )!.forEach((rate) => expect(rate).toBeCloseTo(3, 9));
  const even = Float64Array.from({ length: 60 }, (_, i) => i / 50);
  ratesOf(
    even.map((s) => Math.sin(s)),
    even,
  )!.forEach((rate, i) => expect(rate).toBeCloseTo(Math.cos(even[i]!), 3));
});
