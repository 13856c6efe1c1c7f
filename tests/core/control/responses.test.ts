// Loop gain and answers of a regulator: against the poles, the margins and the run.
import { expect, test } from 'vitest';
import { bodeOf, responsesOf } from '../../../src/core/control/responses.ts';
import { computerReport } from '../../../src/core/control/sampled/computerReport.ts';
import { systems } from '../../../src/core/systems/all.ts';
import { runOf, scenarioOf } from '../../helpers.ts';

const file = {
  version: 1,
  system: 'ripstik',
  initial: { X_dot: 1 },
  duration: 2,
  control: { type: 'lqr', inputs: ['tau_fc', 'tau_bc'], at: { X_dot: 1 } },
};
const scenario = scenarioOf(file);
const system = systems['ripstik']!;
const { loop, step } = responsesOf({ scenario, input: 'tau_bc', state: 'theta_bc' }, system)!;

test('where the magnitude crosses 1 the phase is the margin away from half a turn', () => {
  const { magnitude, phase } = bodeOf(loop);
  const found: number[] = [];
  magnitude.forEach((m, i) => {
    if (i === 0 || (magnitude[i - 1]! - 1) * (m - 1) > 0) return;
    const share = Math.log(magnitude[i - 1]!) / (Math.log(magnitude[i - 1]!) - Math.log(m));
    const at = phase[i - 1]! + share * (phase[i]! - phase[i - 1]!);
    found.push(Math.abs(Math.PI - (((at % (2 * Math.PI)) + 2 * Math.PI) % (2 * Math.PI))));
  });
  const { margins } = computerReport(scenario, system);
  expect(Math.min(...found)).toBeCloseTo(margins!.phase['tau_bc']!, 2);
  for (let i = 1; i < phase.length; i++) expect(Math.abs(phase[i]! - phase[i - 1]!)).toBeLessThan(Math.PI);
});

test('the answer to a step is that of the board to a small one', () => {
  const size = 1e-5;
  const run = runOf({ ...file, inputs: { tau_bc: size }, outputStep: 0.01 });
  const [t, theta] = [run.columns.get('t')!, run.columns.get('theta_bc')!];
  const largest = Math.max(...step.state.map(Math.abs));
  step.t.forEach((time, i) => {
    const row = Math.round(time / 0.01);
    if (Math.abs(time - row * 0.01) > 1e-4 || row >= t.length) return;
    const slack = 0.02 * largest;
    expect(Math.abs(theta[row]! / size - step.state[i]!), `t = ${time}`).toBeLessThan(slack);
  });
  // The regulator answers what disturbs it.
  expect(step.input.at(-1)).toBeLessThan(-0.5);
});
