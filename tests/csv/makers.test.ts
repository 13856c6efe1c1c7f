// The same motion as makers of loggers, phones, scopes and laboratories' software write it, and as spreadsheets do abroad.
import { describe, expect, test } from 'vitest';
import { base, comma, deg, expectCircle as expectExactly, f, motionOf, N, readBytes, states, table } from './circle.ts';

type State = (typeof states)[number];
const rows = (of: (state: State, i: number) => readonly (string | number)[]): string[][] =>
  states.map((state, i) => of(state, i).map((cell) => (typeof cell === 'number' ? f(cell) : cell)));
const scaled = rows(([t, x, y, a]) => [t, 1000 * x, 1000 * y, deg(a)]);
const micro = rows(([t, x, y, a]) => [t, (1e6 * x).toFixed(1), (1e6 * y).toFixed(1), a]);
const at = (clock: (t: number, i: number) => string): string[][] =>
  states.map(([t], i) => [clock(t, i), ...base[i]!.slice(1)]);
const sec = (t: number, digits = 3): string => t.toFixed(digits).padStart(3 + digits, '0');
/** Three digits a group before the point. */
const grouped = (cell: string, mark: string, point = '.'): string => {
  const [whole, part] = cell.split('.');
  return whole!.replace(/\B(?=(\d{3})+$)/g, mark) + (part === undefined ? '' : point + part);
};
const quoted = (cells: readonly string[]): string[] => cells.map((cell) => `"${cell}"`);
const half = (angle: number): [number, number] => [Math.sin(angle / 2), Math.cos(angle / 2)];

const MAKERS: Record<string, string> = {
  // Units in a row
  'race logger: quoted, units under the names, empty lines': table(
    '"Format","Race CSV File",,\n"Venue","Yard",,\n"Sample Rate","50.000",,\n\n\n"Time","x","y","theta"\n"s","mm","mm","deg"\n\n\n',
    scaled.map(quoted),
  ),
  'oscilloscope: units in brackets, an empty line': table(
    'Time,x,y,theta\n(ms),(mm),(mm),(°)\n\n',
    rows(([t, x, y, a]) => [1000 * t, 1000 * x, 1000 * y, deg(a)]),
  ),
  'words for units': table('time\tx\ty\ttheta\nseconds\tmillimeters\tmillimetres\tdegrees\n', scaled, '\t'),
  'units above the names': table('s;mm;mm;deg\nt;x;y;theta\n', scaled, ';'),
  'names, units, a line of remarks': table('t;x;y;theta\ns;mm;mm;°\nclock;front;front;heading\n', scaled, ';'),
  'two lines of names and one of units': table(
    ',Position,Position,Orientation\nTime,X,Y,Yaw\n[s],[mm],[mm],[deg]\n',
    scaled,
  ),
  'units named by their key': table(
    'Name;t;x;y;theta\nUnit;s;mm;mm;deg\n',
    scaled.map((r) => ['', ...r]),
    ';',
  ),
  // Spreadsheets
  'German: dots of thousands': table(
    'Zeit [s];x [µm];y [µm];theta [rad]\n',
    micro.map((r) => r.map((c) => grouped(c, '.', ','))),
    ';',
  ),
  'English: commas of thousands in quotes': table(
    't,x (um),y (um),theta\n',
    micro.map((r) => quoted(r.map((c) => grouped(c, ',')))),
  ),
  'Swiss: apostrophes of thousands': table(
    't;x (um);y (um);theta\n',
    micro.map((r) => r.map((c) => grouped(c, "'"))),
    ';',
  ),
  'Swiss: typographic apostrophes of thousands': table(
    't;x (um);y (um);theta\n',
    micro.map((r) => r.map((c) => grouped(c, '’'))),
    ';',
  ),
  'French: narrow blanks of thousands': table(
    'Temps (s);x (µm);y (µm);theta (rad)\n',
    micro.map((r) => r.map((c) => grouped(c, '\u202f', ','))),
    ';',
  ),
  'Czech: blanks of thousands': table(
    'Čas (s)\tx (µm)\ty (µm)\ttheta (rad)\n',
    micro.map((r) => r.map((c) => grouped(c, '\u00a0', ','))),
    '\t',
  ),
  'plain blanks of thousands': table(
    't;x (um);y (um);theta\n',
    micro.map((r) => r.map((c) => grouped(c, ' '))),
    ';',
  ),
  'Indian groups': table(
    't;x (um);y (um);theta\n',
    micro.map((r) => r.map((c) => c.replace(/^(\d)(\d\d)(\d{3})\./, '$1,$2,$3.'))),
    ';',
  ),
  'numbers as formulas of text': table(
    't,x,y,theta\n',
    base.map((r) => r.map((c) => `="${c}"`)),
  ),
  'an apostrophe before each number': table(
    't;x;y;theta\n',
    base.map((r) => r.map((c) => `'${c}`)),
    ';',
  ),
  'a plus before each number': table(
    't;x;y;theta\n',
    base.map((r) => r.map((c) => (c.startsWith('-') ? c : `+${c}`))),
    ';',
  ),
  Dutch: comma(
    table(
      'Tijd (s);Positie x (m);Positie y (m);Gierhoek (graden)\n',
      rows(([t, x, y, a]) => [t, x, y, deg(a)]),
      ';',
    ),
  ),
  Portuguese: comma(
    table(
      'Tempo (s);Posição x (m);Posição y (m);Guinada (graus)\n',
      rows(([t, x, y, a]) => [t, x, y, deg(a)]),
      ';',
    ),
  ),
  Polish: comma(
    table(
      'Czas [s];Położenie x [m];Położenie y [m];Odchylenie [stopnie]\n',
      rows(([t, x, y, a]) => [t, x, y, deg(a)]),
      ';',
    ),
  ),
  Swedish: comma(
    table(
      'Tid (s);Läge x (m);Läge y (m);Gir (grader)\n',
      rows(([t, x, y, a]) => [t, x, y, deg(a)]),
      ';',
    ),
  ),
  'German words': comma(table('Messzeit (s);X-Position (mm);Y-Position (mm);Gierwinkel (°)\n', scaled, ';')),
  'French words': comma(table('Temps écoulé (s);Position X (mm);Position Y (mm);Angle de lacet (°)\n', scaled, ';')),
  'Japanese time': table('時間(s),x(m),y(m),theta(rad)\n', base),
  'Chinese time': table('时间(秒),x(米),y(米),theta(弧度)\n', base),
  Russian: comma(
    table(
      'Время (с);x (м);y (м);Рыскание (град)\n',
      rows(([t, x, y, a]) => [t, x, y, deg(a)]),
      ';',
    ),
  ),
  // Phones
  'phone: Zeit in seconds, quotes and commas': comma(
    table(
      '"Zeit (s)";"x (m)";"y (m)";"theta (rad)"\n',
      rows((s) => s.map((x) => x.toExponential(9))),
      ';',
    ),
  ),
  'phone: time, seconds_elapsed': table(
    'time,seconds_elapsed,yaw,x,y\n',
    states.map(([t, x, y, a]) => [
      String(1744909208n * 1000000000n + BigInt(Math.round(1e9 * t))),
      f(t),
      f(a),
      f(x),
      f(y),
    ]),
  ),
  'phone: since reboot': table(
    'loggingTime(txt),timestamp_sinceReboot(s),x(m),y(m),yaw(rad)\n',
    states.map(([t, x, y, a]) => [`2025-04-17 10:30:${sec(20 + t)} +0200`, f(88211.25 + t), f(x), f(y), f(a)]),
  ),
  // Motion capture
  'OpenSim, older header': table(
    `name board.mot\ndatacolumns 4\ndatarows ${N}\nrange 0 2\nendheader\ntime x y theta\n`,
    base,
    ' ',
  ),
  'OpenSim storage in degrees': table(
    `Coordinates\nversion=1\nnRows=${N}\nnColumns=4\ninDegrees=yes\n\nUnits are S.I. units (second, meters, Newtons, ...)\nIf the header above contains a line with 'inDegrees', this indicates whether rotational values are in degrees (yes) or radians (no).\n\nendheader\ntime\tx\ty\ttheta\n`,
    rows(([t, x, y, a]) => [t, x, y, deg(a)]),
    '\t',
  ),
  'six degrees of freedom with a time stamp above': table(
    `NO_OF_FRAMES\t${N}\nNO_OF_CAMERAS\t12\nNO_OF_BODIES\t1\nFREQUENCY\t50\nNO_OF_ANALOG\t0\nANALOG_FREQUENCY\t0\nDESCRIPTION\t--\nTIME_STAMP\t2025-04-17, 10:30:25.123\t88211.25\nDATA_INCLUDED\t6D\nBODY_NAMES\tboard\n\tX\tY\tZ\tRoll\tPitch\tYaw\tResidual\tRot[0]\tRot[1]\n`,
    rows(([, x, y, a]) => ['', 1000 * x, 1000 * y, 150, 0, 0, deg(a), 0.4, 1, 0]),
    '\t',
  ),
  'inertial suit: preamble and packets': table(
    'DeviceId: 00B42D\nUpdate Rate: 50.0Hz\nFilter Profile: human\nOption Flags: AHS\n\nPacketCounter\tSampleTimeFine\tQuat_W\tQuat_X\tQuat_Y\tQuat_Z\tx\ty\n',
    rows(([t, x, y, a], i) => [String(i + 9), String(Math.round(4e6 + 10000 * t)), half(a)[1], 0, 0, half(a)[0], x, y]),
    '\t',
  ),
  // Robots
  'echoed topic': table(
    '%time,field.header.seq,field.header.stamp,field.header.frame_id,field.pose.pose.position.x,field.pose.pose.position.y,field.pose.pose.position.z,field.pose.pose.orientation.x,field.pose.pose.orientation.y,field.pose.pose.orientation.z,field.pose.pose.orientation.w\n',
    states.map(([t, x, y, a], i) => [
      `1744909208${String(Math.round(1e9 * (t % 1)) % 1e9).padStart(9, '0')}`.replace(
        /^1744909208/,
        String(1744909208 + Math.floor(t + 1e-9)),
      ),
      String(i),
      `1744909208${String(i).padStart(9, '0')}`,
      'odom',
      f(x),
      f(y),
      '0.0',
      '0.0',
      '0.0',
      f(half(a)[0]),
      f(half(a)[1]),
    ]),
  ),
  'plotted topics': table(
    '__time,/odom/pose/pose/position/x,/odom/pose/pose/position/y,/odom/pose/pose/orientation/yaw\n',
    states.map(([t, x, y, a]) => [(1744909208 + t).toFixed(6), f(x), f(y), f(a)]),
  ),
  'Python class of a pose': table(
    'rosbagTimestamp,secs,nsecs,x,y,theta\n',
    states.map(([t, x, y, a]) => [
      String(1744909208 + Math.floor(t)) + String(Math.round(1e9 * (t % 1)) % 1e9).padStart(9, '0'),
      String(1744909208 + Math.floor(t + 1e-9)),
      String(Math.round(1e9 * (t - Math.floor(t + 1e-9)))),
      f(x),
      f(y),
      f(a),
    ]),
  ),
  'flight log': table(
    'TimeUS,PX,PY,Yaw\n'.replace('PX,PY', 'x,y'),
    rows(([t, x, y, a]) => [String(88211250000 + Math.round(1e6 * t)), x, y, a]),
  ),
  // Laboratories
  'circuit simulator': table(
    'time\tx\ty\ttheta\n',
    rows((s) => s.map((x) => x.toExponential(15).replace(/e([+-])(\d)$/, 'e$10$2'))),
    '\t',
  ),
  'gnuplot: comment with names, blank lines behind': `${table('# t x y theta\n', base, ' ')}\n\n`,
  'gnuplot: numbered names': table('#1:t 2:x 3:y 4:theta\n', base, ' '),
  'data manager: names, units, types': table(
    'Time;x;y;theta\ns;mm;mm;°\n',
    comma(table('', scaled, ';'))
      .trim()
      .split('\n')
      .map((l) => l.split(';')),
    ';',
  ),
  'computer algebra: *^ exponents': table(
    't,x,y,theta\n',
    rows((s) => s.map((x) => x.toExponential(9).replace('e', '*^').replace('+', ''))),
  ),
  'Fortran without an E': table(
    't x y theta\n',
    rows((s) =>
      s.map((x) =>
        x !== 0 && Math.abs(x) < 1
          ? (x * 1e120).toExponential(9).replace(/e[+].*/, `E${Math.floor(Math.log10(Math.abs(x)))}`)
          : f(x),
      ),
    ),
    ' ',
  ),
  'measured by video': table('mass A\t\t\t\nt\tx\ty\tθ\n', base, '\t'),
  'school logger: run before each name': table(
    'Latest: Time (s),Latest: x (m),Latest: y (m),Latest: theta (rad)\n',
    base,
  ),
  'school logger: run behind each name': table('Time (s) Run #1,x (m) Run #1,y (m) Run #1,theta (rad) Run #1\n', base),
  'scope: key and value beside the table': table(
    'Model,X100,,\nHorizontal Units,s,,\nSample Interval,0.02,,\nRecord Length,101,,\nTIME,x,y,theta\n',
    base,
  ),
  'units in the cells': table(
    't,x,y,theta\n',
    base.map(([t, x, y, a]) => [`${t} s`, `${x} m`, `${y} m`, `${a} rad`]),
  ),
  'millimetres and degrees in the cells': table(
    't;x;y;theta\n',
    scaled.map(([t, x, y, a]) => [`${t} s`, `${x} mm`, `${y} mm`, `${a}°`]),
    ';',
  ),
  'MATLAB timetable': table(
    'Time,x,y,theta\n',
    base.map(([t, ...o]) => [`${t} sec`, ...o]),
  ),
  'comma and blank': table('t, x, y, theta\n', base, ', '),
  'blanks around semicolons': table('t ; x ; y ; theta\n', base, ' ; '),
  'table of a text document': table(
    '| t | x | y | theta |\n|---|---|---|---|\n',
    base.map((r) => [`| ${r.join(' | ')} |`]),
  ),
  'C array': table(
    '{',
    base.map((r) => [`{${r.join(', ')}},`]),
  ).replace('{{', 't,x,y,theta\n{'),
  influx: table(
    '#group,false,false,true,false,true\n#datatype,string,long,dateTime:RFC3339,double,string\n#default,_result,,,,\n,result,table,_time,_value,_field\n',
    ['x', 'y', 'theta'].flatMap((name, k) =>
      base.map((b) => ['', '', String(k), `2025-04-17T10:30:${sec(20 + +b[0]!)}Z`, b[k + 1]!, name]),
    ),
  ),
  'dashboard: series, time, value': table(
    '"Series";"Time";"Value"\n',
    ['x', 'y', 'theta'].flatMap((name, k) =>
      base.map((b) => [name, `2025-04-17 10:30:${sec(20 + +b[0]!)}`, b[k + 1]!]),
    ),
    ';',
  ),
  // Times
  'compact ISO': table(
    'timestamp,x,y,theta\n',
    at((t) => `20250417T1030${sec(20 + t)}Z`),
  ),
  'ISO with a comma': table(
    'timestamp;x;y;theta\n',
    at((t) => `2025-04-17 10:30:${sec(20 + t).replace('.', ',')}`),
    ';',
  ),
  'a zone behind a blank': table(
    'timestamp,x,y,theta\n',
    at((t) => `2025-04-17 10:30:${sec(20 + t)} +0200`),
  ),
  'a zone by name': table(
    'timestamp,x,y,theta\n',
    at((t) => `2025-04-17 10:30:${sec(20 + t)} UTC`),
  ),
  'month by name': table(
    'Time,x,y,theta\n',
    at((t) => `17-Apr-2025 10:30:${sec(20 + t)}`),
  ),
  'month by name, American': table(
    'Time,x,y,theta\n',
    at((t) => `"Apr 17, 2025 10:30:${sec(20 + t)} AM"`),
  ),
  'day of the week': table(
    'Time,x,y,theta\n',
    at((t) => `Thu Apr 17 10:30:${sec(20 + t)} 2025`),
  ),
  'American day and clock': table(
    'Timestamp,x,y,theta\n',
    at((t) => `4/17/2025 10:30:${sec(20 + t)} AM`),
  ),
  'slashes and a hyphen': table(
    'Timestamp,x,y,theta\n',
    at((t) => `2025/04/17-10:30:${sec(20 + t)}`),
  ),
  underscores: table(
    'Timestamp,x,y,theta\n',
    at((t) => `2025-04-17_10-30-${sec(20 + t)}`),
  ),
  'milliseconds behind a colon': table(
    'Time,x,y,theta\n',
    at((t) => `10:30:${sec(20 + t).replace('.', ':')}`),
  ),
  'minutes and seconds': table(
    'Time,x,y,theta\n',
    at((t) => `12:${sec(20 + t)}`),
  ),
  'pandas durations': table(
    ',x,y,theta\n',
    at((t) => `0 days 00:00:${sec(t, 6)}`),
  ),
  'durations in full': table(
    'time,x,y,theta\n',
    at((t) => `P0DT0H0M${t.toFixed(2)}S`),
  ),
  'hours, minutes, seconds in letters': table(
    'time,x,y,theta\n',
    at((t) => `10h30m${(20 + t).toFixed(2)}s`),
  ),
  'date, clock and milliseconds apart': table(
    'Date,Time,ms,x,y,theta\n',
    states.map(([t], i) => [
      '17.04.2025',
      `10:30:${String(20 + Math.floor(t + 1e-9))}`,
      String(Math.round(1000 * (t - Math.floor(t + 1e-9)))),
      ...base[i]!.slice(1),
    ]),
  ),
  'a column each': table(
    'year,month,day,hour,minute,second,x,y,theta\n',
    states.map(([t], i) => ['2025', '4', '17', '10', '30', (20 + t).toFixed(3), ...base[i]!.slice(1)]),
  ),
  'hours, minutes, seconds apart': table(
    'hour,min,sec,x,y,theta\n',
    states.map(([t], i) => ['10', t < 1 ? '59' : '60', t < 1 ? sec(59 + t) : sec(t - 1), ...base[i]!.slice(1)]),
  ).replaceAll('\n10,60,', '\n11,0,'),
  'time since start': table('Time since start [s],x,y,theta\n', base),
  'relative time': table('Relative Time (s),x,y,theta\n', base),
  'relative and absolute': table(
    'Absolute Time,Relative Time,x,y,theta\n',
    base.map((b) => [`2025-04-17 10:30:${sec(20 + +b[0]!)}`, ...b]),
  ),
  'frame counted from 0, time beside': table(
    'Frame#,Time(s),x,y,theta\n',
    base.map((b, i) => [String(i), ...b]),
  ),
  'epoch with a decimal comma': comma(
    table(
      'Zeitstempel;x;y;theta\n',
      at((t) => (1744909208 + t).toFixed(3)),
      ';',
    ),
  ),
  'epoch in exponents': table(
    'timestamp,x,y,theta\n',
    at((t) => (1744909208 + t).toExponential(15)),
  ),
  'epoch ms with decimals': table(
    't_ms,x,y,theta\n',
    at((t) => (1744909208000 + 1000 * t).toFixed(3)),
  ),
  'descending clock': table('Time,x,y,theta\n', at((t) => `10:30:${sec(20 + t)}`).reverse()),
  'shuffled date-times': table(
    'Time,x,y,theta\n',
    states
      .map((_, i) => (i * 37) % N)
      .map((i) => [`2025-04-17 10:30:${sec(20 + states[i]![0])}`, ...base[i]!.slice(1)]),
  ),
  // Rates, attitudes
  'twist names': table(
    't,x,y,yaw,linear_velocity.x,linear_velocity.y,yaw_rate\n',
    rows(([t, x, y, a]) => [t, x, y, a, 0.8 * Math.cos(a), 0.8 * Math.sin(a), 0.8]),
  ),
  'speeds in words': table(
    't,x,y,theta,x velocity (mm/s),y velocity (mm/s),yaw rate (deg/s)\n',
    rows(([t, x, y, a]) => [t, x, y, a, 800 * Math.cos(a), 800 * Math.sin(a), deg(0.8)]),
  ),
  'German speeds': comma(
    table(
      't;x;y;theta;Geschwindigkeit x (mm/s);Geschwindigkeit y (mm/s);Gierrate (°/s)\n',
      rows(([t, x, y, a]) => [t, x, y, a, 800 * Math.cos(a), 800 * Math.sin(a), deg(0.8)]),
      ';',
    ),
  ),
  'quaternion by letters before': table(
    't,x,y,q_w,q_x,q_y,q_z\n',
    rows(([t, x, y, a]) => [t, x, y, half(a)[1], 0, 0, half(a)[0]]),
  ),
  'quaternion in words': table(
    't,Position X,Position Y,Orientation W,Orientation X,Orientation Y,Orientation Z\n',
    rows(([t, x, y, a]) => [t, x, y, half(a)[1], 0, 0, half(a)[0]]),
  ),
  'quaternion rot.w': table(
    't,pos.x,pos.y,rot.x,rot.y,rot.z,rot.w\n',
    rows(([t, x, y, a]) => [t, x, y, 0, 0, ...half(a)]),
  ),
  'Euler angles by axes': table(
    't,Position X (mm),Position Y (mm),Rotation X (deg),Rotation Y (deg),Rotation Z (deg)\n',
    rows(([t, x, y, a]) => [t, 1000 * x, 1000 * y, 0, 0, deg(a)]),
  ),
  'tracked by cameras': table(
    'timestamp,id,tx,ty,tz,qx,qy,qz,qw\n',
    rows(([t, x, y, a]) => [1744909208 + t, '3', x, y, 0, 0, 0, ...half(a)]),
  ),
  'trajectory of TUM': table(
    '# timestamp tx ty tz qx qy qz qw\n',
    rows(([t, x, y, a]) => [1744909208 + t, x, y, 0, 0, 0, ...half(a)]),
    ' ',
  ),
};

/** Clocks of machines begin anywhere. */
function expectCircle(motion: ReturnType<typeof motionOf>): void {
  const [t] = motion.data;
  expectExactly({ ...motion, data: [t!.map((s) => s - t![0]!), ...motion.data.slice(1)] });
}

describe('makers', () => {
  test.each(Object.entries(MAKERS))('%s', (_, text) => expectCircle(motionOf(text)));
});

test.each(['#¡VALOR!', '#¿NOMBRE?', '#DĚLENÍ_NULOU!', '#VIITTAUS!', '#DEĞER!', '#SAKNAS!', '#ZÉRÓOSZTÓ!', '#YOK'])(
  'a row that begins with %s is left out by name, and no comment',
  (error) => {
    const motion = motionOf(
      table(
        'x;y;theta;t\n',
        base.map(([t, ...rest], i) => [i === 3 ? error : rest[0]!, ...rest.slice(1), t!]),
        ';',
      ),
    );
    expect(motion).toMatchObject({ rows: N - 1, skippedRows: 1, issues: [{ line: 5, column: 'x' }] });
  },
);

test('a comma of thousands without quotes is refused by name, not taken for a name of the row', () => {
  const result = readBytes(
    new TextEncoder().encode(
      table(
        't,x,y,theta\n',
        base.map(([t, , y, a]) => [t!, '1,234.5', y!, a!]),
      ),
    ),
  );
  expect(JSON.stringify(result)).toContain('thousands between commas? write the numbers without them');
});

test('names in two lines, the axes below', () => {
  const motion = motionOf(
    table(
      'PathFileType\t4\t(X/Y/Z)\tboard.trc\nDataRate\tNumFrames\tUnits\n50.00\t101\tmm\nFrame#\tTime\tfront\t\t\n\t\tX1\tY1\tZ1\n\n',
      base.map(([t, x, y], i) => [String(i + 1), t!, x!, '80', y!]),
      '\t',
    ),
  );
  expect(motion).toMatchObject({ systemId: null, rows: N, plan: { time: { form: 'number' } } });
  expect(motion.data[0]![50]).toBeCloseTo(1, 9);
});

test('times that are all the same are said to be', () => {
  const motion = motionOf(
    table(
      'timestamp,x,y,theta\n',
      base.map(([, ...rest]) => ['1.74491E+12', ...rest]),
    ),
  );
  expect(motion.rows).toBe(N);
  expect(motion.data[0]![60]).toBeCloseTo(1, 9);
  expect(motion.notes.join()).toContain('all times are the same');
});

test('a Spanish clock', () => {
  expectCircle(
    motionOf(
      table(
        'Hora;x;y;theta\n',
        at((t) => `10:30:${sec(20 + t)} a. m.`),
        ';',
      ),
    ),
  );
});
