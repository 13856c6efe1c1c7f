/**
 * What a mechanical system is to the rest of the program.
 *
 * Every system is `M(q) a = h(q, v) + B u + Omega(q)^T lambda` with `Omega(q) v = 0`.
 * All matrices are row-major `Float64Array`s owned by the caller; SI units and radians.
 */
import type { Tape } from './tape.ts';

/** What a thing's colour says: nothing in particular, or that it belongs to the first or second of two like parts (front and rear). */
export type ColourRole = 'neutral' | 'first' | 'second';

/** A generalized coordinate, as it is named in every file, API and test. */
export interface CoordinateMeta {
  name: string;
  /** Typeset symbol for the page, e.g. `α_fp`. */
  symbol: string;
  /** Plain words, e.g. "front plate roll, relative to the rod". */
  label: string;
  kind: 'length' | 'angle';
  /** No length but a pure number: it has no unit. */
  pure?: true;
  /** Its colour everywhere. */
  role: ColourRole;
  /** Value at rest when `initial` does not name it (default 0). */
  rest?: number;
}

/** A sum of angle coordinates; its rate is `<name>_dot`. */
export interface SumMeta {
  name: string;
  symbol: string;
  label: string;
  of: readonly string[];
  role: ColourRole;
}

export interface ParameterMeta {
  name: string;
  symbol: string;
  label: string;
  unit: string;
  default: number;
  /** Angles are shown in degrees, kept in radians. */
  kind?: 'angle';
  /** Inclusive bounds outside which the model has no meaning; refused with a message. */
  min?: number;
  max?: number;
  /** Strictly greater than zero. */
  positive?: boolean;
  /** At most another parameter, a part of which it is, where a coordinate is free. */
  partOf?: { parameter: string; free: string };
  group: string;
  note?: string;
  /** Where the default comes from. */
  source?: string;
}

export interface InputMeta {
  name: string;
  symbol: string;
  label: string;
  unit: string;
  /** Non-zero entries of this input's column of B: coordinate name -> value. */
  column: Readonly<Record<string, number>>;
  /** For `track`: the coordinates whose sum follows this input's reference. */
  tracks?: readonly string[];
}

export interface BodyMeta {
  id: string;
  /** The mesh that it wears, if not one of its own name. */
  model?: string;
  label: string;
  role: ColourRole;
}

/** A constraint set as the meta names it; one without rows leaves the system free. */
export interface ConstraintSetMeta {
  id: string;
  label: string;
  /** Of Omega. */
  rows?: number;
  /** Holonomic part: which rows of Omega are gradients of heights, and the coordinates that give way (Newton) so that the start touches the ground. */
  contact?: {
    rows: readonly number[];
    solveFor: readonly string[];
    /** What touches the ground, in a sentence: "both skate points". */
    points: string;
  };
  /** What it means that the rows have become dependent, in a sentence: "a skate lies flat". */
  dependent?: string;
}

/** Velocity constraints `Omega(q) v = 0` with `Omega a + gamma = 0`, gamma = Omega_dot v. */
export interface ConstraintSet {
  id: string;
  rows: number;
  /** `Omega` is rows x n, `gamma` has rows entries. */
  evaluate(q: Float64Array, v: Float64Array, p: Float64Array, omega: Float64Array, gamma: Float64Array): void;
  /** The system's `mechanics` and `evaluate` in one, where that is cheaper than the two. */
  dynamics?(
    q: Float64Array,
    v: Float64Array,
    p: Float64Array,
    massMatrix: Float64Array,
    h: Float64Array,
    omega: Float64Array,
    gamma: Float64Array,
  ): void;
  /**
   * Exact Jacobians at given a and lambda:
   * `forceQ` = d(Omega^T lambda)/dq (n x n), `rateQ`, `rateV` = d(Omega a + gamma)/dq, /dv (rows x n),
   * `velocityQ` = d(Omega v)/dq (rows x n).
   */
  jacobians(
    q: Float64Array,
    v: Float64Array,
    a: Float64Array,
    lambda: Float64Array,
    p: Float64Array,
    forceQ: Float64Array,
    rateQ: Float64Array,
    rateV: Float64Array,
    velocityQ: Float64Array,
  ): void;
  /** Holonomic part: heights kept at exactly zero. `rows[i]` is the row of Omega that is d(height_i)/dq. */
  contact: ContactMeta | null;
  /** The shortest way to the accelerations, where the derivation has written one. */
  direct?: DirectDynamics;
}

/**
 * Accelerations under one constraint set as one straight line of operations, without M and Omega (derivation/direct.py).
 * c: `constantCount` numbers that `prepare` makes of the parameters; y = [q, v] and rate = [v, a] have 2 n entries.
 */
export interface DirectDynamics {
  /** The same as data, for another engine. */
  readonly tape?: Tape;
  readonly constantCount: number;
  /** Coordinates that may be held: `prepare` takes a 1 for each that is and a 0 for each that is free after the parameters. */
  readonly holdable?: readonly number[];
  /** What the accelerations leave for `shift`; the last is 1 / det of S = Omega M^-1 Omega^T scaled to a unit diagonal. */
  readonly factorCount: number;
  prepare(p: Float64Array, c: Float64Array): void;
  /**
   * @param f generalized forces from outside, n
   * @returns false where M or S is not positive definite
   */
  accelerations(
    y: Float64Array,
    c: Float64Array,
    f: Float64Array,
    rate: Float64Array,
    lambda: Float64Array,
    factors: Float64Array,
  ): boolean;
  /** Adds to x (n) the smallest change in the mass metric that changes Omega x by g (rows). */
  shift(factors: Float64Array, g: Float64Array, x: Float64Array): void;
  /** Omega v into `slip` (rows), heights of the contact points into `heights`. */
  slip(q: Float64Array, v: Float64Array, c: Float64Array, slip: Float64Array, heights: Float64Array): void;
  /** Forces that are left out of the above because most parameters have none: whether these parameters do, and f += them. */
  optional?: {
    active(p: Float64Array): boolean;
    add(q: Float64Array, v: Float64Array, p: Float64Array, f: Float64Array): void;
  };
}

export interface ContactMeta {
  count: number;
  rows: readonly number[];
  heights(q: Float64Array, p: Float64Array, out: Float64Array): void;
  /** Coordinates that give way (Newton) so that the start touches the ground. */
  solveFor: readonly string[];
}

/** A column that is no coordinate, as a file brings it. */
export interface DataColumn {
  name: string;
  label: string;
  /** SI and radians where it is one of them, else the file's own; '' where none is said. */
  unit: string;
}

export interface SystemMeta {
  id: string;
  title: string;
  /** The text that describes it, of a system that a person made. */
  description?: string;
  /** Of the differential equations, 2 unless told otherwise; of order 1 the state is q alone, and there is no energy. */
  order?: 1 | 2;
  coordinates: readonly CoordinateMeta[];
  parameters: readonly ParameterMeta[];
  parameterSets: Readonly<Record<string, Readonly<Record<string, number>>>>;
  /** First one is the default. */
  constraintSets: readonly ConstraintSetMeta[];
  inputs: readonly InputMeta[];
  /** A word for straight ahead at a speed, where `initial` and `at` may say it: velocities `along` the heading's cosine and sine. */
  speed?: { name: string; label: string; along: readonly [string, string]; heading: string };
  /**
   * The coordinate that is the time, where what is driven or given by t makes a system depend on it: its rate is 1 from the
   * start on, and nothing acts on it.
   */
  clock?: string;
  /** Something in it takes energy, whatever its parameters are called. */
  losses?: true;
  /** Names of coordinates, rates, parameters and inputs that the panel shows first; in no order of importance where left out. */
  shown?: readonly string[];
  /** Functions of the state that end a run by falling through zero, under some constraint sets or (where empty) all. */
  events?: readonly { id: string; label: string; sets: readonly string[] }[];
  /** Sums of angles that have a name of their own, a plate's own roll: columns wherever coordinates are. */
  sums?: readonly SumMeta[];
  /** Which way is forward, where `speed` does not say it: the velocity along the heading is what gains are scheduled over. */
  forward?: { along: readonly [string, string]; heading: string };
  /** Inputs that a regulator is first offered with; all of them where this is left out. */
  regulators?: readonly string[];
  /** Feet that pump: the inputs whose targets a gait gives (front, back), the parameter that is each wheel's drag (N·s/m), what a rider holds still meanwhile. */
  gait?: { feet: readonly [string, string]; drag?: string; hold?: readonly string[] };
  /** Coordinates that are held unless a scenario releases them (`scenario/held.ts`). */
  held?: readonly string[];
  /** A system whose drawing has one body more, somebody who stands upright on this one, with the centre of mass so high above body 0 (m). */
  rider?: { drawnAs: string; height: number };
  /** The group of parameters that somebody's height and mass give (`systems/ripstik-rider/person.ts`). */
  person?: string;
  bodies: readonly BodyMeta[];
  /** Forces that are left out where the parameter of the same name is zero; the derivation writes `<name>Force` and `<name>Jacobians`. */
  optionalForces?: readonly string[];
  /**
   * A body that is free without constraints: its position in the world, its attitude Rz(yaw) Ry(pitch) Rx(roll) by
   * coordinates, all else relative to it; and the parameter that is gravity along -z. Lets it pass pitch ±90°.
   */
  attitude?: {
    position: readonly [string, string, string];
    angles: readonly [string, string, string];
    gravity: string;
  };
  /** Boxes that may not touch the ground, centred on bodies: ids, and the parameters that are their sides (m) along x, y and z. */
  touchdown?: {
    bodies: readonly string[];
    box: readonly [string, string, string];
    /** What of it touches, in a sentence: "a corner of a plate". */
    label: string;
  };
  /** Its files without a header row are known by their number of columns: the coordinates in order, or the time before them. */
  headerless?: boolean;
  /** What a screen reader is told of a moment: sums of coordinates under a name; every coordinate where it is left out. */
  spoken?: readonly { label: string; values: readonly (readonly string[])[] }[];
  /** Columns of data, which are no system's. */
  columns?: readonly DataColumn[];
  /** Ways to look at it: from aboard, where it goes somewhere, and at a body close up. */
  views?: { ridden?: boolean; closeUp?: string };
}

/**
 * @param id of the constraint set
 * @returns what dependent rows of a constraint set mean, in parentheses after a space; nothing where the meta does not say
 */
export function dependentWords({ constraintSets }: SystemMeta, id: string | undefined): string {
  const words = constraintSets.find((set) => set.id === id)?.dependent;
  return words ? ` (${words})` : '';
}

/**
 * @param meta of the system
 * @param name of the parameter
 * @returns position of a parameter in the vector `p`; throws where the system has none of that name
 */
export function parameterIndex(meta: SystemMeta, name: string): number {
  const index = meta.parameters.findIndex((parameter) => parameter.name === name);
  if (index < 0) throw new Error(`${meta.id} has no parameter ${name}`);
  return index;
}

/** Names of the meshes that a person can replace, in the order of the bodies. */
export const modelsOf = ({ bodies }: Pick<SystemMeta, 'bodies'>): readonly string[] => [
  ...new Set(bodies.map(({ id, model }) => model ?? id)),
];

/** What a view needs: names and poses, no dynamics. */
export interface SystemView {
  meta: SystemMeta;
  /** Per body 12 numbers: position x y z, then rotation matrix row by row (body to world). */
  poses(q: Float64Array, p: Float64Array, out: Float64Array): void;
  /** Wheels that leave a track: the body whose origin touches the ground, axle along its y. */
  contacts: readonly TrackedContact[];
  /** Points whose paths are drawn; the contacts' where it is absent. */
  tracks?: readonly TrackedPoint[];
  /** How far along x all bodies go in a second (m/s) beside their poses: a scalar equation is shown as its curve being drawn. */
  drawnAlong?: number;
}

export interface TrackedPoint {
  body: number;
  role: ColourRole;
  /** Name of the parameter that is the radius (m) of a wheel about the body's y: its lowest point leaves the path, not the origin. */
  rim?: string;
}

export interface TrackedContact {
  body: number;
  /** Plain words, e.g. "front wheel". */
  label: string;
  role: ColourRole;
  /** Name of the parameter that is the wheel's radius (m). */
  radius: string;
  /** Index of the multiplier that is the force along the axle, or (by constraint set) along world Y, and of the vertical one. */
  lateral: number;
  vertical: number;
  /** Constraint sets whose lateral row acts along world Y instead of the axle. */
  worldLateral: readonly string[];
}

/** A formula of t as a tree, as `scenario/expressions/tree.ts` has it. */
export interface TimeFormula {
  readonly op: string;
  readonly args: readonly TimeFormula[];
  readonly x: number;
  readonly constant: boolean;
  decided: number;
}

export interface System extends SystemView {
  /** Mass matrix (n x n, both triangles) and h (n) at q, v. */
  mechanics(q: Float64Array, v: Float64Array, p: Float64Array, massMatrix: Float64Array, h: Float64Array): void;
  /** Exact Jacobians of `M a - h` at given a: `dq`, `dv` (n x n each). */
  jacobians(
    q: Float64Array,
    v: Float64Array,
    a: Float64Array,
    p: Float64Array,
    dq: Float64Array,
    dv: Float64Array,
  ): void;
  /** `out` = [kinetic, potential] in J. */
  energy(q: Float64Array, v: Float64Array, p: Float64Array, out: Float64Array): void;
  /** Exact derivatives of `poses` by q (12 per body x n). Without it no body can be pushed. */
  poseJacobian?(q: Float64Array, p: Float64Array, out: Float64Array): void;
  constraintSets: Readonly<Record<string, ConstraintSet>>;
  /**
   * A system of first order: f of `q' = f(q)` and df/dq (n x n). Its `mechanics` are then that equation's rate, M = 1 and
   * h = df/dq v; its energy is 0.
   */
  firstOrder?: {
    rate(q: Float64Array, p: Float64Array, out: Float64Array): void;
    jacobian(q: Float64Array, p: Float64Array, out: Float64Array): void;
  };
  /** Forces left out of `mechanics` where their parameter is zero; `force` gives one alone (n). */
  optionalForces?: readonly {
    parameter: number;
    force(q: Float64Array, v: Float64Array, p: Float64Array, out: Float64Array): void;
  }[];
  /** Index of the coordinate that is the time; see the meta. */
  clock?: number;
  /**
   * W that forces of the system itself and whatever moves what is given by the time put in, where there are such. What constraints
   * that move put in comes to it: -lambda times the clock's column of Omega.
   */
  outsidePower?(q: Float64Array, v: Float64Array, a: Float64Array, p: Float64Array): number;
  /**
   * What the equations hold of the time alone, so that steps don't pass over what it does.
   * @param p parameters
   * @param ahead what the clock is ahead of t, s
   */
  timeFormulas?: (p: Float64Array, ahead: number) => readonly TimeFormula[];
  /** The events of the meta. */
  crossings?: readonly {
    id: string;
    label: string;
    sets: readonly string[];
    value(q: Float64Array, v: Float64Array, p: Float64Array): number;
  }[];
  /** Lowest height above ground of the parts that may not touch it (m); `touchdown` is its downward crossing. */
  clearance?(q: Float64Array, p: Float64Array): number;
}
