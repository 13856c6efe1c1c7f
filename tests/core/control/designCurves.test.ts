// Curves of a regulator over speed: the rider's figures, what is refused, and the delay margin of a held gain.
import { describe, expect, test } from 'vitest';
import { lqrOf } from '../../../src/core/control/design/scenarioControl.ts';
import { curvesCsv, designCurves } from '../../../src/core/control/locus/designCurves.ts';
import { heldDelayMargin } from '../../../src/core/control/margins.ts';
import { heldDesign } from '../../../src/core/control/sampled/sampledLqr.ts';
import { systems } from '../../../src/core/systems/all.ts';
import { cases } from '../../../src/core/systems/registry.ts';
import { scenarioOf } from '../../helpers.ts';

const rider = cases.find((c) => c.id === 'rider-balanced')!.scenario;
const curvesOf = (scenario: Record<string, unknown>, request: object) =>
  designCurves(scenarioOf(scenario), systems[scenario.system as string]!, {
    vary: 'at',
    name: 'X_dot',
    from: 0,
    to: 5,
    count: 6,
    ...request,
  });

describe('the rider from rest to 5 m/s', () => {
  const shares: number[] = [];
  const { points } = designCurves(
    scenarioOf({ ...rider, control: { ...rider.control, sample: 0.002 } }),
    systems['ripstik-rider']!,
    { vary: 'at', name: 'X_dot', from: 0, to: 5, count: 6 },
    (share) => shares.push(share),
  );
  test.each([
    { speed: 0, growth: 2.998, gain: 58_226, delay: 0.205, held: 0.204 },
    { speed: 1, growth: 2.889, gain: 1_684, delay: 0.21, held: 0.208 },
    { speed: 5, growth: 2.564, gain: 144, delay: 0.236, held: 0.234 },
  ])('at $speed m/s', ({ speed, growth, gain, delay, held }) => {
    const point = points.find(({ value }) => value === speed)!;
    expect(point.growing).toBe(1);
    expect(Math.abs(point.growth - growth)).toBeLessThan(1e-3);
    for (const [found, known] of [
      [point.gain, gain],
      [point.delay, delay],
      [point.heldDelay, held],
    ] as const)
      expect(Math.abs(found! / known - 1)).toBeLessThan(0.01);
    expect(point.gainOf).toEqual({ input: 'tau_af', state: 'beta' });
  });
  test('faster is easier at every speed, and the share that is done rises to one', () => {
    for (const key of ['growth', 'gain'] as const)
      points.slice(1).forEach((point, i) => expect(point[key]).toBeLessThan(points[i]![key]!));
    points.slice(1).forEach((point, i) => expect(point.delay).toBeGreaterThan(points[i]!.delay!));
    expect(shares.at(-1)).toBe(1);
    expect(shares).toEqual([...shares].sort((a, b) => a - b));
  });
});

test('a bicycle that balances itself between weave and capsize: nothing grows there, and the curves go on', () => {
  const { points } = curvesOf(
    {
      version: 1,
      system: 'bicycle',
      control: { type: 'lqr', inputs: ['tau_steer'], at: { speed: 5 }, Q: { roll: 1 } },
    },
    { name: 'speed', from: 2, to: 8, count: 4 },
  );
  expect(points.map(({ growing }) => growing)).toEqual([2, 2, 0, 1]);
  for (const { gain, problem } of points) expect([problem, gain! > 0]).toEqual([null, true]);
});

test('where there is no design the reason stands, and the growth all the same', () => {
  const { points, request } = curvesOf(
    { ...rider, control: { type: 'lqr', inputs: ['f_X'], at: { X_dot: 1 } } } as Record<string, unknown>,
    { count: 2 },
  );
  for (const point of points) {
    expect(point.problem).toMatch(/no input reaches the unstable mode/);
    expect(point.growth).toBeGreaterThan(2.5);
    expect([point.gain, point.delay]).toEqual([null, null]);
  }
  const [head, first] = curvesCsv({ request, sample: null, points }).split('\n');
  expect(head).toBe('X_dot,growth,growing,gain,delay,problem');
  expect(first).toMatch(/^0,2\.99\d+,1,,,"f_X can't stabilize/);
});

test.each([
  [{ from: 5, to: 5 }, /range must rise/],
  [{ count: 1 }, /between 2 and/],
  [{ name: 'speed' }, /"speed" is neither a parameter nor a state/],
  [{ vary: 'parameter', name: 'mass' }, /no parameter "mass"/],
])('%o is refused', (request, message) => {
  expect(() => curvesOf(rider as never, request)).toThrow(message);
});

test('without an lqr there are none', () => {
  expect(() => curvesOf({ version: 1, system: 'ripstik-rider' }, {})).toThrow(/must be of type "lqr"/);
});

test.each([0.002, 0.02, 0.07])(
  'held at %d s: just below the margin the sampled loop decays, just above it grows',
  (sample) => {
    const design = lqrOf(scenarioOf(rider as never), systems['ripstik-rider']!);
    const { A, B } = design.quotient;
    const margin = heldDelayMargin({ A, B, K: design.riccati.gain }, sample);
    const radius = (delay: number) => heldDesign(design, { sample, delay }).spectralRadius;
    expect(radius(margin - 1e-5)).toBeLessThan(1);
    expect(radius(margin + 1e-5)).toBeGreaterThan(1);
  },
);
