// What holds of every system in the registry, at states and parameters drawn from seeds that a failure prints.
import { describe, expect, test } from 'vitest';
import { ConstrainedSystem } from '../../src/core/mechanics/constrainedSystem.ts';
import { Projection } from '../../src/core/mechanics/projection.ts';
import { cholesky } from '../../src/core/linalg/dense.ts';
import { systems } from '../../src/core/systems/all.ts';
import { systemViews } from '../../src/core/systems/registry.ts';
import type { System } from '../../src/core/model/system.ts';
import { seeded } from '../helpers.ts';

interface Symmetry {
  /** Coordinates that a shifted world adds to, one weight each; they stand in no equation. */
  shift: Readonly<Record<string, number>>;
  /** Place and heading, where a turned world changes nothing. */
  turn?: readonly [x: string, y: string, heading: string];
  /** Coordinates that change sign in a mirror, where the mirrored motion is one too. */
  mirror?: readonly string[];
  /** Parameters of losses. */
  losses?: readonly string[];
}

const symmetries: Readonly<Record<string, Symmetry>> = {
  ripstik: {
    shift: { X: 1, Y: -2 },
    turn: ['X', 'Y', 'theta'],
    mirror: ['Y', 'alpha', 'theta', 'alpha_fp', 'alpha_bp', 'theta_fc', 'theta_bc'],
    losses: ['torsionDamping', 'jointDamping', 'casterDamping', 'wheelDrag'],
  },
  'ripstik-rider': {
    shift: { X: 1, Y: -2 },
    turn: ['X', 'Y', 'theta'],
    mirror: ['Y', 'alpha', 'theta', 'alpha_fp', 'alpha_bp', 'theta_fc', 'theta_bc', 'beta', 'twist'],
    losses: [
      'torsionDamping',
      'jointDamping',
      'casterDamping',
      'wheelDrag',
      'ankleDamping',
      'legDamping',
      'hipDamping',
    ],
  },
  // Fixed to the world by its pivot; its steering axis is tilted.
  'caster-rotation': { shift: {}, mirror: ['theta_c'] },
  'cart-pendulum': { shift: { X: 3 } },
  'rolling-wheel': { shift: { X: 1, Y: -2, phi: 5 }, turn: ['X', 'Y', 'theta'], mirror: ['Y', 'theta'] },
  'stiff-decay': { shift: {}, mirror: ['y'] },
  'wheel-pendulum': { shift: { X: 3, phi: 5 } },
  'casterboard-robot': {
    shift: { x: 1, y: -2 },
    turn: ['x', 'y', 'theta'],
    mirror: ['y', 'theta', 'phi_f', 'phi_r'],
    losses: ['c'],
  },
  bicycle: {
    shift: { x: 1, y: -2, rear_spin: 5, front_spin: 3 },
    turn: ['x', 'y', 'yaw'],
    mirror: ['y', 'yaw', 'roll', 'steer'],
  },
  'bicycle-rider': {
    shift: { x: 1, y: -2, rear_spin: 5, front_spin: 3 },
    turn: ['x', 'y', 'yaw'],
    mirror: ['y', 'yaw', 'roll', 'steer', 'lean'],
    losses: ['leanDamping'],
  },
  'chaplygin-sleigh': { shift: { x: 1, y: -2 }, turn: ['x', 'y', 'theta'], mirror: ['y', 'theta'] },
};

const SEED = 20170411;
const cases = Object.entries(systems).flatMap(([id, system]) =>
  Array.from({ length: id === 'ripstik' ? 20 : 8 }, (_, i) => ({ id, system, seed: SEED + i })),
);

/** A state and parameters, every spring and loss on, so that every term is tried. Pitch stays clear of its singular point. */
function draw(system: System, seed: number) {
  const random = seeded(seed);
  const between = (a: number, b: number) => a + (b - a) * random();
  const { coordinates, parameters } = system.meta;
  const n = coordinates.length;
  const q = Float64Array.from(coordinates, ({ kind, name }) =>
    kind === 'length' ? between(-0.5, 0.5) : ['psi', 'pitch'].includes(name) ? between(-0.4, 0.4) : between(-0.9, 0.9),
  );
  const v = Float64Array.from({ length: n }, () => between(-2, 2));
  const p = Float64Array.from(parameters, (m) =>
    Math.min(m.max ?? Infinity, m.default === 0 ? between(0.1, 2) : m.default * between(0.7, 1.3)),
  );
  return { n, q, v, p, a: Float64Array.from({ length: n }, () => between(-5, 5)), between };
}

/** Central difference of a vector function in the direction of one entry of x. */
function difference(f: (x: Float64Array) => Float64Array, x: Float64Array, k: number): Float64Array {
  const step = 1e-6;
  const [up, down] = [x.slice(), x.slice()];
  up[k]! += step;
  down[k]! -= step;
  const low = f(down);
  return f(up).map((y, i) => (y - low[i]!) / (2 * step));
}

/** A Jacobian (rows x x.length) and the differences of its function. */
function expectDerivative(jacobian: Float64Array, f: (x: Float64Array) => Float64Array, x: Float64Array, what: string) {
  for (let k = 0; k < x.length; k++) {
    difference(f, x, k).forEach((d, i) => {
      expect(Math.abs(jacobian[i * x.length + k]! - d) / Math.max(10, Math.abs(d)), `${what}[${i}][${k}]`).toBeLessThan(
        2e-7,
      );
    });
  }
}

const vector = (length: number) => new Float64Array(length);
const mechanicsOf = (system: System, q: Float64Array, v: Float64Array, p: Float64Array) => {
  const [M, h] = [vector(q.length ** 2), vector(q.length)];
  system.mechanics(q, v, p, M, h);
  return { M, h };
};

test('every system is known to the views by the same id and names its symmetries here', () => {
  expect(Object.keys(systemViews).sort()).toEqual(Object.keys(systems).sort());
  expect(Object.keys(systems).filter((id) => !symmetries[id])).toEqual([]);
  for (const [id, system] of Object.entries(systems)) {
    expect(system.meta.id).toBe(id);
    expect(system.meta.constraintSets.map((s) => s.id).filter((s) => s !== 'none')).toEqual(
      Object.keys(system.constraintSets),
    );
    if (system.meta.order !== 1) expect(system.meta.parameters.map((p) => p.name)).toContain('gravity');
  }
});

describe.each(cases)('$id, seed $seed', ({ id, system, seed }) => {
  const sets = system.meta.constraintSets.map((s) => s.id);

  test('the mass matrix is symmetric, positive definite, and that of the kinetic energy', () => {
    const { n, q, v, p } = draw(system, seed);
    const { M } = mechanicsOf(system, q, v, p);
    for (let i = 0; i < n; i++) for (let j = 0; j < i; j++) expect(M[i * n + j]).toBe(M[j * n + i]);
    if (!system.firstOrder) {
      const energies = vector(2);
      system.energy(q, v, p, energies);
      const twice = v.reduce((sum, vi, i) => sum + v.reduce((part, vj, j) => part + vi * M[i * n + j]! * vj, 0), 0);
      expect(Math.abs(twice / 2 - energies[0]!)).toBeLessThan(1e-12 * Math.max(1, energies[0]!));
    }
    expect(cholesky(M, n)).toBe(0);
  });

  test('Jacobians of M a - h are its finite differences', () => {
    const { n, q, v, p, a } = draw(system, seed);
    const [dq, dv] = [vector(n * n), vector(n * n)];
    system.jacobians(q, v, a, p, dq, dv);
    const residual = (q: Float64Array, v: Float64Array): Float64Array => {
      const { M, h } = mechanicsOf(system, q, v, p);
      return h.map((hi, i) => a.reduce((sum, aj, j) => sum + M[i * n + j]! * aj, 0) - hi);
    };
    expectDerivative(dq, (x) => residual(x, v), q, 'dq');
    expectDerivative(dv, (x) => residual(q, x), v, 'dv');
  });

  test.each(Object.keys(system.constraintSets))(
    '%s: Jacobians of force, rate and velocity are their finite differences',
    (name) => {
      const { n, q, v, p, a, between } = draw(system, seed);
      const set = system.constraintSets[name]!;
      const m = set.rows;
      const lambda = Float64Array.from({ length: m }, () => between(-20, 20));
      const [forceQ, rateQ, rateV, velocityQ] = [vector(n * n), vector(m * n), vector(m * n), vector(m * n)];
      set.jacobians(q, v, a, lambda, p, forceQ, rateQ, rateV, velocityQ);
      const at = (q: Float64Array, v: Float64Array) => {
        const [omega, gamma] = [vector(m * n), vector(m)];
        set.evaluate(q, v, p, omega, gamma);
        const times = (x: Float64Array) =>
          Float64Array.from({ length: m }, (_, r) => x.reduce((sum, xi, i) => sum + omega[r * n + i]! * xi, 0));
        const force = Float64Array.from({ length: n }, (_, i) =>
          lambda.reduce((sum, l, r) => sum + omega[r * n + i]! * l, 0),
        );
        return { force, velocity: times(v), rate: times(a).map((x, r) => x + gamma[r]!), gamma };
      };
      expectDerivative(forceQ, (x) => at(x, v).force, q, 'forceQ');
      expectDerivative(rateQ, (x) => at(x, v).rate, q, 'rateQ');
      expectDerivative(rateV, (x) => at(q, x).rate, v, 'rateV');
      expectDerivative(velocityQ, (x) => at(x, v).velocity, q, 'velocityQ');
      // gamma is the rate of Omega v while q moves with v.
      at(q, v).gamma.forEach((g, r) => {
        const along = v.reduce((sum, vk, k) => sum + velocityQ[r * n + k]! * vk, 0);
        expect(Math.abs(g - along), `gamma[${r}]`).toBeLessThan(1e-11 * Math.max(1, Math.abs(g)));
      });
    },
  );

  test.each(Object.keys(system.constraintSets))('%s: both at once are the two of them', (name) => {
    const { n, q, v, p } = draw(system, seed);
    const set = system.constraintSets[name]!;
    const parts = [vector(n * n), vector(n), vector(set.rows * n), vector(set.rows)] as const;
    const whole = [vector(n * n), vector(n), vector(set.rows * n), vector(set.rows)] as const;
    system.mechanics(q, v, p, parts[0], parts[1]);
    set.evaluate(q, v, p, parts[2], parts[3]);
    set.dynamics?.(q, v, p, ...whole);
    if (set.dynamics)
      parts.forEach((part, k) =>
        part.forEach((x, i) => expect(Math.abs(x - whole[k]![i]!)).toBeLessThan(1e-12 * Math.max(1, Math.abs(x)))),
      );
  });

  // A first-order system has no energy.
  test.each(system.firstOrder ? [] : sets)(
    '%s: energy changes at the power of inputs less losses; multipliers do no work',
    (name) => {
      const { n, q, v, p, between } = draw(system, seed);
      const push = Float64Array.from({ length: n }, () => between(-0.5, 0.5));
      const d = new ConstrainedSystem(system, p, name, [], (_t, _q, _v, force) =>
        push.forEach((f, i) => (force[i]! += f)),
      );
      // A random state is far from the ground: the projection is local, so it is repeated until it has arrived.
      const projection = new Projection(d);
      for (let i = 0; i < 30; i++) expect(projection.project(0, q, v)).toBe(true);
      expect(projection.residual(q, v)).toBeLessThan(1e-12);
      const [a, lambda] = [vector(n), vector(d.m)];
      expect(d.acceleration(0, q, v, a, lambda)).toBe(true);
      const work = lambda.reduce(
        (sum, l, r) => sum + l * v.reduce((part, vi, i) => part + d.omega[r * n + i]! * vi, 0),
        0,
      );
      expect(Math.abs(work)).toBeLessThan(1e-11 * Math.max(1, ...lambda.map(Math.abs)));
      const energies = vector(2);
      const along = (h: number) => {
        system.energy(
          q.map((qi, i) => qi + h * v[i]! + (h * h * a[i]!) / 2),
          v.map((vi, i) => vi + h * a[i]!),
          p,
          energies,
        );
        return energies[0]! + energies[1]!;
      };
      // Of fourth order: stiff ankles bend the energy within the step.
      const slope = (h: number) => (along(h) - along(-h)) / (2 * h);
      const rate = (4 * slope(1e-6) - slope(2e-6)) / 3;
      const losses = symmetries[id]!.losses ?? [];
      const lossless = p.map((x, i) => (losses.includes(system.meta.parameters[i]!.name) ? 0 : x));
      const { h } = mechanicsOf(system, q, v, p);
      const free = mechanicsOf(system, q, v, lossless).h;
      const power = v.reduce((sum, vi, i) => sum + vi * (push[i]! + h[i]! - free[i]!), 0);
      expect(Math.abs(rate - power) / Math.max(1, Math.abs(power), ...lambda.map(Math.abs))).toBeLessThan(1e-5);
      if (losses.length > 0) expect(v.reduce((sum, vi, i) => sum + vi * (h[i]! - free[i]!), 0)).toBeLessThan(0);
    },
  );

  test.each(system.firstOrder ? [system.firstOrder] : [])(
    'the rate has its derivative, and is what the mechanics differentiate',
    ({ rate, jacobian }) => {
      const { n, q, p } = draw(system, seed);
      const [f, slope] = [vector(n), vector(n * n)];
      const rateAt = (x: Float64Array) => (rate(x, p, f), f.slice());
      jacobian(q, p, slope);
      expectDerivative(slope, rateAt, q, 'rate');
      const v = rateAt(q);
      mechanicsOf(system, q, v, p).h.forEach((h, i) =>
        expect(h).toBeCloseTo(
          v.reduce((sum, vk, k) => sum + slope[i * n + k]! * vk, 0),
          10,
        ),
      );
    },
  );

  // The report's rows hold the world's Y, which turns with no one.
  test.each(sets.filter((name) => name !== 'report'))(
    '%s: mirrored states have mirrored accelerations; a shifted and turned world changes nothing',
    (name) => {
      const { n, q, v, p } = draw(system, seed);
      const { shift, turn, mirror } = symmetries[id]!;
      const index = (coordinate: string) => system.meta.coordinates.findIndex((c) => c.name === coordinate);
      const d = new ConstrainedSystem(system, p, name, [], null);
      const acceleration = (q: Float64Array, v: Float64Array) => {
        const a = vector(n);
        expect(d.acceleration(0, q, v, a, vector(d.m))).toBe(true);
        return a;
      };
      const a = acceleration(q, v);
      const scale = Math.max(1e-3, ...a.map(Math.abs));
      const expectSame = (actual: Float64Array, expected: Float64Array) =>
        actual.forEach((ai, i) => expect(Math.abs(ai - expected[i]!) / scale).toBeLessThan(1e-9));

      const flip = (x: Float64Array) =>
        x.map((xi, i) => (mirror?.includes(system.meta.coordinates[i]!.name) ? -xi : xi));
      if (mirror) expectSame(acceleration(flip(q), flip(v)), flip(a));

      const moved = q.slice();
      for (const [coordinate, by] of Object.entries(shift)) moved[index(coordinate)]! += by;
      expectSame(acceleration(moved, v), a);

      if (!turn) return;
      const angle = 0.7;
      const [x, y, heading] = turn.map(index) as [number, number, number];
      const turned = (from: Float64Array) => {
        const out = from.slice();
        out[x] = Math.cos(angle) * from[x]! - Math.sin(angle) * from[y]!;
        out[y] = Math.sin(angle) * from[x]! + Math.cos(angle) * from[y]!;
        return out;
      };
      const there = turned(q);
      there[heading]! += angle;
      expectSame(acceleration(there, turned(v)), turned(a));
    },
  );
});
