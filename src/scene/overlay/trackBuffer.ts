/** A ground track as the graphics card wants it: thinned, growing at its end, cut at a time. No renderer here. */
import type { Trail } from '../contract.ts';

/** Points closer together than this (m) are one point: a wheel that stands still adds nothing. */
const SPACING = 0.003;
/** Points kept of one track: of a longer one every second goes, as often as it takes. An hour's ride is drawn like a minute's. */
export const MOST_POINTS = 32_768;
/** A track this little above its points (m) is not swallowed by the ground. */
const LIFT = 0.001;

/** How many of the first `count` times are not after `time`. Times rise. */
export function countUntil(times: ArrayLike<number>, count: number, time: number): number {
  let low = 0;
  let high = count;
  while (low < high) {
    const middle = (low + high) >>> 1;
    if (times[middle]! <= time) low = middle + 1;
    else high = middle;
  }
  return low;
}

export class TrackBuffer {
  /** 3 floats per kept point. */
  points = new Float32Array(3 * 256);
  times = new Float64Array(256);
  count = 0;
  /** How much higher its points are than the trail's (m). */
  readonly lift = LIFT;
  /** Points of the trail that have been read. */
  private read = 0;
  private spacing = SPACING;
  private thinned = false;
  private first: readonly number[] = [];
  private last: readonly number[] = [];

  /**
   * Takes what is new in a trail. Says where the change starts (index of a kept point), or null if nothing changed;
   * `grown` when the arrays were replaced by larger ones. A trail that is not a continuation starts over.
   */
  take(trail: Trail): { from: number; grown: boolean } | null {
    const continues =
      trail.count >= this.read && same(this.first, at(trail, 0)) && same(this.last, at(trail, this.read - 1));
    const restarted = !continues && this.read > 0;
    if (!continues) this.clear();
    const before = this.count;
    const room = this.points.length;
    this.thinned = false;
    for (let i = this.read; i < trail.count; i++) this.keep(trail, i);
    if (trail.count > 0) {
      this.first = at(trail, 0);
      this.last = at(trail, trail.count - 1);
    }
    this.read = trail.count;
    const from = this.thinned ? 0 : before;
    return this.count === before && !restarted && !this.thinned ? null : { from, grown: this.points.length !== room };
  }

  clear(): void {
    this.count = 0;
    this.read = 0;
    this.spacing = SPACING;
    this.first = this.last = [];
  }

  private keep(trail: Trail, i: number): void {
    const [x, y, z] = [trail.points[3 * i]!, trail.points[3 * i + 1]!, trail.points[3 * i + 2]! + LIFT];
    if (!Number.isFinite(x + y + z)) return;
    const o = 3 * this.count;
    if (this.count > 0) {
      const far = Math.hypot(x - this.points[o - 3]!, y - this.points[o - 2]!, z - this.points[o - 1]!);
      if (far < this.spacing) return;
    }
    if (this.count === MOST_POINTS) this.thin();
    if (this.count === this.times.length) this.grow();
    const end = 3 * this.count;
    this.points[end] = x;
    this.points[end + 1] = y;
    this.points[end + 2] = z;
    this.times[this.count] = trail.times[i]!;
    this.count++;
  }

  /** Lets every second point go. */
  private thin(): void {
    const kept = this.count >> 1;
    for (let k = 1; k < kept; k++) {
      this.points.copyWithin(3 * k, 6 * k, 6 * k + 3);
      this.times[k] = this.times[2 * k]!;
    }
    this.count = kept;
    this.spacing *= 2;
    this.thinned = true;
  }

  private grow(): void {
    const points = new Float32Array(2 * this.points.length);
    points.set(this.points);
    const times = new Float64Array(2 * this.times.length);
    times.set(this.times);
    this.points = points;
    this.times = times;
  }
}

/** Time and place of a point, to tell a longer track from another one. */
function at(trail: Trail, i: number): readonly number[] {
  return i < 0 || i >= trail.count ? [] : [trail.times[i]!, trail.points[3 * i]!, trail.points[3 * i + 1]!];
}

function same(a: readonly number[], b: readonly number[]): boolean {
  return a.length === b.length && a.every((x, i) => Object.is(x, b[i]));
}
