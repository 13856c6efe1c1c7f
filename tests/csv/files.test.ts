// Files of the world, a kind each: every one is the same motion, written as some tool writes it.
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, test } from 'vitest';
import type { CsvOptions } from '../../src/csv/csv.ts';
import { motionOf, readBytes } from './circle.ts';

/** A double holds seconds since 1970 to a quarter of a microsecond. */
const CLOCK = 1e-6;
const FILES = join(import.meta.dirname, 'files');

const file = (name: string, options: Partial<CsvOptions> = {}) => motionOf(readFileSync(join(FILES, name)), options);

/** On a circle of 1.25 m at 0.8 rad/s and 1 m/s: what all of them hold, rounded to what they print. */
const circle = (t: number) => ({
  t,
  x: 1.25 * Math.sin(0.8 * t) * 0.8,
  y: 1.25 * (1 - Math.cos(0.8 * t)) * 0.8,
  theta: 0.8 * t,
});

/** Files with all 101 rows of it, 20 ms apart. */
const WHOLE = [
  'iso-times.csv',
  'epoch-nanoseconds.csv',
  'timestamp-milliseconds.csv',
  'phone-decimal-commas.csv',
  'units-row.csv',
  'rigid-body-groups.csv',
  'six-degrees.tsv',
  'shuffled.csv',
  'told-separator.csv',
  'quoted-decimal-commas.csv',
  'fortran-exponents.csv',
  'quaternion.csv',
  'long.csv',
  'in-degrees.mot',
  'blanks.txt',
  'lines-above.csv',
  'derivatives.csv',
  'date-and-clock.csv',
  'spreadsheet-error-beside.csv',
  'second-clock.csv',
  'clock-set-late.csv',
];

describe.each(WHOLE)('%s', (name) => {
  test('is the motion, every row of it', () => {
    const motion = file(name);
    expect(motion).toMatchObject({ systemId: 'chaplygin-sleigh', rows: 101, skippedRows: 0, questions: [] });
    for (let row = 0; row < 101; row++) {
      const expected = circle(row / 50);
      for (const [column, value] of Object.entries(expected)) {
        const read = motion.data[motion.columns.indexOf(column)]![row]!;
        expect(Math.abs(read - value), `${column} of row ${row}: ${read}`).toBeLessThan(column === 't' ? CLOCK : 1e-4);
      }
    }
  });
});

test('a column turned over ±180° goes on, without a seam', () => {
  const motion = file('wrapped-coarse.csv');
  const theta = [...motion.data[motion.columns.indexOf('theta')]!];
  theta.forEach((angle, i) => expect(angle).toBeCloseTo(((160 + 15 * i) * Math.PI) / 180, 9));
  expect(motion.notes.join()).toContain('theta: jumps of a whole turn are taken out');
});

test('degrees and millimetres without a unit are asked for, and read as told', () => {
  const asked = file('degrees-unmarked.csv');
  expect(asked.questions.map((q) => q.id)).toEqual(['degrees', 'lengths']);
  const choices = asked.questions.reduce((all, q) => ({ ...all, ...q.answers.at(-1)!.choices }), {});
  const told = file('degrees-unmarked.csv', { choices });
  expect(told.questions).toEqual([]);
  expect(told.data[told.columns.indexOf('theta')]![100]).toBeCloseTo(1.6, 4);
  expect(told.data[told.columns.indexOf('x')]![100]).toBeCloseTo(circle(2).x, 4);
});

test('a gap is one range of lines', () => {
  const motion = file('dropout.csv');
  expect(motion).toMatchObject({ rows: 81, skippedRows: 20 });
  expect(motion.issues).toEqual([{ line: 32, to: 51, column: 'x', message: 'the cell is empty' }]);
});

test('a row that begins with a spreadsheet error is a row with a missing time', () => {
  const motion = file('spreadsheet-error-first.csv');
  expect(motion).toMatchObject({ rows: 97, skippedRows: 4 });
  expect(motion.issues).toMatchObject([
    { line: 12, to: 14, column: 't' },
    { line: 42, column: 't' },
  ]);
});

test("another tool's container is known, and told what to do there", () => {
  const result = readBytes(readFileSync(join(FILES, 'run.mat')));
  expect(result).toMatchObject({ kind: 'unusable', issues: [{ message: expect.stringContaining('writetable') }] });
});

test('every file here is read by a test', () => {
  const others = [
    'wrapped-coarse.csv',
    'degrees-unmarked.csv',
    'dropout.csv',
    'spreadsheet-error-first.csv',
    'run.mat',
  ];
  expect(readdirSync(FILES).sort()).toEqual([...WHOLE, ...others].sort());
});
