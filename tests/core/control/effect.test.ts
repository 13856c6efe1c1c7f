// What a regulator costs in a run is what its Riccati solution says it costs, where the motion is small enough to be linear.
import { expect, test } from 'vitest';
import { EffectMeter } from '../../../src/core/control/design/effect.ts';
import { feedbackOf } from '../../../src/core/control/design/feedback.ts';
import { lqrOf } from '../../../src/core/control/design/scenarioControl.ts';
import { Simulation } from '../../../src/core/simulation/simulation.ts';
import { systems } from '../../../src/core/systems/all.ts';
import { scenarioOf } from '../../helpers.ts';

function effectOf(file: object) {
  const scenario = scenarioOf(file);
  const system = systems[scenario.system]!;
  const simulation = new Simulation(scenario, system, { extras: ['inputs'], feedback: feedbackOf(scenario, system) });
  const meter = new EffectMeter(scenario, system);
  while (!simulation.end) {
    simulation.advance(() => simulation.rows > 100);
    const { columns, rows } = simulation.takeChunk();
    meter.take(simulation.columns, columns, rows);
  }
  return { ...meter.effect(simulation.end, simulation.counts.work), design: lqrOf(scenario, system) };
}

const SMALL = 1e-4;
const UPRIGHT = {
  version: 1,
  system: 'cart-pendulum',
  initial: { theta: Math.PI / 2 - SMALL },
  control: { type: 'lqr', inputs: ['f_X'], Q: { X: 1, X_dot: 10, theta: 10, theta_dot: 100 } },
  duration: 40,
  outputStep: 0.002,
};

test('its cost is x0ᵀ P x0, and the first force is the largest', () => {
  const { cost, peaks, reason, design } = effectOf(UPRIGHT);
  const { states } = design.linearization;
  const P = design.riccati.X;
  const z = design.quotient.fromStates.getColumn(states.indexOf('theta')).map((x) => -SMALL * x);
  const expected = z.reduce((sum, a, i) => sum + z.reduce((row, b, j) => row + a * P.get(i, j) * b, 0), 0);
  expect(reason).toBe('end');
  expect(cost! / expected).toBeCloseTo(1, 3);
  const asked = Math.abs(design.gain.get(0, states.indexOf('theta')) * SMALL);
  expect(peaks).toHaveLength(1);
  expect(peaks[0]!.value / asked).toBeCloseTo(1, 3);
});

test('dearer effort takes less force and costs more', () => {
  const cheap = effectOf(UPRIGHT);
  const dear = effectOf({ ...UPRIGHT, control: { ...UPRIGHT.control, R: { f_X: 1000 } } });
  expect(dear.peaks[0]!.value).toBeLessThan(cheap.peaks[0]!.value);
  expect(dear.cost!).toBeGreaterThan(cheap.cost!);
});

test('gains over the speed have no one cost; a board that falls says when', () => {
  const ride = {
    version: 1,
    system: 'ripstik',
    initial: { X_dot: 1, alpha_fp: '10 deg', alpha_bp: '10 deg' },
    control: { type: 'lqr', inputs: ['tau_fc', 'tau_bc'], at: { X_dot: 1 }, limits: { tau_fc: 0.001, tau_bc: 0.001 } },
    duration: 3,
  };
  const { cost, peaks, reason, time } = effectOf(ride);
  expect(cost).toBeGreaterThan(0);
  expect(Math.max(...peaks.map(({ value }) => value))).toBeLessThanOrEqual(0.001);
  expect(reason).not.toBe('end');
  expect(time).toBeLessThan(3);
});
