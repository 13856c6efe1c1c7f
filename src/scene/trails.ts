/** Ground tracks of the skates: lines of constant width on the screen, drawn up to the current time. */
import { type InstancedBufferGeometry, type Scene, DynamicDrawUsage, InstancedInterleavedBuffer, InterleavedBufferAttribute, Sphere } from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import type { Trail } from './contract.ts';
import type { Palette } from './palette.ts';
import { countUntil, TrackBuffer } from './trackBuffer.ts';

/** CSS pixels. */
const WIDTH = 2.5;

/** A line whose segment i runs from point i to point i + 1 of one shared buffer (the stock geometry stores each point twice). */
function lineOver(points: Float32Array, material: LineMaterial): { line: LineSegments2; buffer: InstancedInterleavedBuffer } {
  const geometry = new LineSegmentsGeometry();
  const buffer = new InstancedInterleavedBuffer(points, 3, 1);
  buffer.setUsage(DynamicDrawUsage);
  geometry.setAttribute('instanceStart', new InterleavedBufferAttribute(buffer, 3, 0));
  geometry.setAttribute('instanceEnd', new InterleavedBufferAttribute(buffer, 3, 3));
  geometry.instanceCount = 0;
  geometry.boundingSphere = new Sphere(undefined, Number.MAX_VALUE); // for sorting only; measuring it would read every point
  const line = new LineSegments2(geometry, material);
  line.frustumCulled = false; // its bounds would have to be measured again with every point
  line.renderOrder = -7;
  return { line, buffer };
}

class Track {
  private readonly scene: Scene;
  private readonly data = new TrackBuffer();
  private readonly material: LineMaterial;
  private body: ReturnType<typeof lineOver>;
  /** From the last kept point to where the skate is now. */
  private readonly head: ReturnType<typeof lineOver>;
  private trail: Trail | null = null;

  constructor(scene: Scene) {
    this.scene = scene;
    this.material = new LineMaterial({ linewidth: WIDTH, transparent: true, depthWrite: false, fog: true, toneMapped: false });
    this.body = lineOver(this.data.points, this.material);
    this.head = lineOver(new Float32Array(6), this.material);
    scene.add(this.body.line, this.head.line);
  }

  setColour(colour: string): void {
    this.material.color.set(colour);
  }

  set(trail: Trail): void {
    this.trail = trail;
    const change = this.data.take(trail);
    if (!change) return;
    if (change.grown) {
      this.scene.remove(this.body.line);
      this.body.line.geometry.dispose();
      this.body = lineOver(this.data.points, this.material);
      this.scene.add(this.body.line);
    } else {
      this.body.buffer.addUpdateRange(3 * change.from, 3 * (this.data.count - change.from));
      this.body.buffer.needsUpdate = true;
    }
  }

  show(time: number, visible: boolean): void {
    const { data, trail } = this;
    const count = visible && trail ? countUntil(data.times, data.count, time) : 0;
    draw(this.body.line, Math.max(0, count - 1));
    draw(this.head.line, 0);
    if (count === 0 || !trail) return;
    const row = countUntil(trail.times, trail.count, time) - 1;
    const next = Math.min(row + 1, trail.count - 1);
    const span = trail.times[next]! - trail.times[row]!;
    const share = span > 0 ? Math.min(1, (time - trail.times[row]!) / span) : 0;
    const head = this.head.buffer.array as Float32Array;
    head.set(data.points.subarray(3 * count - 3, 3 * count));
    for (let i = 0; i < 3; i++) {
      const a = trail.points[3 * row + i]!;
      head[3 + i] = a + share * (trail.points[3 * next + i]! - a);
    }
    head[5] = head[5]! + 0.001;
    if (!head.every(Number.isFinite)) return;
    this.head.buffer.needsUpdate = true;
    draw(this.head.line, 1);
  }

  dispose(): void {
    this.scene.remove(this.body.line, this.head.line);
    this.body.line.geometry.dispose();
    this.head.line.geometry.dispose();
    this.material.dispose();
  }
}

function draw(line: LineSegments2, segments: number): void {
  (line.geometry as InstancedBufferGeometry).instanceCount = segments;
  line.visible = segments > 0;
}

export class Trails {
  private readonly tracks: Track[] = [];
  private parts: readonly Trail['part'][] = [];
  private readonly scene: Scene;
  private palette: Palette;

  constructor(scene: Scene, palette: Palette) {
    this.scene = scene;
    this.palette = palette;
  }

  set(trails: readonly Trail[]): void {
    while (this.tracks.length < trails.length) this.tracks.push(new Track(this.scene));
    while (this.tracks.length > trails.length) this.tracks.pop()!.dispose();
    this.parts = trails.map(({ part }) => part);
    trails.forEach((trail, i) => this.tracks[i]!.set(trail));
    this.setPalette(this.palette);
  }

  setPalette(palette: Palette): void {
    this.palette = palette;
    this.tracks.forEach((track, i) => track.setColour(palette.part[this.parts[i]!]));
  }

  /** Draws up to `time` (s), or nothing. */
  show(time: number, visible: boolean): void {
    for (const track of this.tracks) track.show(time, visible);
  }

  dispose(): void {
    for (const track of this.tracks) track.dispose();
    this.tracks.length = 0;
  }
}
