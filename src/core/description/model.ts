import type { ColourRole, CoordinateMeta, InputMeta, ParameterMeta } from '../model/system.ts';
import type { Frame, Vector } from './expression.ts';
import type { Graph, Id } from './graph.ts';

/** One velocity that vanishes, or one height that stays zero. */
export interface Row {
  /** Linear in the rates, `row = Omega v`; of a height its rate. */
  velocity: Id;
  /** Of a height. */
  height: Id | null;
  /** The coordinate that gives way at the start; null: chosen by the height's slopes. */
  solve: number | null;
  line: number;
  label: string;
}

export interface SetModel {
  id: string;
  label: string;
  rows: Row[];
  line: number;
}

export interface BodyModel {
  id: string;
  label: string;
  /** Its centre of mass. */
  position: Vector;
  /** Where it is drawn from. */
  origin: Vector;
  frame: Frame;
  mass: Id | null;
  inertia: readonly Id[] | null;
  role?: ColourRole;
  line: number;
}

export type ShapeKind = 'box' | 'cylinder' | 'sphere' | 'disc' | 'rod' | 'path' | 'model';

export interface ShapeModel {
  body: number;
  kind: ShapeKind;
  /** Of the parameters alone: sides, radius and length, or the points' components. */
  sizes: readonly Id[];
  at: Vector;
  /** Along which a cylinder, disc or rod lies. */
  axis: 'x' | 'y' | 'z';
  /** Of a mesh. */
  model: string | null;
  line: number;
}

export interface EventModel {
  id: string;
  label: string;
  value: Id;
  /** Constraint sets under which it is looked for; all of them where empty. */
  sets: readonly string[];
  line: number;
}

/** A description as it was understood: names, and a graph of what they are. */
export interface Model {
  title: string;
  graph: Graph;
  coordinates: CoordinateMeta[];
  /** Line of each coordinate. */
  lines: number[];
  parameters: ParameterMeta[];
  presets: Record<string, Record<string, number>>;
  q: Id[];
  v: Id[];
  p: Id[];
  /** Index of the coordinate that is the time, in systems in which t occurs. */
  clock: number | null;
  kinetic: Id;
  /** The part of it that lines give as an energy, without the bodies. */
  kineticLines: Id;
  /** What stands for the inertia of the clock and of coordinates of first order: no energy, but a part of M. */
  inertia: Id;
  potential: Id;
  /** Rayleigh's function. */
  loss: Id;
  /** Generalized forces from the statements, by coordinate. */
  forces: Id[];
  inputs: InputMeta[];
  sets: SetModel[];
  /** Right-hand sides of `y' = …`, by coordinate. */
  rates: Map<number, { value: Id; line: number }>;
  /** Whether anything is of second order. */
  mechanical: boolean;
  bodies: BodyModel[];
  shapes: ShapeModel[];
  tracks: { body: number; label: string }[];
  events: EventModel[];
  /** Coordinates that are held unless a scenario releases them. */
  held: string[];
  shown: string[];
  speed: { along: [string, string]; heading: string } | null;
  forward: { along: [string, string]; heading: string } | null;
  /** Names that a description defines, for completion: what they are, and the line. */
  names: Map<string, { kind: string; line: number }>;
  /** Expressions that a line gives a name to. */
  defined: Map<Id, string>;
}
