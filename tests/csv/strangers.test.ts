// What a stranger's tools put around the same motion, and what is none.
import { describe, expect, test } from 'vitest';
import { readStream } from '../../src/csv/reading/stream.ts';
import { metas } from '../helpers.ts';
import { base, comma, deg, expectCircle, f, motionOf, N, readBytes, states, table } from './circle.ts';

type Row = (typeof states)[number];
const rows = (of: (state: Row, i: number) => readonly (string | number)[]): string[][] =>
  states.map((state, i) => of(state, i).map((cell) => (typeof cell === 'number' ? f(cell) : cell)));
const scaled = rows(([t, x, y, a]) => [t, 1000 * x, 1000 * y, deg(a)]);
const ascii = (text: string): number[] => [...text].map((c) => c.charCodeAt(0));
const bytesOf = (...parts: (string | number[])[]): Uint8Array =>
  Uint8Array.from(parts.flatMap((part) => (typeof part === 'string' ? [...new TextEncoder().encode(part)] : part)));

const FILES: Record<string, Record<string, string | Uint8Array>> = {
  'lines between the names and the rows': {
    'types of columns': table('t,x,y,theta\nfloat64,float64,float64,float64\n', base),
    'types, with names of rows': table(
      '       t      x      y  theta\n   <dbl>  <dbl>  <dbl>  <dbl>\n',
      base.map((b, i) => [`${i + 1} ${b.join(' ')}`]),
    ),
    'a rule': table('    t    x    y    theta\n  ____  ____  ____  ____\n\n', base, '   '),
    'signals and units': table('time,x,y,theta\nSignal Name:,x,y,theta\nUnits:,mm,mm,deg\n', scaled),
    'ranges and units, behind their words': table(
      'Interval=\t0.02 s\nChannelTitle=\tx\ty\ttheta\nRange=\t10 m\t10 m\t10 rad\nUnitName=\tmm\tmm\tdeg\n',
      scaled,
      '\t',
    ),
    'the same without a time': table(
      'Interval=\t20 ms\nChannelTitle=\tx\ty\ttheta\nRange=\t10 m\t10 m\t10 rad\n',
      base.map((b) => b.slice(1)),
      '\t',
    ),
    'the index named in a line of its own': table('body,board,board,board\naxis,x,y,theta\nt,,,\n', base),
    'the same, one level': table('name,x,y,theta\ntime,,,\n', base),
  },
  'rows that begin with a separator': {
    tabs: table(
      'inDegrees=no\nendheader\ntime\tx\ty\ttheta\n',
      base.map((b) => ['', ...b]),
      '\t',
    ),
    commas: table(
      't,x,y,theta\n',
      base.map((b) => ['', ...b]),
    ),
    semicolons: table(
      't;x;y;theta\n',
      base.map((b) => ['', ...b]),
      ';',
    ),
  },
  'rows of separators at the end are nothing': {
    two:
      table(
        't,x,y,theta,,,\n',
        rows((s) => [...s, '', '', '']),
      ) + ',,,,,,\n,,,,,,\n',
    semicolons: comma(table('t;x;y;theta\n', base, ';')) + ';;;\n;;;\n;;;\n',
    tabs: table('t\tx\ty\ttheta\n', base, '\t') + '\t\t\t\n',
  },
  'names made longer in one way': {
    'before, underscore': table('t,board_x,board_y,board_theta\n', base),
    'before, two words': table('time,robot_pose_x,robot_pose_y,robot_pose_theta\n', base),
    behind: table('t,x_meas,y_meas,theta_meas\n', base),
    'frames between': table(
      '#timestamp, p_RS_R_x [m], p_RS_R_y [m], q_RS_w [], q_RS_x [], q_RS_y [], q_RS_z []\n',
      rows(([, x, y, a], i) => [
        String(1403636579763555584n + BigInt(i) * 20000000n),
        x,
        y,
        Math.cos(a / 2),
        '0',
        '0',
        Math.sin(a / 2),
      ]),
    ),
    'a block’s output': table('time,x:1,y:1,theta:1\n', base),
    'parts of an array': table('t,pos[0],pos[1],yaw\n', base),
    'parts of a position, named so': table('t,position[0],position[1],heading\n', base),
  },
  'names as LaTeX sets them': {
    dollars: table('$t$ [s],$x$ [m],$y$ [m],$\\theta$ [rad]\n', base),
    plain: table('t,x,y,\\theta\n', base),
    'roman, with units': table('\\mathrm{t} [s];x [mm];y [mm];{\\theta} [deg]\n', scaled, ';'),
  },
  times: {
    ts: table(
      'ts,x,y,theta\n',
      rows(([t, ...s]) => [String(Math.round(1e6 * t) + 1744909208123456), ...s]),
    ),
    'Date as milliseconds since 1970': table(
      'Date,x,y,theta\n',
      rows(([t, ...s]) => [String(Math.round(1e3 * t) + 1744909208123), ...s]),
    ),
    'Datum as seconds since 1970': table(
      'Datum;x;y;theta\n',
      rows(([t, ...s]) => [f(1744909208 + t), ...s]),
      ';',
    ),
    dt: table(
      'dt,x,y,theta\n',
      rows(([, ...s]) => ['0.02', ...s]),
    ),
    'Delta t with a unit': table(
      'Delta t [ms],x,y,theta\n',
      rows(([, ...s]) => ['20', ...s]),
    ),
    'time step, uneven and yet in all the same': table(
      'time step (s),x,y,theta\n',
      rows(([, ...s]) => ['0.020', ...s]),
    ),
  },
  'units of a long table': {
    'beside the values': table(
      'time,variable,value,unit\n',
      scaled.flatMap(([t, x, y, a]) => [
        [t!, 'x', x!, 'mm'],
        [t!, 'y', y!, 'mm'],
        [t!, 'theta', a!, 'deg'],
      ]),
    ),
    'behind the names': table(
      'time,signal,value\n',
      scaled.flatMap(([t, x, y, a]) => [
        [t!, 'x [mm]', x!],
        [t!, 'y [mm]', y!],
        [t!, 'theta [deg]', a!],
      ]),
    ),
    'before the values, some without': table(
      'time;unit;name;wert\n',
      scaled.flatMap(([t, x, y, a]) => [
        [t!, 'mm', 'x', x!],
        [t!, 'mm', 'y', y!],
        [t!, '°', 'theta', a!],
        [t!, '-', 'load', '1'],
      ]),
      ';',
    ),
  },
  'signs of units': {
    'inches, straight': table(
      't,x ("),y ("),theta\n',
      rows(([t, x, y, a]) => [t, x / 0.0254, y / 0.0254, a]),
    ),
    'a degree of another character set': bytesOf(
      't,x,y,theta (',
      [0xa1],
      table(
        ')\n',
        rows(([t, x, y, a]) => [t, x, y, deg(a)]),
      ),
    ),
    'a degree encoded twice': table(
      't,x,y,theta (Â°)\n',
      rows(([t, x, y, a]) => [t, x, y, deg(a)]),
    ),
    'a degree that is lost': table(
      't,x,y,theta (\ufffd)\n',
      rows(([t, x, y, a]) => [t, x, y, deg(a)]),
    ),
  },
  'older encodings': {
    Japanese: bytesOf([0x8e, 0x9e, 0x8a, 0xd4], ',x,y,', [0x83, 0x88, 0x81, 0x5b, 0x8a, 0x70], table('\n', base)),
    Cyrillic: bytesOf([0xc2, 0xf0, 0xe5, 0xec, 0xff], ';x;y;', [0xca, 0xf3, 0xf0, 0xf1], table('\n', base, ';')),
    Chinese: bytesOf([0xca, 0xb1, 0xbc, 0xe4], ',x,y,', [0xc6, 0xab, 0xba, 0xbd, 0xbd, 0xc7], table('\n', base)),
    'Central European': bytesOf([0xc8], 'as;x;y;vybo', [0xe8], 'en', [0xed], table('\n', base, ';')),
  },
  'units behind commas, between commas': {
    Russian: table('Время, с,x, м,y, м,Курс, рад\n', base),
    German: table('Zeit, s,x, mm,y, mm,Gierwinkel, deg\n', scaled),
    'with blanks': table('t, s, x, mm, y, mm, theta, deg\n', scaled),
  },
  'beginnings of a serial line': {
    'a zero': bytesOf([0], table('t,x,y,theta\n', base)),
    'zeros and half a row': bytesOf([0, 0], '3,0.1\n', table('t,x,y,theta\n', base)),
    'a break': bytesOf([0, 0xef, 0xbf, 0xbd], '\n', table('t,x,y,theta\n', base)),
  },
};

describe.each(Object.entries(FILES))('%s', (_, files) => {
  test.each(Object.entries(files))('%s', (__, file) => expectCircle(motionOf(file)));
});

test('steps since the row before are summed, however long each is', () => {
  const times = [0, 0.02, 0.05, 0.051, 0.2];
  const motion = motionOf(
    table(
      'dt [ms],x,y,theta\n',
      times.map((t, i) => [f(1000 * (t - (times[i - 1] ?? 0))), '0', '0', '0']),
    ),
  );
  for (const [i, t] of times.entries()) expect(motion.data[0]![i]!).toBeCloseTo(t, 9);
});

/** Groups and prefixes that have parts along x and y and are no positions. */
const OTHERS =
  'acc accel Acceleration Beschleunigung gyro mag Magnetometer force Kraft torque err error std sigma cov angular_velocity twist.linear velocity residual'.split(
    ' ',
  );
test.each(OTHERS)('%s along x and y is no position', (other) => {
  for (const by of ['_', '.', ' ', '/', ':']) {
    const motion = motionOf(table(`time,${other}${by}x,${other}${by}y,yaw\n`, base));
    expect(motion.systemId, `${other}${by}x: ${motion.notes.join('; ')}`).toBeNull();
    // Beside the positions it changes nothing.
    const beside = motionOf(
      table(
        `time,${other}${by}x,${other}${by}y,x,y,yaw\n`,
        rows(([t, x, y, a]) => [t, '5', '6', x, y, a]),
      ),
    );
    expectCircle(beside);
  }
});

test('what stands in brackets and is no unit belongs to the name', () => {
  for (const names of [
    ['V(x)', 'V(y)', 'I(L1)'],
    ['Temp (probe 1)', 'Temp (probe 2)', 'Flow (main)'],
    ['p(in)put', 'p(out)', 'p(mid)'],
  ])
    expect(motionOf(table(`time,${names.join(',')}\n`, base)).columns).toEqual(['t', ...names]);
});

test.each(['-9999', '-999', '9999', '-9999.99', '1e30'])('%s stands for a missing value', (value) => {
  const out = [0, 30, 31, 32, 100];
  const motion = motionOf(
    table(
      't,x [m],y [m],theta\n',
      rows((s, i) => (out.includes(i) ? [s[0], value, value, value] : s)),
    ),
  );
  expect(motion).toMatchObject({ rows: N - out.length, skippedRows: out.length, questions: [] });
  expect(motion.issues.map(({ line, to }) => [line, to])).toEqual([
    [2, undefined],
    [32, 34],
    [102, undefined],
  ]);
  expect(Math.max(...motion.data[1]!)).toBeLessThan(2);
  // A single column, or a value that others come near to, may be a place.
  for (const far of [
    rows((s, i) => (i > 50 ? [s[0], value, s[2], s[3]] : s)),
    rows((s, i) => [s[0], String((+value / N) * i), String((+value / N) * i), s[3]]),
  ])
    expect(motionOf(table('t,x [m],y [m],theta\n', far)).rows).toBe(N);
});

test('lines after rows left out are named by their own numbers', () => {
  const motion = motionOf(
    table(
      't,x,y,theta\n',
      rows((s, i) => (i === 10 ? [s[0], '-9999', '-9999', '-9999'] : i === 60 ? [0.5, ...s.slice(1)] : s)),
    ),
  );
  expect(motion.issues.map(({ line }) => line)).toEqual([12, 62]);
});

test('the board by the words for its plates and casters', () => {
  for (const names of [
    'roll;pitch;yaw;front plate;back plate;front caster;back caster',
    'Rollwinkel;Nickwinkel;Gierwinkel;vordere Platte;hintere Platte;vordere Laufrolle;hintere Laufrolle',
    'roulis;tangage;lacet;plateau avant;plateau arrière;roulette avant;roulette arrière',
  ]) {
    const motion = motionOf(
      table(
        `time;X;Y;Z;${names}\n`,
        rows(([t, x, y, a]) => [t, x, y, '0.1', '0', '0', a, '0.2', '0.3', '0.4', '0.5']),
        ';',
      ),
    );
    expect(motion.systemId).toBe('ripstik');
    for (const [k, name] of ['alpha_fp', 'alpha_bp', 'theta_fc', 'theta_bc'].entries())
      expect(motion.data[motion.columns.indexOf(name)]![5]).toBe((k + 2) / 10);
  }
});

describe('what is no table of lines says what to do', () => {
  const pad = Array.from({ length: 300 }, (_, i) => (i * 7) % 11);
  test.each<[string, RegExp, Uint8Array]>([
    ['TDMS', /TDMS.*as_dataframe|TDMS/, bytesOf('TDSm', pad)],
    ['MDF', /asammdf/, bytesOf('MDF     4.10    ', pad)],
    ['a CAN log', /DBC/, bytesOf('LOGG', pad)],
    ['ULog', /ulog2csv/, bytesOf([...ascii('ULog'), 1, 0x12, 0x35], pad)],
    ['ArduPilot', /mavlogdump/, bytesOf([0xa3, 0x95, 0x80], pad)],
    ['R', /write\.csv/, bytesOf('RDX3\nX\n', pad)],
    ['R, unpacked', /write\.csv/, bytesOf('X\n', [0, 0, 0, 3], pad)],
    ['ORC', /read_orc/, bytesOf('ORC', pad)],
    ['RAR', /RAR/, bytesOf('Rar!', [0x1a, 7], pad)],
    ['tar', /tar -xf/, bytesOf('run.csv', new Array<number>(250).fill(0), 'ustar', pad)],
    ['a pickle', /read_pickle/, bytesOf([0x80, 4, 0x95, 0, 1, 0, 0], pad)],
    ['rich text', /RTF/, bytesOf('{\\rtf1\\ansi t,x\\par 0,0}')],
    ['HTML', /HTML page .*save it as CSV/, bytesOf('<html><body><table><tr><td>1</td></tr></table></body></html>')],
    ['a table that calls itself .xls', /HTML page/, bytesOf('\ufeff<table>\n<tr><td>1</td></tr></table>')],
    ['XML', /XML/, bytesOf('<?xml version="1.0"?>\n<run><row t="0"/></run>')],
    ['XML without a head', /XML/, bytesOf('<run>\n<t>0</t></run>')],
    [
      'YAML of a topic',
      /rostopic echo -p/,
      bytesOf('header:\n  seq: 1\npose:\n  x: 0.1\n---\nheader:\n  seq: 2\n---\n'),
    ],
    [
      'rows that lie',
      /exchange rows and columns/,
      bytesOf(['t', 'x', 'y', 'theta'].map((name, k) => [name, ...base.map((b) => b[k]!)].join(',')).join('\n')),
    ],
    [
      'rows that lie, with units',
      /exchange rows and columns/,
      bytesOf(
        ['time [s]', 'x [mm]', 'heading [deg]']
          .map((name, k) => [name, ...base.map((b) => b[k]!)].join(';'))
          .join('\n'),
      ),
    ],
    ['names alone', /names, and no rows of numbers/, bytesOf('t,x,y,theta\n')],
  ])('%s', (_, reason, bytes) => {
    const result = readBytes(bytes);
    expect(result.kind).toBe('unusable');
    if (result.kind === 'unusable') expect(result.issues[0]!.message).toMatch(reason);
  });

  test.each([
    ['tags as names', '<DATE>,<x>,<y>,<theta>\n'],
    ['a preamble of keys', 'Settings:\nrate: 50\nunits: SI\n\nt,x,y,theta\n'],
    ['a heading between rules', '---\nrate: 50\n---\nt,x,y,theta\n'],
  ])('but %s is one', (_, head) => {
    expect(motionOf(table(head, base)).rows).toBe(N);
  });
});

describe('JSON', () => {
  const streamed = (value: unknown) =>
    readStream(new Blob([typeof value === 'string' ? value : JSON.stringify(value)]).stream(), {
      systems: metas,
      data: true,
      unasked: true,
    });
  const list = (k: number): number[] => base.map((b) => +b[k]!);
  test.each([
    ['one level down', { time: list(0), signals: { x: list(1), y: list(2), theta: list(3) } }],
    ['two levels down', { run: { t: list(0), pose: { x: list(1), y: list(2), heading: list(3) } } }],
    ['beside words', { name: 'run', rate: 50, data: { t: list(0), x: list(1), y: list(2), theta: list(3) } }],
  ])('arrays %s', async (_, value) => {
    const result = await streamed(value);
    if (result.kind !== 'motion') throw new Error(JSON.stringify(result));
    expectCircle(result);
  });

  test.each([
    [
      'lists inside records',
      [
        { x: list(0), y: list(1) },
        { x: list(0), y: list(2) },
      ],
      /holds no table/,
    ],
    ['a comma too many', '[{"t": 0, "x": 1},\n{"t": 1, "x": 2},]', /a comma stands before the last bracket/],
    ['cut', '{"t": [0, 1, 2], "x": [0, 1', /can't be read/],
  ])('%s: why not', async (_, value, reason) => {
    const result = await streamed(value);
    expect(result.kind).toBe('unusable');
    if (result.kind === 'unusable') expect(result.issues[0]!.message).toMatch(reason);
  });
});
