// Every built-in system, typed: the derivation in the program and SymPy's are two ways to the same numbers.
import { describe, expect, test } from 'vitest';
import { deriveSystem, readSystem } from '../../../src/core/description/index.ts';
import { templates } from '../../../src/core/description/templates.ts';
import { ConstrainedSystem } from '../../../src/core/mechanics/constrainedSystem.ts';
import type { System } from '../../../src/core/model/system.ts';
import { systems } from '../../../src/core/systems/all.ts';
import { seeded } from '../../helpers.ts';

const STATES = 4;
const TOLERANCE = 1e-12;
const SEED = 1128;

async function typed(id: string): Promise<System> {
  const { default: text } = await templates.find((template) => template.id === id)!.load();
  const { model, view, faults } = readSystem(text);
  expect(faults.map(({ message }) => message)).toEqual([]);
  return deriveSystem(model!, view!);
}

interface State {
  q: Float64Array;
  v: Float64Array;
  a: Float64Array;
  p: Float64Array;
  lambda: Float64Array;
}

/** All parameters drawn around their defaults: those that are 0 by default too. */
function stateOf(system: System, random: () => number): State {
  const { coordinates, parameters } = system.meta;
  const draw = (): number => 2 * random() - 1;
  return {
    q: Float64Array.from(coordinates, (c) => (c.rest ?? 0) + 0.6 * draw()),
    v: Float64Array.from(coordinates, () => 2 * draw()),
    a: Float64Array.from(coordinates, () => 2 * draw()),
    lambda: Float64Array.from({ length: 8 }, () => 5 * draw()),
    p: Float64Array.from(parameters, ({ default: x }) => (x === 0 ? random() : x * (0.8 + 0.4 * random()))),
  };
}

function close(what: string, ours: Float64Array, theirs: Float64Array): void {
  const size = Math.max(1, ...theirs.map(Math.abs));
  const worst = ours.reduce((most, x, i) => Math.max(most, Math.abs(x - theirs[i]!)), 0);
  expect(worst / size, `${what}, seed ${SEED}: ${[...ours]} is not ${[...theirs]}`).toBeLessThan(TOLERANCE);
}

type Evaluate = (...outputs: Float64Array[]) => void;

/** Two functions on outputs of these lengths. */
function same(what: string, lengths: readonly number[], ours: Evaluate, theirs: Evaluate): void {
  const [one, other] = [ours, theirs].map((f) => {
    const outputs = lengths.map((length) => new Float64Array(length));
    f(...outputs);
    return outputs;
  });
  lengths.forEach((_, k) => close(`${what} ${k}`, one![k]!, other![k]!));
}

describe.each(templates.map(({ id }) => id).filter((id) => id in systems))('%s', (id) => {
  test('agrees with the generated code in everything', async () => {
    const [own, built] = [await typed(id), systems[id]!];
    const n = built.meta.coordinates.length;
    expect(own.meta.coordinates.map(({ name, rest }) => [name, rest ?? 0])).toEqual(
      built.meta.coordinates.map(({ name, rest }) => [name, expect.closeTo(rest ?? 0, 14)]),
    );
    expect(own.meta.parameters.map(({ name, default: x }) => [name, x])).toEqual(
      built.meta.parameters.map(({ name, default: x }) => [name, expect.closeTo(x, 12)]),
    );
    expect(own.meta.inputs.map(({ name, column }) => [name, column])).toEqual(
      built.meta.inputs.map(({ name, column }) => [name, column]),
    );
    expect(own.meta.constraintSets.map((set) => set.id)).toEqual(
      expect.arrayContaining(built.meta.constraintSets.map((set) => set.id)),
    );
    const random = seeded(SEED);
    for (let k = 0; k < STATES; k++) {
      const { q, v, a, p, lambda } = stateOf(built, random);
      const nn = n * n;
      same(
        'mechanics',
        [nn, n],
        (M, h) => own.mechanics(q, v, p, M!, h!),
        (M, h) => built.mechanics(q, v, p, M!, h!),
      );
      same(
        'jacobians',
        [nn, nn],
        (dq, dv) => own.jacobians(q, v, a, p, dq!, dv!),
        (dq, dv) => built.jacobians(q, v, a, p, dq!, dv!),
      );
      same(
        'energy',
        [2],
        (e) => own.energy(q, v, p, e!),
        (e) => built.energy(q, v, p, e!),
      );
      if (built.firstOrder) {
        same(
          'rate',
          [n],
          (f) => own.firstOrder!.rate(q, p, f!),
          (f) => built.firstOrder!.rate(q, p, f!),
        );
        same(
          'slope',
          [nn],
          (f) => own.firstOrder!.jacobian(q, p, f!),
          (f) => built.firstOrder!.jacobian(q, p, f!),
        );
      }
      if (own.meta.bodies.length === built.meta.bodies.length)
        same(
          'poses',
          [12 * built.meta.bodies.length],
          (x) => own.poses(q, p, x!),
          (x) => built.poses(q, p, x!),
        );
      for (const [name, theirs] of Object.entries(built.constraintSets)) {
        const ours = own.constraintSets[name]!;
        const [m, mn] = [theirs.rows, theirs.rows * n];
        expect(ours.rows).toBe(m);
        const multipliers = lambda.subarray(0, m);
        same(
          `${name}: rows`,
          [mn, m],
          (O, g) => ours.evaluate(q, v, p, O!, g!),
          (O, g) => theirs.evaluate(q, v, p, O!, g!),
        );
        same(
          `${name}: slopes`,
          [nn, mn, mn, mn],
          (...x) => ours.jacobians(q, v, a, multipliers, p, x[0]!, x[1]!, x[2]!, x[3]!),
          (...x) => theirs.jacobians(q, v, a, multipliers, p, x[0]!, x[1]!, x[2]!, x[3]!),
        );
        expect(ours.contact?.rows).toEqual(theirs.contact?.rows);
        expect(ours.contact?.solveFor).toEqual(theirs.contact?.solveFor);
        if (theirs.contact)
          same(
            `${name}: heights`,
            [theirs.contact.count],
            (x) => ours.contact!.heights(q, p, x!),
            (x) => theirs.contact!.heights(q, p, x!),
          );
      }
    }
  });

  test('moves alike, by the short way, the general way and with coordinates held', async () => {
    const [own, built] = [await typed(id), systems[id]!];
    const n = built.meta.coordinates.length;
    const random = seeded(SEED + 1);
    for (const { id: set } of built.meta.constraintSets) {
      for (const hold of [[], [Math.floor(random() * n)]]) {
        for (let k = 0; k < 12; k++) {
          const { q, v, p } = stateOf(built, random);
          for (const i of hold) v[i] = 0;
          const [ours, general, theirs] = [
            [own, 'shortest'],
            [own, 'general'],
            [built, 'general'],
          ].map(([system, way]) => {
            const dynamics = new ConstrainedSystem(system as System, p, set, hold, null, way as 'general');
            const [a, lambda] = [new Float64Array(n), new Float64Array(dynamics.m)];
            return dynamics.acceleration(0, q, v, a, lambda) ? Float64Array.of(...a, ...lambda) : null;
          });
          if (!theirs || Math.max(...theirs.map(Math.abs)) > 1e4) continue;
          const size = Math.max(1, ...theirs.map(Math.abs));
          for (const found of [ours!, general!]) {
            const worst = found.reduce((most, x, i) => Math.max(most, Math.abs(x - theirs[i]!)), 0);
            expect(worst / size, `${set}, hold ${hold}, seed ${SEED + 1}, state ${k}`).toBeLessThan(1e-10);
          }
        }
      }
    }
  });
});
