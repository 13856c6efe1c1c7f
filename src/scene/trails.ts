import * as THREE from 'three';
import type { Trail } from './contract.ts';
import type { Palette } from './palette.ts';

/** Half the width of a track (m). */
const HALF_WIDTH = 0.0035;
const ABOVE_GROUND = 0.0012;

/** Number of times that are not after `time` (times rise). */
export function countUntil(times: Float64Array, count: number, time: number): number {
  let low = 0;
  let high = count;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (times[middle]! <= time) low = middle + 1;
    else high = middle;
  }
  return low;
}

/** One skate's track as a flat ribbon that only ever grows: new points are appended to the buffers. */
class Ribbon {
  readonly mesh = new THREE.Mesh(new THREE.BufferGeometry(), new THREE.MeshBasicMaterial({ side: THREE.DoubleSide, toneMapped: false, transparent: true, opacity: 0.85, depthWrite: false }));
  private positions = new Float32Array(0);
  private filled = 0;
  private source: Trail | null = null;

  constructor() {
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = -1;
  }

  show(trail: Trail, time: number): void {
    if (this.source?.times !== trail.times && !this.continues(trail)) this.filled = 0;
    this.source = trail;
    this.extend(trail);
    const shown = countUntil(trail.times, trail.count, time);
    this.mesh.geometry.setDrawRange(0, Math.max(0, 6 * (shown - 1)));
  }

  /** A grown copy of the same track begins with the same point. */
  private continues(trail: Trail): boolean {
    return this.filled > 0 && trail.count >= this.filled && this.source !== null && trail.times[0] === this.source.times[0] && trail.times[this.filled - 1] === this.source.times[this.filled - 1] && trail.points[0] === this.source.points[0];
  }

  private extend(trail: Trail): void {
    if (trail.count <= this.filled) return;
    if (6 * trail.count > this.positions.length) this.grow(trail.count);
    const from = this.filled;
    for (let i = from; i < trail.count; i++) this.point(trail, i);
    this.filled = trail.count;
    const attribute = this.mesh.geometry.getAttribute('position') as THREE.BufferAttribute;
    attribute.addUpdateRange(6 * from, 6 * (this.filled - from));
    attribute.needsUpdate = true;
  }

  /** Two vertices on either side of the track, across its direction there. */
  private point(trail: Trail, i: number): void {
    const { points } = trail;
    const before = 3 * Math.max(0, i - 1);
    const after = 3 * Math.min(trail.count - 1, i + 1);
    const dx = points[after]! - points[before]!;
    const dy = points[after + 1]! - points[before + 1]!;
    const scale = HALF_WIDTH / (Math.hypot(dx, dy) || 1);
    const [x, y, z] = [points[3 * i]!, points[3 * i + 1]!, points[3 * i + 2]! + ABOVE_GROUND];
    this.positions.set([x - dy * scale, y + dx * scale, z, x + dy * scale, y - dx * scale, z], 6 * i);
  }

  private grow(count: number): void {
    const room = Math.max(2 * count, 2048);
    const positions = new Float32Array(6 * room);
    positions.set(this.positions.subarray(0, 6 * this.filled));
    this.positions = positions;
    const index = new Uint32Array(6 * (room - 1));
    for (let i = 0; i < room - 1; i++) index.set([2 * i, 2 * i + 1, 2 * i + 2, 2 * i + 2, 2 * i + 1, 2 * i + 3], 6 * i);
    this.mesh.geometry.dispose();
    this.mesh.geometry = new THREE.BufferGeometry();
    this.mesh.geometry.setAttribute('position', new THREE.BufferAttribute(positions, 3).setUsage(THREE.DynamicDrawUsage));
    this.mesh.geometry.setIndex(new THREE.BufferAttribute(index, 1));
  }
}

/** Tracks of the skate points, drawn up to the present. */
export class Trails {
  readonly group = new THREE.Group();
  private readonly ribbons = new Map<string, Ribbon>();
  private palette: Palette | null = null;

  show(trails: readonly Trail[], time: number): void {
    for (const trail of trails) {
      let ribbon = this.ribbons.get(trail.part);
      if (!ribbon) {
        ribbon = new Ribbon();
        this.ribbons.set(trail.part, ribbon);
        this.group.add(ribbon.mesh);
        if (this.palette) ribbon.mesh.material.color.set(this.palette[trail.part]);
      }
      ribbon.show(trail, time);
    }
  }

  setPalette(palette: Palette): void {
    this.palette = palette;
    for (const [part, ribbon] of this.ribbons) ribbon.mesh.material.color.set(palette[part as 'front' | 'back']);
  }
}
