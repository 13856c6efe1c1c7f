import { describe, expect, test } from 'vitest';
import { ConstrainedSystem } from '../../src/core/dynamics/constrainedSystem.ts';
import { Projection } from '../../src/core/dynamics/projection.ts';
import { cholesky } from '../../src/core/linalg/dense.ts';
import { systems } from '../../src/core/systems/registry.ts';
import { seeded } from '../helpers.ts';

const system = systems['ripstik']!;
const n = 10;
const SEED = 20170411;

/** A state and parameters drawn from a seed: every spring and loss on, so that every term is tried. */
function draw(seed: number) {
  const random = seeded(seed);
  const between = (a: number, b: number) => a + (b - a) * random();
  const q = Float64Array.from({ length: n }, (_, i) => (i < 3 ? between(-0.5, 0.5) : i === 4 ? between(-0.4, 0.4) : between(-0.9, 0.9)));
  const v = Float64Array.from({ length: n }, () => between(-2, 2));
  const p = Float64Array.from(system.meta.parameters, (m) => (m.default === 0 ? between(0.1, 2) : m.default * between(0.7, 1.3)));
  return { q, v, p, a: Float64Array.from({ length: n }, () => between(-5, 5)), lambda: Float64Array.from({ length: 4 }, () => between(-20, 20)), random };
}

const seeds = Array.from({ length: 20 }, (_, i) => SEED + i);

/** Central difference of a vector function in the direction of one entry of x. */
function difference(f: (x: Float64Array) => Float64Array, x: Float64Array, k: number): Float64Array {
  const step = 1e-6;
  const up = x.slice();
  const down = x.slice();
  up[k]! += step;
  down[k]! -= step;
  const a = f(up);
  const b = f(down);
  return a.map((y, i) => (y - b[i]!) / (2 * step));
}

function expectClose(actual: number, expected: number, what: string, scale = 1) {
  expect(Math.abs(actual - expected) / Math.max(scale, Math.abs(expected)), what).toBeLessThan(2e-7);
}

describe.each(seeds)('seed %i', (seed) => {
  test('the mass matrix is symmetric and positive definite', () => {
    const { q, v, p } = draw(seed);
    const M = new Float64Array(n * n);
    system.mechanics(q, v, p, M, new Float64Array(n));
    for (let i = 0; i < n; i++) for (let j = 0; j < i; j++) expect(M[i * n + j]).toBe(M[j * n + i]);
    expect(cholesky(M, n)).toBe(0);
  });

  test('Jacobians of M a - h are its finite differences', () => {
    const { q, v, p, a } = draw(seed);
    const dq = new Float64Array(n * n);
    const dv = new Float64Array(n * n);
    system.jacobians(q, v, a, p, dq, dv);
    const residual = (q: Float64Array, v: Float64Array): Float64Array => {
      const M = new Float64Array(n * n);
      const h = new Float64Array(n);
      system.mechanics(q, v, p, M, h);
      return h.map((hi, i) => a.reduce((sum, aj, j) => sum + M[i * n + j]! * aj, 0) - hi);
    };
    for (let k = 0; k < n; k++) {
      difference((x) => residual(x, v), q, k).forEach((d, i) => expectClose(dq[i * n + k]!, d, `dq[${i}][${k}]`, 10));
      difference((x) => residual(q, x), v, k).forEach((d, i) => expectClose(dv[i * n + k]!, d, `dv[${i}][${k}]`, 10));
    }
  });

  test.each(['rolling', 'report'])('%s: Jacobians of force, rate and velocity are their finite differences', (id) => {
    const { q, v, p, a, lambda } = draw(seed);
    const set = system.constraintSets[id]!;
    const m = set.rows;
    const [forceQ, rateQ, rateV, velocityQ] = [n * n, m * n, m * n, m * n].map((size) => new Float64Array(size)) as [Float64Array, Float64Array, Float64Array, Float64Array];
    set.jacobians(q, v, a, lambda, p, forceQ, rateQ, rateV, velocityQ);
    const at = (q: Float64Array, v: Float64Array) => {
      const omega = new Float64Array(m * n);
      const gamma = new Float64Array(m);
      set.evaluate(q, v, p, omega, gamma);
      const times = (x: Float64Array) => Float64Array.from({ length: m }, (_, r) => x.reduce((sum, xi, i) => sum + omega[r * n + i]! * xi, 0));
      return {
        force: Float64Array.from({ length: n }, (_, i) => lambda.reduce((sum, l, r) => sum + omega[r * n + i]! * l, 0)),
        rate: times(a).map((x, r) => x + gamma[r]!),
        velocity: times(v),
      };
    };
    for (let k = 0; k < n; k++) {
      difference((x) => at(x, v).force, q, k).forEach((d, i) => expectClose(forceQ[i * n + k]!, d, `forceQ[${i}][${k}]`, 10));
      difference((x) => at(x, v).rate, q, k).forEach((d, i) => expectClose(rateQ[i * n + k]!, d, `rateQ[${i}][${k}]`, 10));
      difference((x) => at(q, x).rate, v, k).forEach((d, i) => expectClose(rateV[i * n + k]!, d, `rateV[${i}][${k}]`, 10));
      difference((x) => at(x, v).velocity, q, k).forEach((d, i) => expectClose(velocityQ[i * n + k]!, d, `velocityQ[${i}][${k}]`, 10));
    }
  });

  test.each(['rolling', 'report', 'none'])('%s: energy changes at the power of inputs less losses; multipliers do no work', (id) => {
    const { q, v, p, random } = draw(seed);
    const push = Float64Array.from({ length: n }, () => random() - 0.5);
    const d = new ConstrainedSystem(system, p, id, [], (_t, _q, _v, force) => push.forEach((f, i) => (force[i]! += f)));
    // A random state is far from the ground: the projection is local, so it is repeated until it has arrived.
    const projection = new Projection(d);
    for (let i = 0; i < 30; i++) expect(projection.project(0, q, v)).toBe(true);
    expect(projection.residual(q, v)).toBeLessThan(1e-12);
    const a = new Float64Array(n);
    const lambda = new Float64Array(d.m);
    expect(d.acceleration(0, q, v, a, lambda)).toBe(true);
    const energies = new Float64Array(2);
    const along = (h: number) => {
      const x = q.map((qi, i) => qi + h * v[i]! + (h * h * a[i]!) / 2);
      system.energy(x, v.map((vi, i) => vi + h * a[i]!), p, energies);
      return energies[0]! + energies[1]!;
    };
    const rate = (along(1e-6) - along(-1e-6)) / 2e-6;
    const free = new Float64Array(n);
    const lossless = p.map((x, i) => (['torsionDamping', 'jointDamping', 'casterDamping', 'wheelDrag'].includes(system.meta.parameters[i]!.name) ? 0 : x));
    const h = new Float64Array(n);
    const M = new Float64Array(n * n);
    system.mechanics(q, v, p, M, h);
    system.mechanics(q, v, lossless, M, free);
    let power = 0;
    for (let i = 0; i < n; i++) power += v[i]! * (push[i]! + h[i]! - free[i]!);
    expect(Math.abs(rate - power) / Math.max(1, Math.abs(power))).toBeLessThan(1e-5);
  });

  test.each(['rolling', 'none'])('%s: mirrored states have mirrored accelerations; a shifted and turned world changes nothing', (id) => {
    const { q, v, p } = draw(seed);
    const d = new ConstrainedSystem(system, p, id, [], null);
    const acceleration = (q: Float64Array, v: Float64Array) => {
      const a = new Float64Array(n);
      expect(d.acceleration(0, q, v, a, new Float64Array(d.m))).toBe(true);
      return a;
    };
    const a = acceleration(q, v);
    const scale = Math.max(...a.map(Math.abs));
    const mirrored = new Set(['Y', 'alpha', 'theta', 'alpha_fp', 'alpha_bp', 'theta_fc', 'theta_bc']);
    const flip = (x: Float64Array) => x.map((xi, i) => (mirrored.has(system.meta.coordinates[i]!.name) ? -xi : xi));
    acceleration(flip(q), flip(v)).forEach((ai, i) => expect(Math.abs(ai - flip(a)[i]!) / scale).toBeLessThan(1e-9));

    const angle = 0.7;
    const turn = (x: Float64Array, shift: number) => {
      const out = x.slice();
      out[0] = Math.cos(angle) * x[0]! - Math.sin(angle) * x[1]! + shift;
      out[1] = Math.sin(angle) * x[0]! + Math.cos(angle) * x[1]! - shift;
      return out;
    };
    const moved = turn(q, 3);
    moved[5]! += angle;
    const turned = turn(a, 0);
    acceleration(moved, turn(v, 0)).forEach((ai, i) => expect(Math.abs(ai - turned[i]!) / scale).toBeLessThan(1e-9));
  });
});
