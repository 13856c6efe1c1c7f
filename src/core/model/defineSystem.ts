import {
  parameterIndex,
  type ConstraintSet,
  type ConstraintSetMeta,
  type DirectDynamics,
  type System,
  type SystemView,
} from './system.ts';
import type { Tape } from './tape.ts';

/** What the derivation writes for one system, by the names that it gives; `<set>Constraints` and the like are looked up. */
export interface GeneratedEquations extends Pick<System, 'mechanics' | 'energy'> {
  readonly rate?: NonNullable<System['firstOrder']>['rate'];
  readonly rateJacobian?: NonNullable<System['firstOrder']>['jacobian'];
  /** `accelerations.generated.ts`: `prepare`, `constantCount`, and by constraint set `<id>Accelerations` and the like. */
  readonly direct?: object;
}

/** `jacobians.generated.ts` of one system: those of the mechanics and, by name, of constraint sets and optional forces. */
export type GeneratedJacobians = Pick<System, 'jacobians' | 'poseJacobian'>;

type Named = Readonly<Record<string, unknown>>;
type Force = (q: Float64Array, v: Float64Array, p: Float64Array, out: Float64Array) => void;
type ForceJacobians = (
  q: Float64Array,
  v: Float64Array,
  p: Float64Array,
  forceQ: Float64Array,
  forceV: Float64Array,
) => void;

/**
 * A system from its view and its generated equations; what the meta names is looked up among them:
 * `<id>Constraints`, `<id>Dynamics`, `<id>Jacobians` and, with contact, `<id>Heights` of each constraint set with rows (sets that share
 * one `contact` share the heights of the first);
 * `<name>Force` and `<name>Jacobians` of each optional force.
 *
 * @param view names, poses and tracked points
 * @param values the module `equations.generated.ts` of the same system
 * @param slopes its `jacobians.generated.ts`; left out, every Jacobian throws when it is asked for, and nothing can be pushed
 * @param tape the same accelerations as data, `accelerations.generated.json`, where there is one
 * @throws Error that names the function which the meta promises and the modules lack
 */
export function defineSystem(
  view: SystemView,
  values: GeneratedEquations,
  slopes: GeneratedJacobians | undefined,
  tape?: Tape,
): System {
  const { meta } = view;
  const equations = { ...values, ...(slopes ?? withoutJacobians(view)) };
  const losses = optionalForces(view, equations as unknown as Named);
  const sets = meta.constraintSets.filter((set) => set.rows !== undefined);
  return {
    ...view,
    mechanics: losses
      ? (q, v, p, massMatrix, h) => {
          equations.mechanics(q, v, p, massMatrix, h);
          losses.add(q, v, p, h);
        }
      : equations.mechanics,
    jacobians: losses
      ? (q, v, a, p, dq, dv) => {
          equations.jacobians(q, v, a, p, dq, dv);
          losses.subtractJacobians(q, v, p, dq, dv);
        }
      : equations.jacobians,
    energy: equations.energy,
    ...(equations.poseJacobian ? { poseJacobian: equations.poseJacobian } : {}),
    constraintSets: Object.fromEntries(
      sets.map((set) => {
        const heightsOf = sets.find(({ contact }) => contact === set.contact)!.id;
        return [set.id, constraintSet(meta.id, set, heightsOf, equations as unknown as Named, losses, tape)];
      }),
    ),
    ...(equations.rate && equations.rateJacobian
      ? { firstOrder: { rate: equations.rate, jacobian: equations.rateJacobian } }
      : {}),
    ...(losses ? { optionalForces: losses.terms } : {}),
    ...(meta.touchdown ? { clearance: clearanceOf(view) } : {}),
  };
}

/** In place of the Jacobians of a run that takes none, so that one that does cannot go wrong in silence. */
function withoutJacobians({ meta }: SystemView): GeneratedJacobians {
  const missing = (): never => {
    throw new Error(`the Jacobians of ${meta.id} were asked for and are not loaded`);
  };
  const names = [...meta.constraintSets.map(({ id }) => id), ...(meta.optionalForces ?? [])];
  return { jacobians: missing, ...Object.fromEntries(names.map((name) => [`${name}Jacobians`, missing])) };
}

function generated<T>(system: string, equations: Named, name: string): T {
  if (typeof equations[name] !== 'function')
    throw new Error(`${system}'s generated modules have no function ${name}, which its meta promises`);
  return equations[name] as T;
}

function constraintSet(
  system: string,
  { id, rows, contact }: ConstraintSetMeta,
  heightsOf: string,
  equations: Named,
  losses: OptionalForces | null,
  tape: Tape | undefined,
): ConstraintSet {
  const dynamics = generated<NonNullable<ConstraintSet['dynamics']>>(system, equations, `${id}Dynamics`);
  return {
    id,
    rows: rows!,
    evaluate: generated(system, equations, `${id}Constraints`),
    dynamics: losses
      ? (q, v, p, massMatrix, h, omega, gamma) => {
          dynamics(q, v, p, massMatrix, h, omega, gamma);
          losses.add(q, v, p, h);
        }
      : dynamics,
    jacobians: generated(system, equations, `${id}Jacobians`),
    contact: contact
      ? {
          rows: contact.rows,
          solveFor: contact.solveFor,
          count: contact.rows.length,
          heights: generated(system, equations, `${heightsOf}Heights`),
        }
      : null,
    ...directDynamics(equations['direct'] as Named | undefined, id, losses, tape),
  };
}

/** The short way of a constraint set, where the derivation has written one. */
function directDynamics(
  direct: Named | undefined,
  id: string,
  losses: OptionalForces | null,
  tape: Tape | undefined,
): Pick<ConstraintSet, 'direct'> {
  if (!direct?.[`${id}Accelerations`]) return {};
  const written = {
    constantCount: direct['constantCount'],
    ...(direct['holdable'] ? { holdable: direct['holdable'] } : {}),
    factorCount: direct[`${id}FactorCount`],
    prepare: direct['prepare'],
    accelerations: direct[`${id}Accelerations`],
    shift: direct[`${id}Shift`],
    slip: direct[`${id}Slip`],
    ...(tape ? { tape } : {}),
  } as DirectDynamics;
  return { direct: losses ? { ...written, optional: losses } : written };
}

interface OptionalForces {
  active(p: Float64Array): boolean;
  terms: NonNullable<System['optionalForces']>;
  add(q: Float64Array, v: Float64Array, p: Float64Array, h: Float64Array): void;
  subtractJacobians(q: Float64Array, v: Float64Array, p: Float64Array, dq: Float64Array, dv: Float64Array): void;
}

/** Forces that are evaluated only where their parameter is not zero; null where the system has none. */
function optionalForces({ meta }: SystemView, equations: Named): OptionalForces | null {
  if (!meta.optionalForces?.length) return null;
  const n = meta.coordinates.length;
  const terms = meta.optionalForces.map((name) => ({
    parameter: parameterIndex(meta, name),
    force: generated<Force>(meta.id, equations, `${name}Force`),
    jacobians: generated<ForceJacobians>(meta.id, equations, `${name}Jacobians`),
  }));
  const force = new Float64Array(n);
  const [forceQ, forceV] = [new Float64Array(n * n), new Float64Array(n * n)];
  return {
    active: (p) => terms.some(({ parameter }) => p[parameter] !== 0),
    terms,
    add(q, v, p, h) {
      for (const term of terms) {
        if (p[term.parameter] === 0) continue;
        term.force(q, v, p, force);
        for (let i = 0; i < n; i++) h[i]! += force[i]!;
      }
    },
    subtractJacobians(q, v, p, dq, dv) {
      for (const term of terms) {
        if (p[term.parameter] === 0) continue;
        term.jacobians(q, v, p, forceQ, forceV);
        for (let i = 0; i < n * n; i++) {
          dq[i]! -= forceQ[i]!;
          dv[i]! -= forceV[i]!;
        }
      }
    },
  };
}

/** Height of the lowest corner of the boxes that the meta names, each centred on its body's origin (m). */
function clearanceOf(view: SystemView): NonNullable<System['clearance']> {
  const { bodies, box } = view.meta.touchdown!;
  const indices = bodies.map((id) => view.meta.bodies.findIndex((body) => body.id === id));
  const sides = box.map((name) => parameterIndex(view.meta, name));
  const poses = new Float64Array(12 * view.meta.bodies.length);
  return (q, p) => {
    view.poses(q, p, poses);
    let lowest = Infinity;
    for (const body of indices) {
      const o = 12 * body;
      let reach = 0;
      for (let k = 0; k < 3; k++) reach += Math.abs(poses[o + 9 + k]!) * p[sides[k]!]!;
      lowest = Math.min(lowest, poses[o + 2]! - reach / 2);
    }
    return lowest;
  };
}
