import { describe, expect, test } from 'vitest';
import { cases } from '../../src/core/systems/registry.ts';
import { runOf, type FinishedRun } from '../helpers.ts';
import { loose, pairs, type Pair } from './pairs.ts';

const falling = { ...cases.find((c) => c.id === 'falling-report')!.scenario, duration: 1, outputStep: 0.05 };

/** Constraint residual of every row on the report's falling board. */
function residuals({ method, quick }: Pair, projection: boolean): { run: FinishedRun; residual: Float64Array } {
  const run = runOf({ ...falling, method: { ...method, ...(quick ? { step: quick } : loose), projection } });
  expect(run.end).toMatchObject({ reason: 'end', time: falling.duration });
  return { run, residual: run.columns.get('residual')! };
}

describe('the falling board with its projection and without', () => {
  test.each(pairs.filter((p) => p.id !== 'ida'))('$name: the residual is rounding, or grows from it', (pair) => {
    const kept = residuals(pair, true);
    expect(Math.max(...kept.residual)).toBeLessThan(1e-12);
    expect(kept.run.counts.residual).toBe(Math.max(...kept.residual));

    const { residual } = residuals(pair, false);
    expect(residual[0]!).toBeLessThan(1e-14);
    const early = Math.max(...residual.subarray(0, 4));
    expect(Math.max(...residual)).toBeGreaterThan(1e-10);
    expect(Math.max(...residual), `${early} at first`).toBeGreaterThan(3 * early);
  });

  test('ida: stabilized constraints do not drift, they err by what Newton and the dense output leave', () => {
    const pair = pairs.find((p) => p.id === 'ida')!;
    expect(Math.max(...residuals(pair, true).residual)).toBeLessThan(1e-12);
    const run = runOf({ ...falling, duration: 5.8, method: { name: 'ida', ...loose, projection: false } });
    expect(run.end.reason).toBe('end');
    expect(run.counts.residual).toBeLessThan(1e-5);
    const drifting = runOf({ ...falling, duration: 5.8, method: { name: 'bdf', ...loose, projection: false } });
    expect(drifting.counts.residual).toBeGreaterThan(20 * run.counts.residual);
  });

  test.each([1e-4, 1e-5, 1e-6, 1e-7])('ida without projection reaches the end at rtol %d', (rtol) => {
    const run = runOf({ ...falling, duration: 2, method: { name: 'ida', rtol, atol: 0.01 * rtol, projection: false } });
    expect(run.end.reason).toBe('end');
    expect(Math.abs(run.counts.energyDrift!)).toBeLessThan(0.002);
  });
});
