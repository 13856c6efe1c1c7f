import type { SystemMeta } from '../../model/system.ts';
import type { Wish } from './wish.ts';

/** What the layer sees of the board. */
export interface Sight {
  t: number;
  q: Float64Array;
  v: Float64Array;
  /** Along the heading, m/s, and across it to the left. */
  speed: number;
  across: number;
  wish: Readonly<Wish>;
  /** How far a foot is on the ground, 0 to 1. */
  foot: number;
}

/** Torques of both feet, front and back, into `feet`. */
export interface Layer {
  /** Coordinate of a rider's lean, where there is one; and what holds it up from outside while a foot is on the ground. */
  readonly lean: { name: string; index: number; stiffness: number; damping: number } | null;
  /** Most torque of a foot, N·m, and what a command alone asks of it. */
  readonly limit: number;
  readonly direct: number;
  ask(sight: Sight, feet: Float64Array): void;
  /** Legs and hips that move by themselves, where they are free. */
  readonly body: readonly Servo[];
}

/** A coordinate of the body that follows what is wished by an input of its own. */
export interface Servo {
  readonly input: string;
  /** Most of that input, and what a whole command asks of it without help. */
  readonly limit: number;
  readonly direct: number;
  /** The command. */
  readonly wish: 'crouch' | 'hips';
  ask(sight: Sight): number;
}

/**
 * @param meta of a system
 * @param name of a coordinate
 */
export const place = (meta: SystemMeta, name: string): number => meta.coordinates.findIndex((c) => c.name === name);
