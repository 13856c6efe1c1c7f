// One run of a sweep: what is left out to save time changes no number.
import { describe, expect, test } from 'vitest';
import { SweepClient } from '../../src/compute/client/sweepClient.ts';
import type { SweepMeasure } from '../../src/core/motion/sweepMeasures.ts';
import type { ScenarioFile } from '../../src/core/scenario/types.ts';
import { runOf } from '../helpers.ts';
import { starts } from './nearWorker.ts';

const measured = async (client: SweepClient, file: ScenarioFile, measures: SweepMeasure[]) => {
  const answer = await client.measure({ file, measures }, () => {});
  if (!answer?.ok) throw new Error(answer?.message ?? 'given up');
  return answer.value;
};

const BOARD: ScenarioFile = { version: 1, system: 'ripstik', initial: { X_dot: 1, alpha_fp: '10 deg' }, duration: 0.7 };
const END: SweepMeasure[] = [{ kind: 'end', column: 'X' }, { kind: 'end', column: 'alpha' }, { kind: 'time' }];
const STEPS: SweepMeasure[] = [...END, { kind: 'steps' }];

describe('without rows that nothing is measured in', () => {
  test.each<[string, ScenarioFile]>([
    ...(['dopri5', 'rk4', 'radau', 'bdf', 'ida'] as const).map((name): [string, ScenarioFile] => [
      name,
      { ...BOARD, duration: 0.3, method: { name, rtol: 1e-6, atol: 1e-8 } },
    ]),
    ['an event before the end', { ...BOARD, duration: 5, initial: { X_dot: 1, alpha: '20 deg' } }],
    ['the report’s rows', { ...BOARD, constraints: 'report' }],
    ['a disturbance', { ...BOARD, inputs: { tau_twist: '2*exp(-200*(t-0.2)^2)' } }],
    [
      'a controller',
      {
        ...BOARD,
        initial: { X_dot: 1, alpha: '1 deg' },
        control: { type: 'lqr', inputs: ['tau_fc', 'tau_bc'], at: { X_dot: 1 }, Q: { alpha_fp: 10 } },
      },
    ],
  ])('%s: the end is the same, to the bit', async (_, file) => {
    const client = new SweepClient(starts());
    const few = await measured(client, file, STEPS);
    const all = await measured(client, file, [...STEPS, { kind: 'max', column: 'X' }]);
    expect(few.values).toEqual(all.values.slice(0, STEPS.length));
    expect(few.end).toEqual(all.end);
    const { columns, rows } = runOf(file);
    expect(few.values[0]).toBe(columns.get('X')![rows - 1]);
    client.close();
  });
});

test('what is summed up over rows has them, at its end too', async () => {
  const client = new SweepClient(starts());
  const path: SweepMeasure = { kind: 'end', column: 'path' };
  const { values } = await measured(client, BOARD, [path, { kind: 'distance' }]);
  expect(values[0]).toBeGreaterThan(0.1);
  expect(values[0]).toBeCloseTo(values[1]!, 12);
  expect((await measured(client, BOARD, [path])).values).toEqual([values[0]]);
});

test('a controller is designed anew when what it depends on varies, and only then', async () => {
  const client = new SweepClient(starts());
  const at = (X_dot: number, alpha: string, weight: number): ScenarioFile => ({
    ...BOARD,
    duration: 0.2,
    initial: { X_dot: 1, alpha },
    control: { type: 'lqr', inputs: ['tau_fc', 'tau_bc'], at: { X_dot }, Q: { alpha_fp: weight } },
  });
  const files = [at(1, '1 deg', 10), at(1, '2 deg', 10), at(1, '2 deg', 20), at(1.5, '2 deg', 20), at(1, '1 deg', 10)];
  const values: number[][] = [];
  for (const file of files) values.push((await measured(client, file, END)).values);
  for (const [k, file] of files.entries())
    expect(values[k], `run ${k}`).toEqual((await measured(new SweepClient(starts()), file, END)).values);
  expect(new Set(values.map((v) => v[1])).size).toBe(4);
});
