/** What the scene is given: it knows poses, not physics, and never asks where they came from. */
import type { ColourRole } from '../core/model/system.ts';

export interface BodyPart {
  id: string;
  role: ColourRole;
}

/** A body and the name of the mesh pair that draws it. */
export interface BodyModel extends BodyPart {
  model: string;
  /** Its plain name; the id without one, and nothing is written on it where it is empty. */
  label?: string;
  /** Seen, and no part of the motion: a hand goes through it. */
  figure?: boolean;
  /** The mesh's group `wheel` turns about y through `hub` (m, in the body's frame) by this one of the frame's wheel angles. */
  spin?: { hub: readonly [number, number, number]; contact: number };
}

/** Everything on a system's stage, and how to look at it. */
export interface Cast {
  /** Another system is looked at anew; the same one keeps the camera. */
  id: string;
  /** In the order of the poses. */
  bodies: readonly BodyModel[];
  /** What stands still, in world axes. */
  fixtures: readonly BodyModel[];
  stage: StagePlan;
  /** What of the bodies has no pose in a motion, the last of them, and how theirs follow from the others'. */
  limbs?: { ids: readonly string[]; place(poses: Float64Array): void };
}

export interface StagePlan {
  /** Index of the body that the camera looks at and follows. */
  subject: number;
  /** Which way the subject faces: along its x axis, across its axle (y), or as the world's x. */
  facing: 'nose' | 'axle' | 'world';
  /** The subject moves about in its place: the camera stays with the world. */
  still: boolean;
  /** Height of the ground that is drawn (m). */
  floor: number;
  /** What the first view must hold (m), from the subject's origin in its facing frame, from the world's if still; else the bodies as they stand at first. */
  frame?: readonly [low: readonly [number, number, number], high: readonly [number, number, number]];
  /** Index of the body that the close-up shows, or null. */
  closeUp: number | null;
}

/** One moment, ready to draw. */
export interface Frame {
  time: number;
  /** 12 numbers per body: position, then rotation matrix by rows (body to world), Z up. */
  poses: Float64Array;
  /** Rolled angle (rad) about the axle (+y, forwards positive) of each wheel that no coordinate turns, as `spin` counts them; empty when unknown. */
  wheelAngles: Float64Array;
  /** Constraint forces: world origin and vector in N, or empty. */
  forces: readonly {
    role: ColourRole;
    kind: 'lateral' | 'vertical';
    origin: readonly [number, number, number];
    vector: readonly [number, number, number];
  }[];
}

/** A path so far: x, y, z triples, times rising; views into growing arrays. */
export interface Trail {
  role: BodyPart['role'];
  /** 3 floats per point. */
  points: Float32Array;
  times: Float64Array;
  count: number;
}

export interface MeshPair {
  /** Text of the .mdl (OBJ) file. */
  mdl: string;
  /** Text of the .mat (MTL) file. */
  mat: string;
}

export type ViewName = 'orbit' | 'front' | 'side' | 'top' | 'caster' | 'rider';

/** Another motion of the same cast, drawn translucent and without a shadow. */
export interface Ghost {
  /** Stays the same from frame to frame. */
  id: string;
  /** A word that floats over it; none when empty. */
  label: string;
  /** CSS colour. */
  tint: string;
  /** As a frame's; read at once and not kept. */
  poses: Float64Array;
  wheelAngles: Float64Array;
}

/** A gate on the floor: its middle (m), the direction of going through it (rad), half of its width (m). */
export interface GateModel {
  x: number;
  y: number;
  heading: number;
  half: number;
  state: 'done' | 'next' | 'ahead';
}

type Point = readonly [number, number, number];

/** A place on a body. */
export interface Pick {
  /** Index in the cast. */
  body: number;
  /** In the body's frame, m. */
  point: [number, number, number];
  /** In the world, m. */
  world: [number, number, number];
}

/** The spring being pulled, in the world (m), and the words at its end. */
export interface Handle {
  from: Point;
  to: Point;
  label: string;
}

export interface Switches {
  trails: boolean;
  forces: boolean;
  /** Names of the bodies. */
  names: boolean;
  /** Axes at the bodies' origins. */
  frames: boolean;
  /** Metres of arrow per newton. */
  metresPerNewton: number;
  /** In the rider's view the horizon stays level; else it leans with the subject. */
  level: boolean;
}

/** When pressing on a body pushes it: never, with Shift, always. */
export type PushByDrag = 'never' | 'shift' | 'always';

/** Whose bodies are on the stage, and in which meshes. */
export interface Dressed {
  system: string | null;
  models: Readonly<Record<string, MeshPair>>;
  cast: Cast | null;
}

/** `high` and `low` are orders; `auto` leaves out what a software renderer or a slow device cannot afford. */
export type Quality = 'low' | 'high' | 'auto';

export interface SceneOptions {
  theme: 'light' | 'dark';
  reducedMotion: boolean;
  quality?: Quality;
  /** For pictures that leave the page: drawn by `draw()` at any pixel ratio, without the ground if transparent. */
  still?: { transparent: boolean; labels: boolean };
  /** After the first picture with bodies in it. */
  onFirstFrame?: () => void;
  onContextLost?: () => void;
  onContextRestored?: () => void;
  /** A push of a body begins; where the pointer is then, and with every move of pointer or camera, with how fast the camera takes it along (m/s of the motion's time); and that it ends. */
  onPushStart?: (at: Pick) => void;
  onPushMove?: (target: Point, velocity: Point) => void;
  onPushEnd?: () => void;
  /** CSS pixels per metre at what is looked at, when that has changed. */
  onScale?: (pixelsPerMetre: number) => void;
  /** In haste something is left out from now on, or nothing any more. */
  onCoarse?: (coarse: boolean) => void;
}

export interface Placement {
  camera: Point;
  target: Point;
  up: Point;
}

/** In CSS pixels from the canvas's top left corner. */
export interface ScreenBox {
  left: number;
  top: number;
  right: number;
  bottom: number;
}

export interface SceneView {
  /** Another cast, in these meshes. Throws `MeshError` and keeps the one that was there. */
  setModels(models: Readonly<Record<string, MeshPair>>, cast: Cast): void;
  /** One body (`front-caster`) or all bodies of a model (`caster`). Throws `MeshError` and keeps what was there. */
  replaceBody(id: string, pair: MeshPair): void;
  /** Read at once and not kept: the arrays may be reused. Null empties the scene. */
  setFrame(frame: Frame | null): void;
  /** Tracks so far; call again when they have grown or changed. Drawn up to the frame's time. */
  setTrails(trails: readonly Trail[]): void;
  /** All ghosts there are now; the same cast as the bodies'. Poses are read at once and not kept. */
  setGhosts(ghosts: readonly Ghost[]): void;
  setGates(gates: readonly GateModel[]): void;
  setView(name: ViewName): void;
  setFollow(follow: boolean): void;
  setSwitches(switches: Partial<Switches>): void;
  setQuality(quality: Quality): void;
  /** Whether pictures must come soon, as while somebody steers: a slow device draws them coarser, unless high quality is an order. */
  setHasty(hasty: boolean): void;
  /** A second look, at the close-up's body, within this box; null without. Nothing on a stage without a close-up. */
  setInset(box: ScreenBox | null): void;
  setPushByDrag(when: PushByDrag): void;
  /** Draws the pull of a hand, or nothing. */
  setHandle(handle: Handle | null): void;
  /** The first body under a place in CSS pixels from the canvas's top left corner, or within `reach` of it; null where there is none. */
  pick(x: number, y: number, reach?: number): Pick | null;
  /** Where a world point (m) is on the screen, CSS pixels from the canvas's top left corner; null behind the camera. */
  project(world: Point): { x: number; y: number } | null;
  setTheme(theme: 'light' | 'dark'): void;
  setReducedMotion(reduced: boolean): void;
  /** CSS pixels and device pixels per CSS pixel. */
  resize(width: number, height: number, devicePixelRatio: number): void;
  setBodyVisible(index: number, visible: boolean): void;
  /** Where the eye is, what it looks at (m) and what is up for it, in world axes; a set one is kept as if a hand had put it there, the rider's until the next frame. */
  placement(): Placement;
  setPlacement(place: Placement): void;
  /** Draws at once, without waiting for the screen; the canvas can be read until the caller returns to the event loop. */
  draw(): void;
  /** Asks for one picture; any number of requests before it give one. */
  requestRender(): void;
  /** Pictures drawn so far, what the last one held, the bodies on the stage, and what the graphics card holds. */
  stats(): {
    frames: number;
    triangles: number;
    calls: number;
    bodies: number;
    geometries: number;
    textures: number;
    programs: number;
  };
  /** World position of a body's origin (m), or null when it is not drawn. */
  bodyPosition(index: number): [number, number, number] | null;
  /** Body to world, 16 numbers by columns. */
  bodyMatrix(index: number): number[] | null;
  /** The body's bounds as projected; null when it is not drawn or reaches behind the camera. */
  screenBox(index: number): ScreenBox | null;
  dispose(): void;
}
