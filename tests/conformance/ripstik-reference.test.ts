import { readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { point, type PointReport } from '../../src/cli/point.ts';
import { systems } from '../../src/core/systems/all.ts';
import { runOf, scenarioOf } from '../helpers.ts';

const read = <T>(name: string): T[] =>
  JSON.parse(readFileSync(new URL(`../reference/${name}`, import.meta.url), 'utf8')) as T[];

type PointReference = PointReport & { scenario: { constraints: string } };
interface RunReference {
  scenario: object;
  columns: string[];
  rows: number[][];
}

/** Largest difference over the largest entry. */
function relative(actual: readonly number[], expected: readonly number[]): number {
  expect(actual.length).toBe(expected.length);
  const scale = Math.max(1e-300, ...expected.map(Math.abs));
  return Math.max(0, ...expected.map((x, i) => Math.abs(x - actual[i]!))) / scale;
}

test.each(read<PointReference>('ripstik-points.json').map((p, i) => [i, p.scenario.constraints, p] as const))(
  'point %i (%s): consistent start, mass matrix, accelerations, multipliers, energies, positions',
  (_i, _constraints, expected) => {
    const actual = point(scenarioOf(expected.scenario), systems['ripstik']!);
    expect(relative(actual.q, expected.q)).toBeLessThan(1e-9);
    expect(relative(actual.v, expected.v)).toBeLessThan(1e-9);
    expect(relative(actual.massMatrix.flat(), expected.massMatrix.flat())).toBeLessThan(1e-9);
    expect(relative(actual.acceleration, expected.acceleration)).toBeLessThan(1e-9);
    if (expected.multipliers.length > 0) expect(relative(actual.multipliers, expected.multipliers)).toBeLessThan(1e-9);
    expect(relative([actual.kinetic], [expected.kinetic])).toBeLessThan(1e-9);
    expect(relative([actual.potential], [expected.potential])).toBeLessThan(1e-9);
    expect(relative(actual.positions.flat(), expected.positions.flat())).toBeLessThan(1e-9);
  },
);

test.each(read<RunReference>('ripstik-runs.json').map((r, i) => [i, r] as const))(
  'run %i within 1e-6 at every sample at rtol 1e-10',
  (_i, expected) => {
    const run = runOf({ ...expected.scenario, method: { rtol: 1e-10 } });
    expect(run.rows).toBe(expected.rows.length);
    let worst = 0;
    expected.columns.forEach((name, c) =>
      expected.rows.forEach((row, k) => (worst = Math.max(worst, Math.abs(row[c]! - run.columns.get(name)![k]!)))),
    );
    expect(worst).toBeLessThan(1e-6);
  },
);
