/** What a drawing of a system is: meshes by name, who wears them, what stands still around them, and how to look at it. */
import type { Vec3 } from './vectors.ts';
import type { Body } from './wavefront.ts';

export interface Model {
  /** Wavefront OBJ text. */
  mdl: string;
  /** Wavefront MTL text. */
  mat: string;
}

/** A body (moved by its pose) or a fixture (in world axes) and the name of the mesh pair that draws it. */
export interface Wearer {
  id: string;
  part: 'board' | 'front' | 'back';
  model: string;
  /** The mesh's group `wheel` turns about y through `hub` (in the body's frame) by the rolled angle of this contact. */
  spin?: { hub: Vec3; contact: number };
}

export interface Stage {
  /** Index of the body that the camera looks at and follows. */
  subject: number;
  /** Which way the subject faces: along its x axis, across its axle (y), or as the world's x. */
  facing: 'nose' | 'axle' | 'world';
  /** The subject moves about in its place: the camera stays with the world. */
  still: boolean;
  /** Height of the floor that is drawn (m). */
  floor: number;
  /** What the first view must hold (m), from the subject's origin in its facing frame, from the world's if still; else the bodies as they stand at first. */
  frame?: readonly [low: Vec3, high: Vec3];
  /** The body shown by the close-up view, if there is one. */
  closeUp: number | null;
}

export interface Drawing {
  /** Mesh pairs by model name. */
  pairs: Readonly<Record<string, Model>>;
  /** In the order of the poses. */
  bodies: readonly Wearer[];
  fixtures: readonly Wearer[];
  stage: Stage;
}

/** A parameter by name, or what stands in for it where the system has none or it is no number. */
export type Value = (name: string, otherwise?: number) => number;

/** What one system's file in `drawings/` makes: parts by body and by fixture, and how its stage differs from the common one. */
export interface Sketch {
  bodies: Readonly<Record<string, Pick<Body, 'parts'> & { about: string }>>;
  fixtures?: Readonly<Record<string, Pick<Body, 'parts'> & { about: string }>>;
  stage?: Partial<Omit<Stage, 'subject' | 'closeUp'>> & { subject?: string };
}

/** A size of nothing cannot be drawn: a degenerate parameter shows as a millimetre. */
export const sizeOf = (x: number): number => Math.max(Math.abs(x), 1e-3);

/** How much longer than at the reference mass a side of something of one density is; never nothing. */
export const growthOf = (mass: number, reference: number): number =>
  Math.max(Math.cbrt(Math.abs(mass) / reference), 0.2);
