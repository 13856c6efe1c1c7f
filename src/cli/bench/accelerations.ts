import { deriveSystem, readSystem } from '../../core/description/index.ts';
import text from '../../core/description/templates/ripstik.ts';
import { ConstrainedSystem } from '../../core/mechanics/constrainedSystem.ts';
import { formulations } from '../../core/mechanics/formulations/formulations.ts';
import { createFormulation } from '../../core/mechanics/formulations/registry.ts';
import { Checksum, measureTogether, type MeasureOptions, type Times, type Work } from './measure.ts';
import { consistentStates, dynamicsOf, scenarioOf, type State } from './states.ts';

export const SEED = 20171208;
export const STATES = 256;

export interface AccelerationReport {
  states: number;
  seed: number;
  /** The constrained acceleration itself: the short way that the derivation has written. */
  acceleration: Times;
  /** The same the general way: evaluate, factor and solve the multipliers' equations. Older measurements have no other. */
  general?: Times;
  /** That of the same board typed as a description (docs/own-systems.md), derived here. */
  typed?: Times;
  /** y' = f(t, y) of each formulation: that, and what the formulation adds. */
  formulations: Record<string, Times>;
  /** Parts of `general`, µs. They are timed apart, so that they add up only roughly. */
  parts: { mechanics: number; constraints: number; factor: number; solve: number };
  /** Of the accelerations by multipliers, and by every formulation, at all states. */
  checksum: string;
  /** Largest difference between formulations, relative to the largest acceleration. */
  disagreement: number;
}

/** Work that goes round the states, one after another: `at(k)` is done for `count` of them. */
function around(states: number, at: (k: number) => number): Work {
  return (count) => {
    let sum = 0;
    for (let i = 0, k = 0; i < count; i++) {
      sum += at(k);
      if (++k === states) k = 0;
    }
    return sum;
  };
}

/** Microseconds per constrained acceleration of the rolling board. */
export function accelerations(options: MeasureOptions): AccelerationReport {
  const scenario = scenarioOf({ version: 1, system: 'ripstik' });
  const dynamics = dynamicsOf(scenario);
  const states = consistentStates(dynamics, STATES, SEED);
  const { checksum, disagreement } = compare(dynamics, states);
  const work: Record<string, Work> = {
    acceleration: constrainedAcceleration(dynamics, states),
    typed: constrainedAcceleration(typedBoard(dynamics), states),
    ...partsOf(dynamicsOf(scenario, 'general'), states),
    ...formulationsOf(dynamics, states),
  };
  const times = measureTogether(work, options);
  const { acceleration, general, typed, mechanics, constraints, evaluated, factored } = times;
  return {
    states: STATES,
    seed: SEED,
    acceleration: acceleration!,
    general: general!,
    typed: typed!,
    formulations: Object.fromEntries(formulations.map(({ id }) => [id, times[id]!])),
    parts: {
      mechanics: mechanics!.median,
      constraints: constraints!.median,
      factor: factored!.median - evaluated!.median,
      solve: general!.median - factored!.median,
    },
    checksum,
    disagreement,
  };
}

function typedBoard({ parameters }: ConstrainedSystem): ConstrainedSystem {
  const { model, view } = readSystem(text);
  return new ConstrainedSystem(deriveSystem(model!, view!), parameters, 'rolling', [], null);
}

function partsOf(d: ConstrainedSystem, states: readonly State[]): Record<string, Work> {
  return {
    general: constrainedAcceleration(d, states),
    mechanics: around(states.length, (k) => {
      d.system.mechanics(states[k]!.q, states[k]!.v, d.parameters, d.massMatrix, d.force);
      return d.force[3]!;
    }),
    constraints: around(states.length, (k) => {
      d.constraints!.evaluate(states[k]!.q, states[k]!.v, d.parameters, d.omega, d.gamma);
      return d.gamma[0]!;
    }),
    evaluated: around(states.length, (k) => {
      d.evaluate(0, states[k]!.q, states[k]!.v);
      return d.force[3]!;
    }),
    factored: around(states.length, (k) => {
      d.evaluate(0, states[k]!.q, states[k]!.v);
      return d.factor() ? d.massMatrix[0]! : NaN;
    }),
  };
}

/** The unit of work that everything is compared with: the acceleration at one state after another. */
export function constrainedAcceleration(dynamics: ConstrainedSystem, states: readonly State[]): Work {
  const a = new Float64Array(dynamics.n);
  const lambda = new Float64Array(dynamics.m);
  return around(states.length, (k) => {
    const { q, v } = states[k]!;
    return dynamics.acceleration(0, q, v, a, lambda) ? a[3]! : NaN;
  });
}

function formulationsOf(dynamics: ConstrainedSystem, states: readonly State[]): Record<string, Work> {
  return Object.fromEntries(
    formulations.map(({ id }) => {
      const { ys, derivative } = prepared(id, dynamics, states);
      return [id, around(states.length, (k) => derivative(ys[k]!)[3]!)];
    }),
  );
}

/** A formulation with y of every state, all in the chart of the upright board. */
function prepared(id: string, dynamics: ConstrainedSystem, states: readonly State[]) {
  const formulation = createFormulation(id, dynamics)!;
  formulation.rebase(new Float64Array(dynamics.n), new Float64Array(dynamics.n));
  const out = new Float64Array(formulation.dimension);
  const ys = states.map(({ q, v }) => {
    const y = new Float64Array(formulation.dimension);
    formulation.fromState(q, v, y);
    return y;
  });
  const derivative = (y: Float64Array): Float64Array => {
    if (!formulation.derivative(0, y, out)) throw new Error(`${id}: ${formulation.failure}`);
    return out;
  };
  return { ys, derivative, formulation };
}

/**
 * All formulations at all states, before anything is timed: the same mechanics, and one number that says which.
 * The acceleration is d/dt of v(y) = (dv/dy) y', the first n rows of the Jacobian times y': also for independent speeds.
 */
function compare(dynamics: ConstrainedSystem, states: readonly State[]): { checksum: string; disagreement: number } {
  const { n } = dynamics;
  const sum = new Checksum();
  const [a, lambda] = [new Float64Array(n), new Float64Array(dynamics.m)];
  const expected = states.map(({ q, v }) => {
    if (!dynamics.acceleration(0, q, v, a, lambda)) throw new Error(`no acceleration: ${dynamics.failure}`);
    for (const x of [...a, ...lambda]) sum.add(x);
    return a.slice();
  });
  let disagreement = 0;
  for (const { id } of formulations) {
    const { ys, derivative, formulation } = prepared(id, dynamics, states);
    const J = new Float64Array(formulation.dimension ** 2);
    ys.forEach((y, k) => {
      const rate = derivative(y).slice();
      for (const x of rate) sum.add(x);
      if (!formulation.jacobian!(0, y, J)) throw new Error(`${id}: ${formulation.failure}`);
      const error = expected[k]!.map((x, i) =>
        Math.abs(x - rate.reduce((total, r, j) => total + J[i * rate.length + j]! * r, 0)),
      );
      disagreement = Math.max(disagreement, Math.max(...error) / Math.max(...expected[k]!.map(Math.abs)));
    });
  }
  return { checksum: sum.text, disagreement };
}
