/** What a drawing of a system is: meshes by name, who wears them, what stands still around them, and how to look at it. */
import type { ColourRole, SystemMeta } from '../model/system.ts';
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
  role: ColourRole;
  model: string;
  /** The mesh's group `wheel` turns about y through `hub` (in the body's frame) by the rolled angle of this contact. */
  spin?: { hub: Vec3; contact: number };
  /** It is a piece without a name, not a body. */
  limb?: true;
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
  limbs?: Limbs;
}

/** Pieces that are drawn and have no mass: they stand behind the bodies, and their poses follow from those. */
export interface Limbs {
  ids: readonly string[];
  /** Writes their poses behind those of the bodies, 12 numbers each. */
  place(poses: Float64Array): void;
}

/** A parameter by name, or what stands in for it where the system has none or it is no number. */
export type Value = (name: string, otherwise?: number) => number;

/**
 * Parameters by name for a sketch.
 *
 * @param meta of the system
 * @param parameters SI; those that are missing or no numbers take the meta's defaults
 */
export function valueOf(meta: SystemMeta, parameters: Readonly<Record<string, number>>): Value {
  return (name, otherwise = 0) => {
    const given = parameters[name];
    if (given !== undefined && Number.isFinite(given)) return given;
    return meta.parameters.find((p) => p.name === name)?.default ?? otherwise;
  };
}

/** What a drawing says beside its meshes: light enough for the first view. */
export interface Layout {
  /** Bodies whose mesh has a group `wheel` that turns (see `Wearer`). */
  spins?: Readonly<Record<string, NonNullable<Wearer['spin']>>>;
  /** Each with a mesh of its name. */
  limbs?: Limbs;
  /** How its stage differs from the common one. */
  stage?: Partial<Omit<Stage, 'subject' | 'closeUp'>> & { subject?: string };
}

/** What a system's `drawing.ts` makes: parts by mesh (the bodies' own names, or what the meta names) and by fixture. */
export interface Sketch extends Layout {
  bodies: Readonly<Record<string, Omit<Body, 'name'>>>;
  fixtures?: Readonly<Record<string, Omit<Body, 'name'>>>;
}

/**
 * Who wears which mesh, and the stage: what a drawing says beside its meshes.
 *
 * @param meta of the system
 */
export function castOf(meta: SystemMeta, { spins, stage, limbs }: Layout): Pick<Drawing, 'bodies' | 'stage' | 'limbs'> {
  const indexOf = (id: string | undefined): number => meta.bodies.findIndex((body) => body.id === id);
  const { subject, ...own } = stage ?? {};
  const closeUp = indexOf(meta.views?.closeUp);
  const common: Stage = { subject: 0, facing: 'nose', still: false, floor: 0, closeUp: closeUp < 0 ? null : closeUp };
  return {
    bodies: [
      ...meta.bodies.map(({ id, role, model }): Wearer => {
        const spin = spins?.[id];
        return { id, role, model: model ?? id, ...(spin ? { spin } : {}) };
      }),
      ...(limbs?.ids ?? []).map((id): Wearer => ({ id, role: 'neutral', model: id, limb: true })),
    ],
    stage: { ...common, ...own, subject: Math.max(0, indexOf(subject)) },
    ...(limbs ? { limbs } : {}),
  };
}

/** A size of nothing cannot be drawn: a degenerate parameter shows as a millimetre. */
export const sizeOf = (x: number): number => Math.max(Math.abs(x), 1e-3);

/** How much longer than at the reference mass a side of something of one density is; never nothing. */
export const growthOf = (mass: number, reference: number): number =>
  Math.max(Math.cbrt(Math.abs(mass) / reference), 0.2);
