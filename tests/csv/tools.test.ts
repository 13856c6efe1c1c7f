// The same motion as the tools of laboratories and workshops export it.
import { describe, expect, test } from 'vitest';
import { readStream } from '../../src/csv/reading/stream.ts';
import { metas } from '../helpers.ts';
import { base, comma, deg, expectCircle, f, motionOf, N, readBytes, states, table } from './circle.ts';

type Row = (typeof states)[number];
const rows = (of: (state: Row, i: number) => readonly (string | number)[]): string[][] =>
  states.map((state, i) => of(state, i).map((cell) => (typeof cell === 'number' ? f(cell) : cell)));
const whole = (x: number): string => String(Math.round(x));
const half = (angle: number): [number, number] => [Math.sin(angle / 2), Math.cos(angle / 2)];
const rates = ([, , , a]: Row): number[] => [0.8 * Math.cos(a), 0.8 * Math.sin(a), 0.8];
const withRates = rows((s) => [...s, ...rates(s)]);
const stamp = (t: number): [sec: string, nanosec: string] => {
  const n = Math.round(1e9 * t);
  return [String(1744909208 + Math.floor(n / 1e9)), String(n % 1e9)];
};

/** Motive's header: bodies, each with its groups of columns. */
const motive = (kind: string, bodies: readonly string[], groups: readonly (readonly [string, string])[]): string => {
  const all = bodies.flatMap((body) => groups.map((group) => [body, ...group] as const));
  const line = (cells: readonly string[]): string => `,,${cells.join(',')}\n`;
  return [
    `Format Version,1.23,Take Name,T,Export Frame Rate,50.0,Rotation Type,${kind},Length Units,Meters\n\n`,
    line(all.map(() => 'Rigid Body')),
    line(all.map(([body]) => body)),
    line(all.map((_, i) => String(100 + i))),
    line(all.map(([, group]) => group)),
    `Frame,Time (Seconds),${all.map(([, , axis]) => axis).join(',')}\n`,
  ].join('');
};
const position = [...'XYZ'].map((axis) => ['Position', axis] as const);
const turns = [...'XYZ'].map((axis) => ['Rotation', axis] as const);
const quaternion = [...'XYZW'].map((axis) => ['Rotation', axis] as const);
const still = ['0', '0', '0', '1', '5', '0.1', '5'];

const qualisys = (bodies: readonly string[]): string =>
  `NO_OF_FRAMES\t${N}\nNO_OF_CAMERAS\t8\nNO_OF_BODIES\t${bodies.length}\nFREQUENCY\t50\nDATA_INCLUDED\t6D\nBODY_NAMES\t${bodies.join('\t')}\nFrame\tTime\t${bodies.map((body) => `${body} X\tY\tZ\tRoll\tPitch\tYaw\tResidual`).join('\t')}\n`;

const EXPORTS: Record<string, string> = {
  'motion capture: turns XYZ, Y up': table(
    motive('XYZ', ['board'], [...turns, ...position]),
    rows(([t, x, y, a], i) => [String(i), t, 0, deg(a), 0, x, 0.15, -y]),
  ),
  'motion capture: turns ZYX, Y up': table(
    motive('ZYX', ['board'], [...turns, ...position]),
    rows(([t, x, y, a], i) => [String(i), t, 0, deg(a), 0, x, 0.15, -y]),
  ),
  'motion capture: two bodies, the first one read': table(
    motive('Quaternion', ['board', 'cart'], [...quaternion, ...position]),
    rows(([t, x, y, a], i) => [String(i), t, 0, half(a)[0], 0, half(a)[1], x, 0.15, -y, ...still]),
  ),
  'six degrees of freedom, two bodies': table(
    qualisys(['board', 'cart']),
    rows(([t, x, y, a], i) => [
      String(i + 1),
      t,
      1000 * x,
      1000 * y,
      150,
      0,
      0,
      deg(a),
      0.4,
      ...[1, 2, 3, 4, 5, 6, 0.3],
    ]),
    '\t',
  ),
  'segments with units and a rate above': table(
    'Segments\n50\n,,board:board,,,,,\nFrame,Sub Frame,RX,RY,RZ,TX,TY,TZ\n,,deg,deg,deg,mm,mm,mm\n',
    rows(([, x, y, a], i) => [String(i + 1), '0', 0, 0, deg(a), 1000 * x, 1000 * y, 80]),
  ),
  'musculoskeletal states': table(
    `states\nversion=1\nnRows=${N}\nnColumns=7\ninDegrees=no\nendheader\ntime\t/jointset/ground/x/value\t/jointset/ground/y/value\t/jointset/ground/theta/value\t/jointset/ground/x/speed\t/jointset/ground/y/speed\t/jointset/ground/theta/speed\n`,
    withRates,
    '\t',
  ),
  'der() of a component': table(
    '"time";"sleigh.x";"sleigh.y";"sleigh.theta";"sleigh.der(x)";"sleigh.der(y)";"sleigh.der(theta)"\n',
    withRates,
    ';',
  ),
  'der() around a component': table(
    '"time","sleigh.x","sleigh.y","sleigh.theta","der(sleigh.x)","der(sleigh.y)","der(sleigh.theta)"\n',
    withRates,
  ),
  'der() and a comma behind the last column': table(
    '"time","x","y","theta","der(x)","der(y)","der(theta)",\n',
    withRates.map((row) => [...row, '']),
  ),
  'd/dt': table('t,x,y,theta,dx/dt,dy/dt,dtheta/dt\n', withRates),
  'dots above': table('t,x,y,θ,ẋ,ẏ,θ̇\n', withRates),
  'speeds after points': table('t,x/value,y/value,theta/value,x/speed,y/speed,theta/speed\n', withRates),
  'rates with units behind underscores': table(
    't,x,y,theta,x_dot_mm/s,y_dot_mm/s,theta_dot_deg/s\n',
    rows((s) => [...s, 1000 * rates(s)[0]!, 1000 * rates(s)[1]!, deg(0.8)]),
  ),
  'functions of time': table('t,x(t),y(t),theta(t)\n', base),
  'functions of time in square brackets': table('t,x[t],y[t],theta[t]\n', base),
  'camel case with units': table(
    'timeMs,posXMm,posYMm,yawDeg\n',
    rows(([t, x, y, a]) => [1000 * t, 1000 * x, 1000 * y, deg(a)]),
  ),
  'Spanish words': comma(
    table(
      'Tiempo (s);Posición x (m);Posición y (m);Guiñada (grados)\n',
      rows(([t, x, y, a]) => [t, x, y, deg(a)]),
      ';',
    ),
  ),
  'Italian words': comma(
    table(
      'Tempo (s);Posizione x (m);Posizione y (m);Imbardata (gradi)\n',
      rows(([t, x, y, a]) => [t, x, y, deg(a)]),
      ';',
    ),
  ),
  'measurement file with an X_Value': table(
    'LabVIEW Measurement\t\nWriter_Version\t2\nSeparator\tTab\nX_Columns\tOne\nDate\t2025/04/17\nTime\t10:30:25.123\n***End_of_Header***\t\n\t\nChannels\t3\t\t\t\nSamples\t101\t101\t101\t\nX_Dimension\tTime\tTime\tTime\t\nDelta_X\t0.02\t0.02\t0.02\t\n***End_of_Header***\t\t\t\t\nX_Value\tx\ty\ttheta\tComment\n',
    base.map((row) => [...row, '']),
    '\t',
  ),
  'measurement file without times, Delta_X above': table(
    'LabVIEW Measurement\t\nX_Columns\tNo\n***End_of_Header***\t\n\t\nChannels\t3\t\t\t\nX_Dimension\tTime\tTime\tTime\t\nDelta_X\t0.02\t0.02\t0.02\t\n***End_of_Header***\t\t\t\t\nX_Value\tx\ty\ttheta\tComment\n',
    base.map((row) => ['', ...row.slice(1), '']),
    '\t',
  ),
  'labels with colons': states.map((s) => `t:${f(s[0])},x:${f(s[1])},y:${f(s[2])},theta:${f(s[3])}`).join('\n'),
  'labels with equals signs': states
    .map((s) => `t = ${f(s[0])}  x = ${f(s[1])}  y = ${f(s[2])}  theta = ${f(s[3])}`)
    .join('\n'),
  'labels in another order in each line': states
    .map((s, i) => {
      const pairs = ['t', 'x', 'y', 'theta'].map((name, k) => `${name}: ${f(s[k]!)}`);
      return [...pairs.slice(i % 4), ...pairs.slice(0, i % 4)].join(', ');
    })
    .join('\n'),
  'a clock and an arrow before each row': [
    '10:30:24.990 -> x,y,theta',
    ...base.map((b) => `10:30:${f(25 + +b[0]!)} -> ${b.slice(1).join(',')}`),
    '',
  ].join('\n'),
  'the same with tabs and their own times': [
    '10:30:24.990 -> t\tx\ty\ttheta',
    ...base.map((b) => `10:30:25.0 -> ${b.join('\t')}`),
    '',
  ].join('\n'),
  'an index of times without a name': table(',x,y,theta\n', base),
  'names between blanks, with units': table(
    '# t [s]  x [mm]  y [mm]  theta [deg]\n',
    rows(([t, x, y, a]) => [t, 1000 * x, 1000 * y, deg(a)]),
    ' ',
  ),
  'names between commas above blanks': table('# t, x, y, theta\n', base, ' '),
  'units in a second comment': table(
    '# Time, x, y, theta\n# s, mm, mm, deg\n',
    rows(([t, x, y, a]) => [t, 1000 * x, 1000 * y, deg(a)]),
  ),
  'sec and nanosec': table(
    'header.stamp.sec,header.stamp.nanosec,header.frame_id,pose.position.x,pose.position.y,theta\n',
    rows(([t, ...o]) => [...stamp(t), 'map', ...o]),
  ),
  'secs and nsecs': table(
    'secs,nsecs,x,y,theta\n',
    rows(([t, ...o]) => [...stamp(t), ...o]),
  ),
  'tv_sec and tv_usec': table(
    'tv_sec,tv_usec,x,y,theta\n',
    rows(([t, ...o]) => [stamp(t)[0], whole(+stamp(t)[1] / 1000), ...o]),
  ),
  "a spreadsheet's days": table(
    'Date,x,y,theta\n',
    rows(([t, ...o]) => [(45764.4375 + t / 86400).toFixed(11), ...o]),
  ),
  'days without a title that says so': table(
    'time,x,y,theta\n',
    rows(([t, ...o]) => [`739000${(0.4375 + t / 86400).toFixed(11).slice(1)}`, ...o]),
  ),
  'hhmmss over a full minute': table(
    'time,x,y,theta\n',
    rows(([t, ...o]) => [t < 1 ? `1030${f(59 + t)}` : `1031${f(t - 1).padStart(9, '0')}`, ...o]),
  ),
  'hhmmss by name, past midnight': table(
    'UTC time,x,y,theta\n',
    rows(([t, ...o]) => [t < 1 ? `2359${f(59 + t)}` : `0000${f(t - 1).padStart(9, '0')}`, ...o]),
  ),
  'scalar first, counted from one': table(
    't,x,y,q1,q2,q3,q4\n',
    rows(([t, x, y, a]) => [t, x, y, half(a)[1], 0, 0, half(a)[0]]),
  ),
  'scalar last, counted from one': table(
    't,x,y,q1,q2,q3,q4\n',
    rows(([t, x, y, a]) => [t, x, y, 0, 0, ...half(a)]),
  ),
  'a name in the same column twice': table(
    't,x,y,theta,x\n',
    base.map((b) => [...b, '9']),
  ),
  'rows of zeros behind the last one': `${table('t,x,y,theta\n', base)}${'\0'.repeat(300)}`,
  'Ctrl-Z behind the last one': `${table('t,x,y,theta\n', base)}\u001a`,
  'single quotes': table("'t','x','y','theta'\n", base),
};

describe('exports', () => {
  test.each(Object.entries(EXPORTS))('%s', (_, text) => expectCircle(motionOf(text)));
});

test('rates are those of the file, not others', () => {
  for (const name of Object.keys(EXPORTS).filter((kind) => /der\(\)|d\/dt|dots|speeds|rates|states/.test(kind))) {
    const motion = motionOf(EXPORTS[name]!);
    for (const [k, column] of ['x_dot', 'y_dot', 'theta_dot'].entries())
      expect(motion.data[motion.columns.indexOf(column)]![70], `${column}, ${name}`).toBeCloseTo(
        rates(states[70]!)[k]!,
        5,
      );
  }
});

describe('several bodies', () => {
  const board = (b: readonly string[]): readonly string[] => b.slice(1);
  const FILES: Record<string, [text: string, bodies: string[]]> = {
    'side by side': [
      table(
        't,cart.x,cart.y,cart.theta,board.x,board.y,board.theta\n',
        base.map((b) => [b[0]!, '5', '5', '1', ...board(b)]),
      ),
      ['cart', 'board'],
    ],
    'with numbers behind the names': [
      table(
        't,x1,y1,theta1,x2,y2,theta2\n',
        base.map((b) => [b[0]!, '5', '5', '1', ...board(b)]),
      ),
      ['1', '2'],
    ],
    'one below another, by name': [
      table(
        't,body,x,y,theta\n',
        base.flatMap((b) => [
          [b[0]!, 'cart', '5', '5', '1'],
          [b[0]!, 'board', ...board(b)],
        ]),
      ),
      ['cart', 'board'],
    ],
    'one below another, by number, one after the other': [
      table('id,t,x,y,theta\n'.replace('id', 'body_id'), [
        ...base.map((b) => ['1', b[0]!, '5', '5', '1']),
        ...base.map((b) => ['2', ...b]),
      ]),
      ['1', '2'],
    ],
    'with times of their own': [
      table(
        'cart,,,,board,,,\nt,x,y,theta,t,x,y,theta\n',
        base.map((b, i) => [f(i / 10), '5', '5', '1', ...b]),
      ),
      ['cart', 'board'],
    ],
    'motion capture': [
      table(
        motive('Quaternion', ['cart', 'board'], [...quaternion, ...position]),
        rows(([t, x, y, a], i) => [String(i), t, ...still, 0, half(a)[0], 0, half(a)[1], x, 0.15, -y]),
      ),
      ['cart', 'board'],
    ],
  };
  test.each(Object.entries(FILES))('%s', (_, [text, bodies]) => {
    const first = motionOf(text);
    expect(first.questions.map((q) => q.id)).toContain('several-bodies');
    expect(first.plan).toMatchObject({ bodies, body: bodies[0] });
    const other = first.questions.find((q) => q.id === 'several-bodies')!.answers[1]!.choices;
    const second = motionOf(text, { choices: other });
    expectCircle(second);
    expect(second.questions.map((q) => q.id)).not.toContain('several-bodies');
  });

  test('columns of a body that is not whole are not mixed with those of one that is', () => {
    expectCircle(
      motionOf(
        table(
          't,cart.x,cart.y,board.x,board.y,board.theta\n',
          base.map((b) => [b[0]!, '5', '5', ...board(b)]),
        ),
      ),
    );
  });
});

test('runs beside each other, named behind each column', () => {
  const text = table(
    ['Run #1', 'Run #2']
      .flatMap((run) => ['Time (s)', 'x (m)', 'y (m)', 'theta (rad)'].map((n) => `${n} ${run}`))
      .join() + '\n',
    base.map((b) => [...b.map((cell) => f(+cell / 2)), ...b]),
  );
  const question = motionOf(text).questions.find((q) => q.id === 'several-bodies')!;
  expect(question.text).toBe('The file holds 2 runs side by side: which one?');
  expectCircle(motionOf(text, { choices: question.answers[1]!.choices }));
});

test('several runs: the first is read, the others can be chosen', () => {
  const text = table('t,x,y,theta\n', [...base, ...base.slice(0, 50), ...base.slice(0, 60)]);
  const first = motionOf(text);
  expectCircle(first);
  expect(first.plan).toMatchObject({ runs: 3, run: 1 });
  const [question] = first.questions;
  expect(question).toMatchObject({ id: 'several-runs', safest: 0 });
  const third = motionOf(text, { choices: question!.answers[2]!.choices });
  expect(third).toMatchObject({ rows: 60, questions: [], plan: { runs: 3, run: 3 } });
});

test('a date that could be either is asked once', () => {
  const text = table(
    'time,x,y,theta\n',
    rows(([t, ...o]) => [t < 1 ? `03/05/2025 23:59:${f(59 + t)}` : `04/05/2025 00:00:0${f(t - 1)}`, ...o]),
  );
  const asked = motionOf(text);
  expectCircle(asked);
  expect(asked.questions.map((q) => q.id)).toEqual(['date-order']);
  for (const { choices } of asked.questions[0]!.answers) expect(motionOf(text, { choices }).questions).toEqual([]);
});

test('every answer of every question says something, and the question is then gone', () => {
  const texts = [
    EXPORTS['scalar last, counted from one']!,
    table('t,x,y,theta\n', [...base, ...base]),
    table(
      't,a.x,a.y,a.theta,b.x,b.y,b.theta\n',
      base.map((b) => [...b, ...b.slice(1)]),
    ),
    table(
      't,x,y,theta\n',
      rows(([t, x, y, a]) => [whole(1000 * t), 1000 * x, 1000 * y, deg(a)]),
    ),
  ];
  const seen = new Set<string>();
  for (const text of texts)
    for (const { id, answers } of motionOf(text).questions)
      for (const { choices } of answers) {
        seen.add(id);
        expect(Object.keys(choices).length, id).toBeGreaterThan(0);
        expect(motionOf(text, { choices }).questions.map((q) => q.id)).not.toContain(id);
      }
  expect([...seen].sort()).toEqual(['degrees', 'scalar', 'several-bodies', 'several-runs', 'time-unit']);
});

test('columns with values at different times are interpolated, each between its own', () => {
  const motion = motionOf(
    table(
      'time,x,y,theta\n',
      states.flatMap(([t, x, y, a], i) => [
        [f(t), f(x), f(y), ''],
        [f(t + 0.01), '', '', i < N - 1 ? f((a + states[i + 1]![3]) / 2) : f(a + 0.008)],
      ]),
    ),
  );
  expect(motion.notes.join()).toContain('different times');
  const [t, x, , theta] = motion.data;
  expect(motion.rows).toBe(2 * N - 2);
  for (let i = 0; i < motion.rows; i++) {
    expect(theta![i]!).toBeCloseTo(0.8 * t![i]!, 5);
    expect(x![i]!).toBeCloseTo(Math.sin(0.8 * t![i]!), 3);
  }
});

describe('JSON', () => {
  const named = states.map(([t, x, y, theta]) => ({ t, x, y, theta }));
  const names = ['t', 'x', 'y', 'theta'] as const;
  const by = (name: (typeof names)[number]): [string, Record<string, number>] => [
    name,
    Object.fromEntries(named.map((record, i) => [i, record[name]])),
  ];
  test.each([
    ['columns by row', Object.fromEntries(names.map(by))],
    ['rows by number', Object.fromEntries(named.map((record, i) => [String(i), record]))],
    ['arrays, the first with the names', [names, ...states]],
    ['a table beside other things', { rate: 50, data: named }],
    [
      'messages with arrays',
      states.map(([t, x, y, a]) => ({ t, position: [x, y, 0], orientation: [0, 0, ...half(a)] })),
    ],
    [
      'messages with stamps',
      states.map(([t, x, y, a]) => ({
        stamp: { sec: +stamp(t)[0], nanosec: +stamp(t)[1] },
        position: { x, y, z: 0 },
        yaw: a,
      })),
    ],
  ])('%s', async (_, value) => {
    const result = await readStream(new Blob([JSON.stringify(value)]).stream(), {
      systems: metas,
      data: true,
      unasked: true,
    });
    if (result.kind !== 'motion') throw new Error(JSON.stringify(result));
    expectCircle(result);
  });
});

test.each([
  ['numbers alone', base.map((b) => b.join(' ')).join('\n'), ['t', 'column 2', 'column 3', 'column 4']],
  [
    'a time and one column',
    table(
      't,height\n',
      base.map((b) => b.slice(0, 2)),
    ),
    ['t', 'height'],
  ],
  [
    'markers',
    table(
      'Trajectories\n100\n,,b:front,,,b:back,,\nFrame,Sub Frame,X,Y,Z,X,Y,Z\n,,mm,mm,mm,mm,mm,mm\n',
      base.map((b, i) => [String(i), '0', ...b.slice(0, 3), ...b.slice(0, 3)]),
    ),
    ['t', 'Sub Frame', ...['front', 'back'].flatMap((m) => [...'XYZ'].map((axis) => `b:${m}.${axis}`))],
  ],
])('data: %s', (_, text, columns) => {
  const motion = motionOf(text);
  expect(motion.systemId).toBeNull();
  expect(motion.columns).toEqual(columns);
});

test.each([
  ['nothing', '', 'there are no rows of numbers'],
  ['a header alone', 't,x,y,theta\n', 'names, and no rows of numbers'],
  ['times alone', 't\n0\n1\n2\n', 'no other column with numbers'],
  ['a letter', 'Hello, world.\nThis is a letter.\nIt has no numbers.\n', 'there are no rows of numbers'],
  [
    'decimal commas between commas',
    table(
      't,x,y,theta\n',
      base.map((b) => b.map(comma)),
    ),
    'write the file with semicolons',
  ],
  ['a thousands comma', table('t,x,y,theta\n', [['0.5', '"1,000"', '0.1', '0.2']]), 'could be 1000 or 1.000'],
])('refused with a reason: %s', (_, text, reason) => {
  const result = readBytes(new TextEncoder().encode(text));
  expect(result.kind).toBe('unusable');
  expect(JSON.stringify(result)).toContain(reason);
});
