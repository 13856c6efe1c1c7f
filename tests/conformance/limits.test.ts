// A share of docs/limits: what is said to be survived is, and what is said not to be is not.
import { readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { largest, leanTest, pushTest } from '../../src/cli/bench/recovery.ts';
import { seeded } from '../helpers.ts';

interface Row {
  speed: number;
  inputs: string[];
  limit: number | null;
  survived: number;
  failed: number | null;
}

const rowsOf = (name: string): Row[] =>
  readFileSync(`docs/limits/${name}.csv`, 'utf8')
    .split('\n')
    .slice(2)
    .filter((line) => line !== '')
    .map((line) => {
      const [speed, motors, limit, survived, failed] = line.split(',');
      return {
        speed: Number(speed),
        inputs: motors!.split(' '),
        limit: limit ? Number(limit) : null,
        survived: Number(survived),
        failed: failed ? Number(failed) : null,
      };
    });

/** Some rows, always the same. */
function some(rows: readonly Row[], count: number): Row[] {
  const random = seeded(11);
  return rows
    .map((row) => ({ row, key: random() }))
    .sort((a, b) => a.key - b.key)
    .slice(0, count)
    .map(({ row }) => row);
}

describe.each([
  ['lean', leanTest, Math.PI / 180],
  ['push', pushTest, 1],
  ['single-motor', leanTest, Math.PI / 180],
] as const)('%s', (name, make, unit) => {
  const rows = rowsOf(name);

  test.each(some(rows, 3))('%j', (row) => {
    const survives = make(row);
    expect(survives(0.97 * row.survived * unit)).toBe(true);
    if (row.failed !== null) expect(survives(1.03 * row.failed * unit)).toBe(false);
  });

  test('has every speed of every line, ends close together', () => {
    expect(rows.length).toBeGreaterThanOrEqual(24);
    for (const { survived, failed } of rows) {
      expect(survived).toBeGreaterThan(0);
      if (failed !== null) expect(failed / survived).toBeLessThan(1.02);
    }
  });
});

test('a single steering motor holds the board, from little', () => {
  const lean = (motor: string) =>
    rowsOf('single-motor').find((r) => r.speed === 1 && r.inputs.join() === motor)!.survived;
  expect(lean('tau_fc')).toBeGreaterThan(0.5);
  expect(lean('tau_fc')).toBeLessThan(1);
  expect(lean('tau_bc')).toBeLessThan(0.1);
});

test('the search for a limit finds it, and islands beyond it are not taken for it', () => {
  const island = (x: number) => x < 0.37 || (x > 0.7 && x < 0.9);
  for (const start of [0.01, 0.3, 5]) {
    const { survived, failed } = largest(island, start, 10, 1.001);
    expect(survived).toBeLessThan(0.37);
    expect(failed).toBeGreaterThanOrEqual(0.37);
    expect(failed / survived).toBeLessThanOrEqual(1.001);
  }
  expect(largest(() => true, 1, 10, 1.01)).toEqual({ survived: 10, failed: Infinity });
  expect(largest(() => false, 1, 10, 1.01).survived).toBe(0);
});
