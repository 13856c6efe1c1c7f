// Newton's method in collocation: what it costs beside SciPy's Radau, and what it leaves.
import { readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import type { Counters, OdeProblem } from '../../../src/core/integrators/contract.ts';
import { createStepper } from '../../../src/core/integrators/registry.ts';
import { distance, kepler, prothero, robertson, run, vanDerPol } from './problems.ts';

describe("beside SciPy's Radau", () => {
  interface Counts {
    problems: Record<
      string,
      { start: number[]; time: number; atolPerRtol: number; end: number[]; rows: (Counters & { rtol: number })[] }
    >;
  }
  const { problems } = JSON.parse(
    readFileSync(new URL('../../reference/radau-counts.json', import.meta.url), 'utf8'),
  ) as Counts;
  const equations: Record<string, OdeProblem> = { kepler, prothero, robertson: robertson(true), vanDerPol };
  const rows = Object.entries(problems).flatMap(([name, { rows: list, ...p }]) => list.map((r) => ({ name, p, ...r })));

  test.each(rows)('$name at $rtol: steps and evaluations', ({ name, p, rtol, ...theirs }) => {
    const stepper = createStepper('radau', equations[name]!, { rtol, atol: rtol * p.atolPerRtol })!;
    stepper.reset(0, Float64Array.from(p.start));
    expect(run(stepper, p.time)).toBeNull();
    const { steps, evaluations, factorizations } = stepper.counters;
    const counts = JSON.stringify(stepper.counters);
    // On the slow solution of Prothero and Robinson's problem it takes more: rows between the steps are held to the tolerance.
    expect(steps, counts).toBeLessThan(name === 'prothero' ? 2 * theirs.steps : theirs.steps);
    expect(evaluations, counts).toBeLessThan((name === 'prothero' ? 2.6 : 1.25) * theirs.evaluations);
    expect(factorizations, counts).toBeLessThan((name === 'prothero' ? 4.5 : 1.1) * theirs.factorizations);
    expect(distance(stepper.y, p.end)).toBeLessThan(400 * rtol);
  });
});

test('a rate of convergence that was measured with exact factors is not trusted with those of another step', () => {
  // Prothero and Robinson's problem is linear: exact factors converge at once, those of another step at |1 - h / h_f|.
  const stepper = createStepper('radau', prothero, { rtol: 1e-6, atol: 1e-6 })!;
  stepper.reset(0, Float64Array.of(1));
  let largest = 0;
  expect(
    run(stepper, 10, () => (largest = Math.max(largest, Math.abs(stepper.y[0]! - Math.cos(stepper.t))))),
  ).toBeNull();
  expect(largest).toBeLessThan(3e-6);
  expect(stepper.counters.rejected).toBeLessThan(10);
});
