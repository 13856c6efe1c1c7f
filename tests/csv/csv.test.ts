import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { CsvReader, readCsv, writeCsv, type CsvResult } from '../../src/csv/csv.ts';
import type { SystemMeta } from '../../src/core/model/system.ts';
import { metas } from '../helpers.ts';

const meta = metas.ripstik!;
const names = meta.coordinates.map((q) => q.name);
const velocities = names.map((name) => `${name}_dot`);

const read = (text: string, timeStep?: number): CsvResult =>
  readCsv(text, { systems: metas, ...(timeStep === undefined ? {} : { timeStep }) });
function motion(text: string, timeStep?: number) {
  const result = read(text, timeStep);
  if (result.kind !== 'motion') throw new Error(JSON.stringify(result));
  return result;
}
const columnOf = (result: ReturnType<typeof motion>, name: string) => [...result.data[result.columns.indexOf(name)]!];
/** A file of three rows whose cell is 10 row + column. */
const table = (titles: readonly string[], separator = ',', end = '\n') =>
  [
    titles.join(separator),
    ...[0, 1, 2].map((row) => titles.map((_, column) => 10 * row + column).join(separator)),
  ].join(end) + end;
const plain = table(['t', ...names]);

const bits = ({ buffer, byteOffset, length }: Float64Array) =>
  new BigUint64Array(buffer as ArrayBuffer, byteOffset, length);

/** Any finite double, by its bits: subnormals, huge ones, -0. */
const double = fc.double({ noNaN: true, noDefaultInfinity: true });

describe('round trip', () => {
  test('is exact to the last bit', () => {
    fc.assert(
      fc.property(
        fc.array(fc.tuple(...[...names, ...velocities].map(() => double)), { minLength: 1, maxLength: 20 }),
        (rows) => {
          const columns = ['t', ...names, ...velocities];
          const data = columns.map((_, c) => Float64Array.from(rows, (row, r) => (c === 0 ? r / 3 : row[c - 1]!)));
          const back = motion(
            writeCsv(columns, data, [
              `scenario: ${JSON.stringify({ version: 1, system: 'ripstik', initial: { X_dot: 1 } })}`,
            ]),
          );
          expect(back.columns).toEqual(columns);
          expect(back.issues).toEqual([]);
          expect(back.scenario).toEqual({ version: 1, system: 'ripstik', initial: { X_dot: 1 } });
          for (let c = 0; c < columns.length; c++) {
            expect(bits(back.data[c]!)).toEqual(bits(data[c]!));
          }
        },
      ),
    );
  });

  test('numbers are decimals of 17 significant digits', () => {
    const text = writeCsv(['t', 'X'], [new Float64Array([0, 0.1, 0.5]), new Float64Array([1 / 3, -1.5e-300, -0])]);
    expect(text).toBe('t,X\n0,0.33333333333333331\n0.10000000000000001,-1.5000000000000001e-300\n0.5,-0\n');
  });

  test('what is unknown is an empty cell, and comes back as a gap', () => {
    const columns = ['t', ...names, 'lambda_1'];
    const data = columns.map((name) => Float64Array.of(0, name === 'lambda_1' ? NaN : 1));
    const back = motion(writeCsv(columns, data));
    expect(columnOf(back, 'lambda_1')).toEqual([0, NaN]);
    expect(back.issues).toEqual([]);
  });

  test('a comment stays a comment', () => {
    expect(writeCsv(['t'], [Float64Array.of(0)], ['a\r\nb\n7'])).toBe('t\n0\n# a b 7\n');
  });
});

describe('one motion, many spellings', () => {
  const expected = motion(plain).data;
  for (const separator of [',', ';', '\t']) {
    for (const [label, end] of [
      ['LF', '\n'],
      ['CRLF', '\r\n'],
      ['CR', '\r'],
    ] as const) {
      test.each([
        ['', 'plain'],
        ['\ufeff', 'BOM'],
      ])(`separator ${JSON.stringify(separator)}, ${label}, %j %s`, (bom) => {
        const text = table(['t', ...names], separator, end);
        expect(motion(bom + text).data).toEqual(expected);
        expect(motion(`${bom}# remark "quoted", 5" wide${end}${end}${text}${end}# end${end}`).data).toEqual(expected);
        expect(motion(text.slice(0, -end.length)).data).toEqual(expected);
      });
    }
  }

  test('mixed line ends, quotes, trailing separators, remarks', () => {
    const lines = plain.trimEnd().split('\n');
    expect(motion(`${lines[0]}\r\n${lines[1]}\n${lines[2]}\r${lines[3]}`).data).toEqual(expected);
    expect(motion(plain.replace(/[^,\n]+/g, '"$&"')).data).toEqual(expected);
    expect(motion(plain.replace(/\n/g, ',\n')).data).toEqual(expected);
    expect(motion(lines.map((l, i) => (i === 2 ? `${l} # a, b` : l)).join('\n')).data).toEqual(expected);
    expect(motion(`# ${plain}`).data).toEqual(expected);
  });

  test.each([1, 7, 100])('in pieces of %i characters', (size) => {
    const text = `\ufeff# scenario: {"version":1}\r\n${plain.replace(/\n/g, '\r\n')}`;
    const reader = new CsvReader({ systems: metas });
    for (let at = 0; at < text.length; at += size) reader.push(text.slice(at, at + size));
    const result = reader.finish();
    expect(result).toMatchObject({ kind: 'motion', rows: 3, scenario: { version: 1 } });
    expect(result.kind === 'motion' && result.data).toEqual(expected);
  });

  test('any order and case of names', () => {
    const titles = [
      'ALPHA_FP',
      'alphaBp',
      'x',
      'y',
      'z',
      'Alpha',
      'ψ',
      'theta',
      'theta-fc',
      'THETA BC',
      'Time',
      'x_dot',
      'Lambda 1',
      'note',
    ];
    const result = motion(table(titles));
    expect(result.columns).toEqual(['t', ...names, 'X_dot', 'lambda_1']);
    expect(columnOf(result, 'alpha_fp')).toEqual([0, 10, 20]);
    expect(columnOf(result, 't')).toEqual([10, 20, 30]);
    expect(columnOf(result, 'lambda_1')).toEqual([12, 22, 32]);
    expect(result.notes.join()).toContain('not used: note');
  });

  test('decimal commas between semicolons', () => {
    const result = motion(`${['t', ...names].join(';')}\n${'0,5;'.repeat(10)}1,5e1\n${'1,5;'.repeat(10)}2\n`);
    expect(columnOf(result, 't')).toEqual([0.5, 1.5]);
    expect(columnOf(result, 'theta_bc')).toEqual([15, 2]);
    const mixed = motion(`${['t', ...names].join(';')}\n${'0.5;'.repeat(10)}1.5\n${'1;'.repeat(10)}2,5\n`);
    expect(mixed.issues).toMatchObject([
      { line: 3, column: 'theta_bc', message: '"2,5" has a comma where the file has decimal points' },
    ]);
  });
});

describe('units', () => {
  test.each([
    ['alpha', 'alpha [deg]', Math.PI / 180],
    ['theta_fc', 'theta_fc (°)', Math.PI / 180],
    ['X', 'X [mm]', 1e-3],
    ['Y', 'y [ cm ]', 1e-2],
    ['Z', 'Z (km)', 1e3],
    ['t', 'time [ms]', 1e-3],
    ['t', 'Time (s)', 1],
    ['psi', 'psi / deg', Math.PI / 180],
    ['theta', 'theta_deg', Math.PI / 180],
    ['alpha_dot', 'alpha_dot [deg/s]', Math.PI / 180],
    ['theta_fc_dot', 'theta_fc_dot [rpm]', Math.PI / 30],
    ['X_dot', 'X_dot [km/h]', 1 / 3.6],
    ['X_dot', 'X_dot [mm s^-1]', 1e-3],
  ])('%s from "%s"', (name, title, factor) => {
    const all = ['t', ...names, ...velocities];
    const result = motion(table(all.map((n) => (n === name ? title : n))));
    const index = all.indexOf(name);
    columnOf(result, name).forEach((value, row) => expect(value).toBeCloseTo((10 * row + index) * factor, 12));
  });

  test('a unit of another kind is refused by name', () => {
    expect(read(table(['t', ...names]).replace('alpha,', 'alpha [mm],'))).toMatchObject({
      kind: 'unusable',
      issues: [
        { line: 1, message: expect.stringContaining('"mm" is not understood for alpha; right would be rad, deg') },
      ],
    });
  });
});

describe('files without a header', () => {
  const row = (count: number, value: number) => Array<number>(count).fill(value).join(',');
  const file = (count: number) => [0, 1, 2].map((v) => row(count, v)).join('\n');

  test('10 columns: the time step is asked for, then counted', () => {
    expect(read(file(10))).toEqual({ kind: 'needs-time-step', offeredStep: 1 / 60, columns: 10 });
    expect(columnOf(motion(file(10), 0.5), 't')).toEqual([0, 0.5, 1]);
    expect(columnOf(motion(`${row(10, 0)}\nx${row(10, 1)}\n${row(10, 2)}`, 0.5), 't')).toEqual([0, 1]);
  });

  test('11 columns: time first', () => {
    expect(columnOf(motion(file(11)), 't')).toEqual([0, 1, 2]);
  });

  test('a header without a time also needs a step', () => {
    expect(read(table(names))).toMatchObject({ kind: 'needs-time-step', columns: 10 });
  });

  test('other counts are no board', () => {
    expect(read(file(9))).toMatchObject({
      kind: 'unusable',
      issues: [{ line: 1, message: expect.stringContaining('9 columns') }],
    });
    expect(read(file(10), -1).kind).toBe('unusable');
  });
});

describe('rows that cannot be used', () => {
  const header = ['t', ...names].join(',');
  const good = (t: number) => `${t}${',1'.repeat(10)}`;

  test.each([
    ['abc', 'X', '"abc" is not a number'],
    ['', 'X', 'the cell is empty'],
    ['  ', 'X', 'the cell is empty'],
    ['inf', 'X', '"inf" is not a finite number'],
    ['1e999', 'X', '"1e999" is not a finite number'],
    ['0x10', 'X', '"0x10" is not a number'],
    ['NaN', 'X', '"NaN" is not a number'],
  ])('cell %j', (cell, column, message) => {
    const result = motion(`# first\n${header}\n${good(0)}\n1,${cell}${',1'.repeat(9)}\n\n${good(2)}\n`);
    expect(result).toMatchObject({ rows: 2, skippedRows: 1, issues: [{ line: 4, column, message }] });
    expect(columnOf(result, 't')).toEqual([0, 2]);
  });

  test('missing and surplus cells, empty rows', () => {
    const result = motion(`${header}\n${good(0)}\n1,1,1\n${good(2)},7\n${','.repeat(10)}\n${good(4)}`);
    expect(result.issues).toMatchObject([
      { line: 3, column: 'Z', message: 'the cell is missing: the row has 3 of 11' },
      { line: 4, column: '12' },
      { line: 5, column: '', message: 'the row is empty' },
    ]);
    expect(result.rows).toBe(2);
  });

  test('time that does not increase; one time out of place costs one row', () => {
    const times = (list: number[]) => motion(`${header}\n${list.map(good).join('\n')}`);
    expect(columnOf(times([0, 1, 1, 0.5, 2]), 't')).toEqual([0, 1, 2]);
    expect(times([0, 1, 1, 0.5, 2]).issues.map((i) => i.line)).toEqual([4, 5]);
    expect(columnOf(times([0, 1, 1e9, 2, 3]), 't')).toEqual([0, 1, 2, 3]);
    expect(times([0, 1, 1e9, 2, 3]).issues).toMatchObject([{ line: 4, column: 't' }]);
    // Two runs one after the other, not one with rows out of place.
    expect(columnOf(times([0, 1, 2, 0, 1, 2, 3]), 't')).toEqual([0, 1, 2]);
  });

  test('lines are counted in every kind of line end and over quoted cells', () => {
    const text = `"t","X\n[m]",${names.slice(1).join(',')}\r\n${good(0)}\r# c\r\n${good(1).replace('1,', 'x,')}\n${good(2)}`;
    expect(motion(text).issues).toMatchObject([{ line: 5, column: 't' }]);
  });

  test('a stray quote costs its own row', () => {
    const result = motion(`${header}\n${good(0)}\n1,"1${',1'.repeat(9)}\n${good(2)}\n${good(3)}`);
    expect(columnOf(result, 't')).toEqual([0, 2, 3]);
  });

  test('the list is capped and counted', () => {
    const result = motion(`${header}\n${good(0)}\n${Array.from({ length: 1500 }, (_, i) => `x${i}\n`).join('')}`);
    expect(result.skippedRows).toBe(1500);
    expect(result.issues).toHaveLength(1001);
    expect(result.issues.at(-1)).toEqual({ line: 0, column: '', message: 'and 500 more' });
    expect(result.notes.join()).toContain('still picture');
  });

  test.each([
    ['', 0],
    ['\n\n', 0],
    ['# only\n', 0],
    ['PK\u0003\u0004\0\0', 0],
    [`${header}\n`, 0],
    ['a,b\n1,2', 1],
  ])('%j is unusable', (text, line) => {
    expect(read(text)).toMatchObject({ kind: 'unusable', issues: [{ line }] });
  });

  test('nothing throws', () => {
    const piece = fc.constantFrom(
      't',
      ...names,
      '1',
      '-2.5',
      ',',
      ';',
      '\t',
      '\n',
      '\r',
      '"',
      '#',
      '\ufeff',
      'x',
      ' ',
      '__proto__',
    );
    fc.assert(fc.property(fc.array(piece, { maxLength: 80 }), (pieces) => void read(pieces.join(''))));
    fc.assert(
      fc.property(
        fc.array(piece, { maxLength: 40 }),
        (pieces) => void read(`${header}\n${good(0)}\n${pieces.join('')}`),
      ),
    );
  });

  test('a missing coordinate and a name given twice', () => {
    expect(read(plain.replace('psi', 'other'))).toMatchObject({
      kind: 'unusable',
      issues: [{ line: 1, message: expect.stringContaining('where psi is missing') }],
    });
    const twice = motion(table(['t', ...names, 'x']));
    expect(columnOf(twice, 'X')).toEqual([1, 11, 21]);
    expect(twice.issues).toMatchObject([{ line: 1, column: 'x' }]);
  });
});

test('other systems are known by their names; most coordinates win, a scenario decides', () => {
  const like = (id: string, list: string[]): SystemMeta => ({
    ...meta,
    id,
    title: id,
    inputs: [],
    coordinates: list.map((name) => ({ ...meta.coordinates[0]!, name })),
  });
  const systems = {
    ripstik: meta,
    sleigh: like('sleigh', ['x', 'y', 'theta']),
    wheel: like('wheel', ['X', 'Y', 'theta', 'phi']),
  };
  const id = (text: string) => {
    const result = readCsv(text, { systems });
    return result.kind === 'motion' ? result.systemId : result;
  };
  expect(id(plain)).toBe('ripstik');
  expect(id(plain.replace('psi', 'other'))).toMatchObject({
    kind: 'unusable',
    issues: [{ message: expect.stringContaining('where psi is missing') }],
  });
  expect(id(table(['t', 'x', 'y', 'theta']))).toBe('sleigh');
  expect(id(table(['t', 'X', 'Y', 'theta', 'phi']))).toBe('wheel');
  expect(id(`# scenario: {"version":1,"system":"sleigh"}\n${table(['t', 'x', 'y', 'theta', 'phi'])}`)).toBe('sleigh');
});

/** Each of these once took a regular expression time with the square of its length, or could. */
test.each([
  ['digits', `${'1'.repeat(900_000)}x`],
  ['blanks', ' '.repeat(900_000)],
  ['quotes', '"'.repeat(100_000)],
  ['hashes', '#'.repeat(900_000)],
  ['brackets', '('.repeat(900_000)],
  ['braces', `# scenario: {${'} '.repeat(90_000)}x`],
  ['separators', ','.repeat(300_000)],
])('a long line of %s is read in no time and costs that line', (_, line) => {
  expect(motion(`${plain}${line}\n${'50,'.repeat(10)}50\n`).rows).toBe(4);
  expect(read(`${line}\n${plain}`).kind).not.toBe('needs-time-step');
});

describe.each(Object.values(metas).map((m) => [m.id, m] as const))(
  'a file of %s is known by its columns alone',
  (id, { coordinates }) => {
    const own = coordinates.map((q) => q.name);
    test.each([
      ['coordinates', ['t', ...own]],
      ['in another order, with rates', [...own.map((name) => `${name}_dot`), ...[...own].reverse(), 'time']],
      [
        'in capitals, with units and a column of no meaning',
        [
          'Time [s]',
          'Remark 7',
          ...coordinates.map((q) => `${q.name.toUpperCase()} (${q.kind === 'angle' ? 'deg' : 'mm'})`),
        ],
      ],
    ])('%s', (_, titles) => {
      const result = motion(table(titles));
      expect(result.systemId).toBe(id);
      expect(result.columns.slice(0, own.length + 1)).toEqual(['t', ...own]);
      expect(result.rows).toBe(3);
    });
  },
);
