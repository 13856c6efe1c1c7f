/** Ground tracks of the skates, drawn up to the current time: wheel marks on the floor, thin lines in the air. */
import type { Scene } from 'three';
import type { Trail } from '../contract.ts';
import type { Palette } from '../palette.ts';
import { countUntil, TrackBuffer } from './trackBuffer.ts';
import { type MarkMaterial, markMaterial, MarkStrip } from '../actors/wheelMark.ts';
import type { PixelSize } from './words.ts';

/** Half the width of a wheel's mark, per metre of the cast's largest extent. */
const HALF_WIDTH = 0.0062;
/** Points farther than this from the floor (m) are no marks on it. */
const NEAR = 0.006;
/** Segments of a short track: some metres of it. It grows by this many more before the oldest go. */
const SHORT = 768;
const MORE = 256;

class Track {
  private readonly scene: Scene;
  private readonly data = new TrackBuffer();
  private readonly material: MarkMaterial = markMaterial();
  /** The strip's own arrays: a point more at either end. */
  private points = new Float32Array(0);
  private times = new Float32Array(0);
  private body: MarkStrip;
  /** From the last kept point to where the skate is now. */
  private readonly headPoints = new Float32Array(12);
  private readonly headTimes = new Float32Array(4);
  private readonly head: MarkStrip;
  private trail: Trail | null = null;

  constructor(scene: Scene) {
    this.scene = scene;
    this.body = this.strip();
    this.head = new MarkStrip(this.headPoints, this.headTimes, this.material);
    scene.add(this.head.mesh);
  }

  look(colour: string, { perPixel }: PixelSize): void {
    const { uniforms } = this.material;
    uniforms.colour.value.set(colour);
    uniforms.perPixel.value = perPixel;
  }

  set(trail: Trail, floor: number, size: number): void {
    this.trail = trail;
    const change = this.data.take(trail);
    if (!change) return;
    if (change.grown) {
      this.scene.remove(this.body.mesh);
      this.body.mesh.geometry.dispose();
      this.body = this.strip();
    }
    const from = change.grown ? 0 : change.from;
    this.settle(floor, size, change.from);
    this.pad(from);
  }

  /** A path is a mark on the floor as long as no point leaves it. */
  settle(floor: number, size: number, from = 0): void {
    const { data, material } = this;
    let flat = from > 0 ? material.uniforms.flatness.value : 1;
    for (let i = from; i < data.count && flat; i++) if (Math.abs(data.points[3 * i + 2]! - floor) > NEAR) flat = 0;
    material.uniforms.flatness.value = flat;
    material.uniforms.halfWidth.value = flat * HALF_WIDTH * size;
  }

  show(time: number, visible: boolean, short: boolean): void {
    const { data, trail, headPoints, headTimes } = this;
    const count = visible && trail ? countUntil(data.times, data.count, time) : 0;
    this.material.uniforms.now.value = time;
    const segments = Math.max(0, count - 1);
    this.body.draw(segments, short ? MORE * Math.max(0, Math.ceil((segments - SHORT) / MORE) - 1) : 0);
    this.head.draw(0);
    if (count === 0 || !trail) return;
    const row = countUntil(trail.times, trail.count, time) - 1;
    const next = Math.min(row + 1, trail.count - 1);
    const span = trail.times[next]! - trail.times[row]!;
    const share = span > 0 ? Math.min(1, (time - trail.times[row]!) / span) : 0;
    for (let i = 0; i < 3; i++) {
      const a = trail.points[3 * row + i]!;
      headPoints[6 + i] = headPoints[9 + i] = a + share * (trail.points[3 * next + i]! - a) + (i === 2 ? data.lift : 0);
    }
    headPoints.set(data.points.subarray(3 * Math.max(count - 2, 0), 3 * Math.max(count - 1, 1)));
    headPoints.set(data.points.subarray(3 * count - 3, 3 * count), 3);
    if (!headPoints.every(Number.isFinite)) return;
    headTimes.set([0, data.times[count - 1]!, time, time]);
    this.head.changed(0, 4);
    this.head.draw(1);
  }

  dispose(): void {
    this.scene.remove(this.body.mesh, this.head.mesh);
    this.body.mesh.geometry.dispose();
    this.head.mesh.geometry.dispose();
    this.material.dispose();
  }

  /** A strip with room for all that the buffer has room for. */
  private strip(): MarkStrip {
    const room = this.data.times.length + 2;
    this.points = new Float32Array(3 * room);
    this.times = new Float32Array(room);
    const strip = new MarkStrip(this.points, this.times, this.material);
    this.scene.add(strip.mesh);
    return strip;
  }

  /** Copies kept points from this one on, and repeats the first and the last. */
  private pad(from: number): void {
    const { data, points, times } = this;
    const { count } = data;
    if (count === 0) return;
    points.set(data.points.subarray(3 * from, 3 * count), 3 * (from + 1));
    times.set(data.times.subarray(from, count), from + 1);
    if (from === 0) points.set(data.points.subarray(0, 3));
    points.set(data.points.subarray(3 * count - 3, 3 * count), 3 * (count + 1));
    this.body.changed(from, count + 2);
  }
}

export class Trails {
  private readonly tracks: Track[] = [];
  private parts: readonly Trail['role'][] = [];
  private readonly scene: Scene;
  private palette: Palette;
  private pixel: PixelSize = { perPixel: 1e-3, ratio: 1 };
  private floor = 0;
  private size = 0.88;
  private short = false;

  constructor(scene: Scene, palette: Palette) {
    this.scene = scene;
    this.palette = palette;
  }

  /** Whether of each track only the newest metres are drawn, from the next `show` on. */
  setShort(short: boolean): void {
    this.short = short;
  }

  set(trails: readonly Trail[]): void {
    while (this.tracks.length < trails.length) this.tracks.push(new Track(this.scene));
    while (this.tracks.length > trails.length) this.tracks.pop()!.dispose();
    this.parts = trails.map(({ role }) => role);
    trails.forEach((trail, i) => this.tracks[i]!.set(trail, this.floor, this.size));
    this.look();
  }

  setPalette(palette: Palette): void {
    this.palette = palette;
    this.look();
  }

  /** Height of the floor and the cast's largest extent (m). */
  setPlan(floor: number, size: number): void {
    this.floor = floor;
    this.size = size;
    for (const track of this.tracks) track.settle(floor, size);
  }

  resize(pixel: PixelSize): void {
    this.pixel = pixel;
    this.look();
  }

  /** Draws up to `time` (s), or nothing. */
  show(time: number, visible: boolean): void {
    for (const track of this.tracks) track.show(time, visible, this.short);
  }

  dispose(): void {
    for (const track of this.tracks) track.dispose();
    this.tracks.length = 0;
  }

  private look(): void {
    this.tracks.forEach((track, i) => track.look(this.palette.role[this.parts[i]!], this.pixel));
  }
}
