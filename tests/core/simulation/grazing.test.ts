import { expect, test } from 'vitest';
import { methods } from '../../../src/core/integrators/methods.ts';
import type { System } from '../../../src/core/model/system.ts';
import { dipBetween } from '../../../src/core/simulation/dip.ts';
import { Simulation } from '../../../src/core/simulation/simulation.ts';
import { systems } from '../../../src/core/systems/all.ts';
import { scenarioOf, seeded } from '../../helpers.ts';

const wheel = systems['rolling-wheel']!;
const random = seeded(1905);
const between = (low: number, high: number): number => low + (high - low) * random();

/** A wheel over ground that rises to a hill: the room below it is a parabola of how far it rolled, lowest at `top`. */
const overHill = (top: number, least: number, steep: number): System => ({
  ...wheel,
  constraintSets: Object.fromEntries(
    Object.entries(wheel.constraintSets).map(([id, set]) => [
      id,
      { ...set, contact: { count: 0, rows: [], solveFor: [], heights: () => {} } },
    ]),
  ),
  clearance: (q) => steep * (q[3]! - top) ** 2 + least,
});

function endOf(method: string, system: System, rate: number, options: object) {
  const scenario = scenarioOf({
    version: 1,
    system: 'rolling-wheel',
    initial: { phi_dot: rate },
    duration: 10,
    method: { name: method, ...options },
  });
  const simulation = new Simulation(scenario, system, { extras: [] });
  simulation.advance(() => false);
  return simulation.end!;
}

for (const { id } of methods.filter((m) => m.adaptive)) {
  test(`a grazing touchdown within one step ends the run, and a near miss does not: ${id}`, () => {
    for (let n = 0; n < 40; n++) {
      const rate = between(0.5, 5);
      const steep = between(0.1, 10);
      const depth = 10 ** between(-12, -1);
      const half = Math.sqrt(depth / steep);
      const top = rate * between(0.5, 9.5);
      const touch = (top - half) / rate;
      if (touch <= 0) continue;
      const said = `rate ${rate}, top ${top}, depth ${depth}, steep ${steep}`;
      const end = endOf(id, overHill(top, -depth, steep), rate, {});
      expect(end.reason, said).toBe('touchdown');
      // Where the parabola is flat a little error of the motion is much in time.
      expect(Math.abs(end.time - touch), said).toBeLessThan(1e-6 + 1e-7 / half);
      expect(endOf(id, overHill(top, depth, steep), rate, {}).reason, said).toBe('end');
    }
  }, 60_000);
}

test('a dip is found wherever it is, and only where it is', () => {
  for (let n = 0; n < 2000; n++) {
    const [low, high] = [between(-3, 0), between(0.1, 4)];
    const bottom = between(low + 0.01 * (high - low), high - 0.01 * (high - low));
    const fourth = between(0, 3);
    const kinked = random() < 0.3;
    const depth = kinked ? (high - low) * 10 ** between(-6, -3) : (high - low) ** 2 * 10 ** between(-12, -5);
    for (const sign of [-1, 1]) {
      const value = (t: number): number => {
        const x = t - bottom;
        return (kinked ? Math.abs(x) : x * x * (1 + fourth * x * x)) + sign * depth;
      };
      const found = dipBetween(value, low, value(low), high, value(high));
      if (sign > 0) expect(found).toBe(null);
      else expect(value(found!), `run ${n}`).toBeLessThanOrEqual(0);
    }
  }
});

test('of two dips the first that touches is found, and the second where the first does not', () => {
  for (let n = 0; n < 500; n++) {
    const first = between(0.05, 0.7);
    const second = first + between(0.2, 0.9 - first > 0.2 ? 0.95 - first : 0.25);
    const depth = 10 ** between(-9, -4);
    const dips = (touches: readonly boolean[]) => (t: number) =>
      ((t - first) * (t - second)) ** 2 + depth * (t < (first + second) / 2 === touches[0] ? -1 : 1);
    const find = (value: (t: number) => number): number | null => dipBetween(value, 0, value(0), 1, value(1));
    const both = (t: number): number => ((t - first) * (t - second)) ** 2 - depth;
    const said = `${first}, ${second}, depth ${depth}`;
    const middle = (first + second) / 2;
    expect(find(both)!, said).toBeLessThan(middle);
    expect(find(dips([true]))!, said).toBeLessThan(middle);
    expect(find(dips([false]))!, said).toBeGreaterThan(middle);
  }
});
