import { readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { maxAbs } from '../../src/core/linalg/dense.ts';
import { ConstrainedSystem } from '../../src/core/mechanics/constrainedSystem.ts';
import type { Forcing } from '../../src/core/mechanics/forcing.ts';
import { systems } from '../../src/core/systems/all.ts';
import { seeded } from '../helpers.ts';

const SEED = 20261128;
const STATES = 256;
/** Relative to the largest entry; the scaled rows are kept clear of dependence, where any two ways part. */
const SAME = 1e-12;
const INDEPENDENT = 1e-3;

type Op = ['input', 'p' | 'q' | 'v' | 'f' | 'g', number] | ['const', number] | [string, number, number?];
interface Tape {
  ops: Op[];
  prepare: number[];
  sets: Record<string, Record<string, number[]>>;
}

const readTape = (id: string): Tape =>
  JSON.parse(readFileSync(`src/core/systems/${id}/accelerations.generated.json`, 'utf8')) as Tape;

/** Sine and cosine as derivation/trigonometry.py writes them into every engine. */
function sineAndCosine(x: number): { sin: number; cos: number } {
  const rounder = 1.5 * 2 ** 52;
  const k = x * 0.6366197723675814 + rounder - rounder;
  const high = x - k * 1.57079632673412561417;
  const second = k * 6.0771005063039659766e-11;
  const r = high - second;
  const lost = high - r - second - k * 2.02226624879595063154e-21;
  const z = r * r;
  const half = 0.5 * z;
  const rest = 1 - half;
  const along = (c: readonly number[]) => c.reduceRight((sum, coefficient) => coefficient + z * sum);
  const q = z * (z * along(COSINE));
  const s = r + (z * r * along(SINE) + lost * (rest + q));
  const c = rest + (1 - rest - half + (q - s * lost));
  const [sin, cos] = [
    [s, c],
    [c, -s],
    [-s, -c],
    [-c, s],
  ][k & 3] as [number, number];
  return { sin, cos };
}

const SINE = [
  -1.66666666666666324348e-1, 8.33333333332248946124e-3, -1.98412698298579493134e-4, 2.75573137070700676789e-6,
  -2.50507602534068634195e-8, 1.58969099521155010221e-10,
];
const COSINE = [
  4.16666666666666019037e-2, -1.38888888888741095749e-3, 2.48015872894767294178e-5, -2.75573143513906633035e-7,
  2.0875723212981748279e-9, -1.13596475577881948265e-11,
];

/** Every value of a tape, one operation after another. */
function valuesOf({ ops }: Tape, inputs: Readonly<Record<string, Float64Array>>): number[] {
  const values: number[] = [];
  const one = Math as unknown as Record<string, (x: number) => number>;
  for (const [kind, first, second] of ops) {
    const [a, b] = [values[first as number]!, values[second as number]!];
    if (kind === 'input') values.push(inputs[first]![second as number]!);
    else if (kind === 'const') values.push(first as number);
    else if (kind === 'add') values.push(a + b);
    else if (kind === 'sub') values.push(a - b);
    else if (kind === 'mul') values.push(a * b);
    else if (kind === 'div') values.push(a / b);
    else if (kind === 'neg') values.push(-a);
    else if (kind === 'sin' || kind === 'cos') values.push(sineAndCosine(a)[kind]);
    else values.push(one[kind]!(a));
  }
  return values;
}

const sets = Object.values(systems).flatMap((system) =>
  Object.values(system.constraintSets)
    .filter(({ direct }) => direct !== undefined)
    .flatMap((set) =>
      subsets(set.direct!.holdable ?? []).map((hold) => {
        const names = hold.map((i) => `, ${system.meta.coordinates[i]!.name} held`).join('');
        return { name: `${system.meta.id}, ${set.id}${names}`, system, set: set.id, hold };
      }),
    ),
);

function subsets(of: readonly number[]): number[][] {
  return of.reduce<number[][]>((all, i) => [...all, ...all.map((some) => [...some, i])], [[]]);
}

test('the board has a short way under both of its constraint sets', () => {
  expect(sets.map(({ name }) => name)).toEqual(expect.arrayContaining(['ripstik, rolling', 'ripstik, report']));
});

/** Both ways with the same parameters and forces from outside. */
function both(name: string, set: string, parameters: Float64Array, forcing: Forcing | null, hold: number[] = []) {
  const system = systems[name]!;
  return {
    short: new ConstrainedSystem(system, parameters, set, hold, forcing),
    general: new ConstrainedSystem(system, parameters, set, hold, forcing, 'general'),
  };
}

const apart = (a: Float64Array, b: Float64Array): number =>
  maxAbs(a.map((x, i) => x - b[i]!)) / Math.max(maxAbs(b), Number.MIN_VALUE);

describe.each(sets)('the short way and the general one: $name', ({ system, set, hold }) => {
  const { meta } = system;
  const n = meta.coordinates.length;

  /** Parameters around their defaults, those that are zero there between 0 and 1, or `losses` times that. */
  const drawn = (random: () => number, losses: number) =>
    Float64Array.from(meta.parameters, (p) =>
      p.default === 0 ? losses * random() : p.default * (0.8 + 0.4 * random()),
    );

  test.each([
    { what: 'free of outside forces and losses', losses: 0, outside: 0 },
    { what: 'with losses and drag', losses: 1, outside: 0 },
    { what: 'with outside forces', losses: 0, outside: 10 },
  ])(`agree at ${STATES} states and parameters, $what (seed ${SEED})`, ({ losses, outside }) => {
    const random = seeded(SEED);
    const vector = (size: number, length = n) => Float64Array.from({ length }, () => size * (2 * random() - 1));
    for (let k = 0, seen = 0; seen < STATES; k++) {
      expect(k, 'enough states are regular').toBeLessThan(4 * STATES);
      const pull = vector(outside);
      const forcing: Forcing | null =
        outside > 0 ? (_t, _q, _v, force) => pull.forEach((x, i) => (force[i]! += x)) : null;
      const { short, general } = both(meta.id, set, drawn(random, losses), forcing, hold);
      const [q, v, m] = [vector(0.6), vector(2), short.m];
      for (const i of hold) v[i] = 0;
      const at = `state ${k}`;
      const results = [short, general].map((d) => {
        const [a, lambda, rate] = [new Float64Array(n), new Float64Array(m), new Float64Array(2 * n)];
        const done = d.acceleration(0, q, v, a, lambda);
        const x = v.slice();
        if (done)
          d.shift(
            Float64Array.from({ length: m }, (_, r) => 1 - r),
            x,
          );
        d.measure(q, v);
        return { done, a, lambda, rate, x, slip: d.slip, heights: d.heights, bound: d.independenceBound() };
      });
      const [a, b] = [results[0]!, results[1]!];
      expect(a.done, at).toBe(b.done);
      if (!b.done || !(general.independence(0, q, v) > INDEPENDENT)) continue;
      seen++;
      expect(apart(a.a, b.a), `accelerations, ${at}`).toBeLessThan(SAME);
      expect(apart(a.lambda, b.lambda), `multipliers, ${at}`).toBeLessThan(SAME);
      expect(apart(a.x, b.x), `shift, ${at}`).toBeLessThan(SAME);
      expect(apart(a.slip, b.slip), `slip, ${at}`).toBeLessThan(SAME);
      expect(apart(a.heights, b.heights), `heights, ${at}`).toBeLessThan(SAME);
      expect(Math.abs(a.bound / b.bound - 1), `independence, ${at}`).toBeLessThan(1e-9);
      // The same again without a copy, from y = [q, v].
      const y = Float64Array.from([...q, ...v]);
      expect(short.rate(1, y, a.rate), at).toBe(true);
      expect(a.rate, at).toEqual(Float64Array.from([...v, ...a.a]));
      expect(general.rate(1, y, b.rate), at).toBe(false);
    }
  });

  test("its tape gives the same bits as its TypeScript: the order of every sum is the tape's", () => {
    const tape = readTape(meta.id);
    const program = tape.sets[set]!;
    const direct = system.constraintSets[set]!.direct!;
    const random = seeded(SEED);
    for (let k = 0; k < 16; k++) {
      const flags = (direct.holdable ?? []).map((i) => Number(hold.includes(i)));
      const p = Float64Array.from([...drawn(random, 1), ...flags]);
      const c = new Float64Array(direct.constantCount);
      direct.prepare(p, c);
      const vector = (length: number) => Float64Array.from({ length }, () => 2 * random() - 1);
      const [q, v, f, g] = [vector(n), vector(n), vector(n), vector(program['lambda']!.length)];
      const arrays = {
        rate: new Float64Array(2 * n),
        lambda: new Float64Array(g.length),
        factors: new Float64Array(direct.factorCount),
        slip: new Float64Array(g.length),
        heights: new Float64Array(program['heights']!.length),
        shift: new Float64Array(n),
      };
      const { rate, lambda, factors, slip, heights, shift } = arrays;
      const done = direct.accelerations(Float64Array.from([...q, ...v]), c, f, rate, lambda, factors);
      direct.slip(q, v, c, slip, heights);
      direct.shift(factors, g, shift);
      const values = valuesOf(tape, { p, q, v, f, g });
      expect(values.every(Number.isFinite)).toBe(true);
      expect(c).toEqual(Float64Array.from(tape.prepare, (i) => values[i]!));
      for (const [name, array] of Object.entries(arrays))
        expect(
          array.map((x) => x + 0),
          name,
        ).toEqual(Float64Array.from(program[name]!, (i) => values[i]! + 0));
      expect(done).toBe(program['larger']!.every((i, r) => values[i]! > values[program['smaller']![r]!]!));
    }
  });

  test('is not taken where a coordinate is held that it does not know as held', () => {
    const p = Float64Array.from(meta.parameters, (x) => x.default);
    const other = n - 1 - (meta.held?.length ?? 0);
    const d = new ConstrainedSystem(system, p, set, [other], null);
    expect(d.rate(0, new Float64Array(2 * n), new Float64Array(2 * n))).toBe(false);
  });

  test('a state that is none fails with its reason', () => {
    const p = Float64Array.from(meta.parameters, (x) => x.default);
    const d = new ConstrainedSystem(system, p, set, [], null);
    const v = new Float64Array(n).fill(NaN);
    expect(d.acceleration(0, new Float64Array(n), v, new Float64Array(n), new Float64Array(d.m))).toBe(false);
    expect(d.failure).toBe('non-finite');
    expect(
      d.acceleration(0, new Float64Array(n), new Float64Array(n), new Float64Array(n), new Float64Array(d.m)),
    ).toBe(true);
    expect(d.failure).toBeNull();
  });
});

test('dependent rows are refused with their reason: a skate that lies flat', () => {
  const { short, general } = both(
    'ripstik',
    'rolling',
    Float64Array.from(systems['ripstik']!.meta.parameters, (p) => p.default),
    null,
  );
  const q = new Float64Array(10);
  // The front plate on its side, so that the caster's axle is vertical.
  q[6] = Math.PI / 2;
  for (const d of [short, general]) {
    expect(d.acceleration(0, q, new Float64Array(10), new Float64Array(10), new Float64Array(4))).toBe(false);
    expect(d.failure).toBe('constraint-singular');
    expect(d.independenceBound()).toBe(0);
    expect(d.independence(0, q, new Float64Array(10))).toBeLessThan(1e-12);
  }
});
