/** Keyframes of bodies as they go into a binary glTF: 32-bit floats in parts of a fixed length, so that no array grows with the run. */
import { Matrix4, Quaternion } from 'three';

/** Keys held as numbers; before and after them they are a browser's blobs, which need not be in memory. */
const KEYS = 4096;

/** A column of a file: `size` floats a key. */
class Floats {
  readonly parts: Blob[] = [];
  private readonly size: number;
  private held: Float32Array<ArrayBuffer>;
  private count = 0;

  constructor(size: number) {
    this.size = size;
    this.held = new Float32Array(KEYS * size);
  }

  push(values: ArrayLike<number>, offset = 0): void {
    const { size, held } = this;
    for (let i = 0; i < size; i++) held[size * this.count + i] = values[offset + i]!;
    if (++this.count === KEYS) this.close();
  }

  /** What is held becomes a part. */
  close(): void {
    if (this.count > 0) this.parts.push(new Blob([this.held.subarray(0, this.size * this.count)]));
    this.count = 0;
  }
}

/** What of a node moves. */
export interface NodeTrack {
  path: 'translation' | 'rotation';
  floats: Floats;
}

/** One body's place and attitude. */
export class BodyKeys {
  readonly tracks: readonly NodeTrack[] = [
    { path: 'translation', floats: new Floats(3) },
    { path: 'rotation', floats: new Floats(4) },
  ];
  readonly turn = new Float64Array(4);
  private readonly before = new Float64Array(4);
  private readonly matrix = new Matrix4();
  private readonly quaternion = new Quaternion();

  /** @param poses 12 numbers a body, as in `Frame`; `offset` is where this one's begin */
  push(poses: Float64Array, offset: number): void {
    const p = poses.subarray(offset, offset + 12) as unknown as Row;
    this.tracks[0]!.floats.push(poses, offset);
    this.matrix.set(p[3], p[4], p[5], 0, p[6], p[7], p[8], 0, p[9], p[10], p[11], 0, 0, 0, 0, 1);
    this.quaternion
      .setFromRotationMatrix(this.matrix)
      .normalize()
      .toArray(this.turn as unknown as number[]);
    keepSign(this.turn, this.before);
    this.tracks[1]!.floats.push(this.turn);
  }
}

/** A wheel about its axle, y. */
export class WheelKeys {
  readonly tracks: readonly NodeTrack[] = [{ path: 'rotation', floats: new Floats(4) }];
  readonly turn = new Float64Array(4);
  private readonly before = new Float64Array(4);

  /** @param angle rolled, rad */
  push(angle: number): void {
    this.turn[1] = Math.sin(angle / 2);
    this.turn[3] = Math.cos(angle / 2);
    keepSign(this.turn, this.before);
    this.tracks[0]!.floats.push(this.turn);
  }
}

/** The keys' own clock, s. */
export class TimeKeys {
  readonly floats = new Floats(1);
  count = 0;
  /** As written: of 32 bits. */
  last = 0;

  push(time: number): void {
    this.last = Math.fround(time);
    this.floats.push([time]);
    this.count++;
  }
}

/** Turns a quaternion (x y z w) to the sign nearer to the one before, and becomes that: players then take the short way between them. */
export function keepSign(turn: Float64Array, before: Float64Array): void {
  let dot = 0;
  for (let i = 0; i < 4; i++) dot += turn[i]! * before[i]!;
  for (let i = 0; i < 4; i++) before[i] = turn[i] = dot < 0 ? -turn[i]! : turn[i]!;
}

type Row = [number, number, number, number, number, number, number, number, number, number, number, number];
