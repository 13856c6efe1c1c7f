import { describe, expect, test } from 'vitest';
import { cases } from '../../../src/core/systems/registry.ts';
import { Projection } from '../../../src/core/mechanics/projection.ts';
import { StabilizedDae } from '../../../src/core/mechanics/stabilizedDae.ts';
import { Ida } from '../../../src/core/integrators/multistep/ida.ts';
import { runOf, seeded } from '../../helpers.ts';
import { mechanicsOf } from '../../mechanics.ts';
import { distance, run } from './problems.ts';

/** A scenario's mechanics as a DAE, with its start. */
function daeOf(raw: unknown) {
  const mechanics = mechanicsOf(raw);
  const dae = new StabilizedDae(mechanics.dynamics);
  const y = new Float64Array(dae.dimension);
  dae.fromState(mechanics.q, mechanics.v, y);
  return { ...mechanics, dae, y };
}

const leaning = { version: 1, system: 'ripstik', initial: { X_dot: 1, alpha: '0.5 deg' }, duration: 0.5 };
const hanging = { ...(cases.find((c) => c.id === 'hanging')!.scenario as object), duration: 2 };
const driven = {
  ...leaning,
  initial: { X_dot: 1 },
  control: {
    type: 'track',
    reference: { tau_fp: '10 deg * sin(2*pi*1.5*t)', tau_bp: '-10 deg * sin(2*pi*1.5*t)' },
    kp: 60,
    kd: 3,
  },
};

describe('mechanics as a stabilized DAE', () => {
  test.each([
    { name: 'leaning', raw: leaning },
    { name: 'hanging', raw: hanging },
    { name: 'driven', raw: driven },
  ])('$name: the start is consistent, and the Jacobian is that of the residual', ({ raw }) => {
    const { dae, y } = daeOf(raw);
    const size = dae.dimension;
    const yp = new Float64Array(size);
    const residual = new Float64Array(size);
    expect(dae.start(0, y, yp)).toBe(true);
    dae.residual(0, y, yp, residual);
    expect(Math.max(...residual.map(Math.abs))).toBeLessThan(1e-11);

    const { held } = daeOf(raw).dynamics;
    const random = seeded(7);
    const fixed = (i: number): boolean => held.some((h) => i === h || i === 10 + h);
    for (let i = 0; i < size; i++) {
      if (fixed(i)) continue;
      y[i]! += 0.1 * (random() - 0.5);
      if (dae.differential[i]) yp[i]! += random() - 0.5;
    }
    const cj = 3;
    const exact = new Float64Array(size * size);
    expect(dae.jacobian(0.1, y, yp, cj, exact)).toBe(true);
    const [up, down] = [new Float64Array(size), new Float64Array(size)];
    for (let j = 0; j < size; j++) {
      if (fixed(j)) continue;
      const moved = (sign: number, out: Float64Array): void => {
        const [z, zp] = [y.slice(), yp.slice()];
        z[j]! += sign * 1e-5;
        if (dae.differential[j]) zp[j]! += sign * cj * 1e-5;
        dae.residual(0.1, z, zp, out);
      };
      moved(1, up);
      moved(-1, down);
      for (let i = 0; i < size; i++) {
        const difference = (up[i]! - down[i]!) / 2e-5;
        expect(Math.abs(exact[i * size + j]! - difference), `row ${i}, column ${j}`).toBeLessThan(
          1e-6 * Math.max(1, Math.abs(difference)),
        );
      }
    }
  });

  test.each([
    { name: 'leaning', raw: leaning },
    { name: 'hanging', raw: hanging },
    { name: 'driven', raw: driven },
  ])('$name: agrees with dopri5 at rtol 1e-11 within 1e-6, with and without projection', ({ raw }) => {
    const { columns, end } = runOf({ ...raw, method: { name: 'dopri5', rtol: 1e-11, atol: 1e-13 } });
    expect(end.reason).toBe('end');
    for (const projected of [false, true]) {
      const { scenario, dynamics, dae, y, q, v, n } = daeOf(raw);
      const projection = new Projection(dynamics);
      const stepper = new Ida(dae, { rtol: 1e-9, atol: 1e-11 });
      stepper.reset(0, y);
      let residual = 0;
      expect(
        run(stepper, scenario.duration, () => {
          dae.toState(stepper.y, q, v);
          residual = Math.max(residual, projection.residual(q, v));
          if (!projected) return;
          projection.project(stepper.t, q, v);
          dae.fromState(q, v, stepper.y);
          stepper.stateChanged();
        }),
      ).toBeNull();
      const last = [...columns.values()].slice(1, 1 + 2 * n).map((c) => c.at(-1)!);
      const off = distance(stepper.y.subarray(0, 2 * n), last);
      expect(off).toBeLessThan(1e-6);
      expect(residual).toBeLessThan(1e-10);
      for (const i of dynamics.held) expect([stepper.y[i], stepper.y[n + i]]).toEqual([daeOf(raw).q[i], 0]);
    }
  });
});

test('at rtol 1e-12 rounding that grows near dependent constraints does not stop the run', () => {
  // The released board runs on through the ground; at 2.036 s its step used to shrink to nothing.
  const { scenario } = cases.find((c) => c.id === 'released')!;
  const { end, counts } = runOf({
    ...scenario,
    duration: 2.1,
    events: { touchdown: 'ignore' },
    method: { name: 'ida', rtol: 1e-12, atol: 1e-14 },
  });
  expect(end.reason).toBe('end');
  expect(counts.rejected).toBeLessThan(0.01 * counts.steps);
});
