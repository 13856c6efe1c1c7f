/** What the scene is given: it knows poses, not physics, and never asks where they came from. */
export interface BodyPart {
  id: string;
  part: 'board' | 'front' | 'back';
}

/** Text of a .mdl (OBJ) and a .mat (MTL) file. */
export interface MeshPair {
  mdl: string;
  mat: string;
}

/** What a stage is set with: bodies in the order of their poses, and where wheels turn. */
export interface Cast {
  parts: readonly BodyPart[];
  models: readonly MeshPair[];
  /** Wheel centre of each body in its frame (m); unused for bodies without a `wheel` group. */
  hubs: readonly (readonly [number, number, number])[];
}

/** One moment, ready to draw. World: right-handed, Z up, metres. */
export interface Frame {
  time: number;
  /** 12 numbers per body: position, then rotation matrix by rows (body to world). */
  poses: Float64Array;
  /** Rolled angle (rad) by body. */
  wheelAngles: ReadonlyMap<number, number>;
  /** Constraint forces: world origin (m) and vector (N). */
  forces: readonly {
    part: 'front' | 'back';
    kind: 'lateral' | 'vertical';
    origin: readonly [number, number, number];
    vector: readonly [number, number, number];
  }[];
  trails: readonly Trail[];
}

/** Ground track of a skate point: 3 floats per point, times rising; arrays are replaced when they grow. */
export interface Trail {
  part: 'front' | 'back';
  points: Float32Array;
  times: Float64Array;
  count: number;
}

export type ViewName = 'orbit' | 'front' | 'side' | 'top' | 'caster';
