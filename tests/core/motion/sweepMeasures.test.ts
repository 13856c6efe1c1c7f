import { expect, test } from 'vitest';
import { RunMeasurer, type SweepMeasure } from '../../../src/core/motion/sweepMeasures.ts';
import { systems } from '../../../src/core/systems/all.ts';
import { runOf, scenarioOf } from '../../helpers.ts';

test('measures are the same however the rows are cut into chunks', () => {
  const file = {
    version: 1,
    system: 'casterboard-robot',
    duration: 2,
    inputs: { tau_f: '0.1*sin(6*t)', tau_r: '0.1*sin(6*t)' },
  };
  const { columns, rows, end, counts, simulation } = runOf(file);
  const kinds = ['end', 'max', 'min'] as const;
  const measures: SweepMeasure[] = [
    ...['path', 'work', 'power', 'speed', 'x', 'phi_f_dot'].flatMap((column) =>
      kinds.map((kind) => ({ kind, column })),
    ),
    { kind: 'distance' },
    { kind: 'work' },
  ];
  const data = [...columns.values()];
  const { parameters } = scenarioOf(file);
  const [whole, ...cut] = [rows, 1, 2, 7, rows - 1].map((size) => {
    const measurer = new RunMeasurer(
      systems['casterboard-robot']!,
      parameters,
      [...columns.keys()],
      measures,
      simulation.q,
    );
    for (let from = 0; from < rows; from += size) {
      const until = Math.min(rows, from + size);
      measurer.take(
        data.map((column) => column.slice(from, until)),
        until - from,
      );
      measurer.take(
        data.map(() => new Float64Array(0)),
        0,
      );
    }
    return measurer.result(end, counts, 0);
  });
  expect(whole!.every(Number.isFinite)).toBe(true);
  expect(whole![0]).toBeGreaterThan(0);
  for (const values of cut) expect(values).toEqual(whole);
});
