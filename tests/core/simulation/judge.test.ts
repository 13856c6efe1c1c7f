import { expect, test } from 'vitest';
import { judgeMotion } from '../../../src/core/simulation/judge.ts';
import { systems } from '../../../src/core/systems/all.ts';
import { runOf } from '../../helpers.ts';

const ripstik = systems['ripstik']!;

test('a recorded run is judged as the run itself was; a moved row shows, missing velocities tell nothing', () => {
  const run = runOf({ version: 1, system: 'ripstik', initial: { X_dot: 1, alpha: '0.5 deg' }, duration: 0.4 });
  const parameters = Object.fromEntries(ripstik.meta.parameters.map((p) => [p.name, p.default]));
  const judge = (columns: Map<string, Float64Array>) =>
    judgeMotion(ripstik, parameters, 'rolling', (name) => columns.get(name));
  const fair = judge(run.columns)!;
  expect(fair.energyDrift).toBeCloseTo(run.counts.energyDrift!, 12);
  expect(fair.residual).toBeLessThan(1e-12);

  const moved = new Map([...run.columns].map(([name, values]) => [name, values.slice()]));
  moved.get('Z')![7]! += 0.01;
  expect(judge(moved)!.residual).toBeCloseTo(0.01, 6);
  moved.delete('psi_dot');
  expect(judge(moved)).toBeNull();
});
