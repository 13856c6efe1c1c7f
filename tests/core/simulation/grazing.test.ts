import { describe, expect, test } from 'vitest';
import { methods } from '../../../src/core/integrators/methods.ts';
import type { System } from '../../../src/core/model/system.ts';
import { firstCrossing } from '../../../src/core/simulation/firstCrossing.ts';
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

describe('the first crossing', () => {
  const crossingOf = (value: (t: number) => number, low: number, high: number): number | null => {
    const found = firstCrossing({ value }, low, high);
    if (!found) return null;
    let [above, below] = found;
    expect(value(above) > 0 && !(value(below) > 0)).toBe(true);
    for (let t = above + 0.5 * (below - above); t > above && t < below; t = above + 0.5 * (below - above))
      if (value(t) > 0) above = t;
      else below = t;
    return below;
  };

  test('of one dip, wherever it is, and only where it is', () => {
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
        const found = crossingOf(value, low, high);
        if (sign > 0) expect(found).toBe(null);
        else expect(found!, `run ${n}`).toBeLessThan(bottom);
      }
    }
  });

  test('of polynomials with up to eight zeros, some of them close together', () => {
    for (let n = 0; n < 3000; n++) {
      const count = 1 + Math.floor(8 * random());
      const zeros = [between(0, 1)];
      while (zeros.length < count)
        zeros.push(random() < 0.3 ? zeros.at(-1)! + 10 ** between(-6, -1) : between(-0.5, 1.5));
      zeros.sort((a, b) => a - b);
      const sign = random() < 0.5 ? -1 : 1;
      const value = (t: number): number => zeros.reduce((product, zero) => product * (t - zero), sign);
      // Falling through every other zero, the last where the polynomial falls at last.
      const falling = zeros.filter((_, i) => (zeros.length - 1 - i) % 2 === (sign < 0 ? 0 : 1));
      const expected = falling.find((zero) => zero > 0 && zero <= 1) ?? null;
      const found = crossingOf(value, 0, 1);
      const said = `run ${n}: ${sign} ${zeros.join(', ')}`;
      if (expected === null) expect(found, said).toBe(null);
      else expect(Math.abs(found! - expected), said).toBeLessThan(1e-12);
    }
  });

  test('of waves, of the lowest of several, and of what has kinks, as a dense search finds it', () => {
    for (let n = 0; n < 600; n++) {
      const waves = Array.from({ length: 1 + Math.floor(4 * random()) }, () => ({
        size: between(0.1, 1),
        rate: 10 ** between(-0.5, 2),
        phase: between(0, 7),
      }));
      const sums = Array.from({ length: 1 + Math.floor(3 * random()) }, () => between(0, 2));
      const kinked = random() < 0.3;
      const value = (t: number): number => {
        let lowest = Infinity;
        for (const offset of sums) {
          let sum = offset;
          for (const { size, rate, phase } of waves) sum += size * Math.sin(rate * t + phase + offset);
          lowest = Math.min(lowest, kinked ? Math.abs(sum) - 0.05 : sum);
        }
        return lowest;
      };
      const found = crossingOf(value, 0, 1);
      const step = 1e-4;
      let dense: number | null = null;
      for (let k = 0; k < 1 / step && dense === null; k++)
        if (value(k * step) > 0 && !(value((k + 1) * step) > 0)) dense = (k + 1) * step;
      // It may find what a dense search steps over.
      if (dense !== null) expect(found ?? Infinity, `run ${n}`).toBeLessThanOrEqual(dense);
    }
  });

  test('of an interval of a few last digits', () => {
    for (let n = 0; n < 500; n++) {
      const low = between(0.1, 10);
      const high = low + Math.ceil(between(0, 40)) * low * Number.EPSILON;
      const at = between(low, high);
      const found = firstCrossing({ value: (t) => (at - t) * (random() - 0.3) }, low, high);
      if (found) expect(found[0] >= low && found[0] < found[1] && found[1] <= high).toBe(true);
    }
  });

  test('costs six looks where nothing is near', () => {
    let looks = 0;
    expect(firstCrossing({ value: (t) => (looks++, 1 + 0.1 * t + 0.05 * t * t) }, 0, 1)).toBe(null);
    expect(looks).toBe(6);
  });
});

/** A wheel over hills at places that it rolls over one after another, some of them too low to touch. */
const overHills = (hills: readonly { top: number; width: number; least: number }[]): System => ({
  ...overHill(0, 0, 0),
  clearance: (q) =>
    hills.reduce((room, { top, width, least }) => room - (1 - least) * Math.exp(-(((q[3]! - top) / width) ** 2)), 1),
});

for (const { id } of methods)
  test(`of several touchdowns within one step the first ends the run: ${id}`, () => {
    for (let n = 0; n < 30; n++) {
      const rate = between(1, 5);
      const step = between(0.2, 1);
      const hills = Array.from({ length: 2 + Math.floor(4 * random()) }, (_, k) => ({
        top: 0.5 + 0.35 * k + between(0, 0.1),
        width: between(0.04, 0.06),
        least: random() < 0.3 ? 10 ** between(-3, -1) : -(10 ** between(-3, -1)),
      }));
      const system = overHills(hills);
      const room = (t: number): number => system.clearance!(Float64Array.of(0, 0, 0, rate * t), new Float64Array());
      let touch = 1e-5;
      while (touch < 10 && room(touch) > 0) touch += 1e-5;
      const { reason, time } = endOf(id, system, rate, { step, maxStep: step });
      const said = `rate ${rate}, step ${step}, ${JSON.stringify(hills)}`;
      expect(reason, said).toBe(touch < 10 ? 'touchdown' : 'end');
      expect(Math.abs(time - Math.min(10, touch)), said).toBeLessThan(3e-5);
    }
  }, 60_000);
