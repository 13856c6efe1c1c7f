/** What the scene is given: it knows poses, not physics, and never asks where they came from. */
export interface BodyPart {
  id: string;
  part: 'board' | 'front' | 'back';
}

/** One moment, ready to draw. */
export interface Frame {
  time: number;
  /** 12 numbers per body: position, then rotation matrix by rows (body to world), Z up. */
  poses: Float64Array;
  /** Rolled angle of each wheel (rad), keyed by body order; empty when unknown. */
  wheelAngles: Float64Array;
  /** Constraint forces: world origin and vector in N, or empty. */
  forces: readonly { part: 'front' | 'back'; kind: 'lateral' | 'vertical'; origin: readonly [number, number, number]; vector: readonly [number, number, number] }[];
}

/** Ground tracks so far: x, y, z triples per skate, times rising; views into growing arrays. */
export interface Trail {
  part: 'front' | 'back';
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

export type ViewName = 'orbit' | 'front' | 'side' | 'top' | 'caster';
