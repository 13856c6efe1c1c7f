/** Pictures that must come soon, as while somebody steers: a device that is too slow for them draws less. */

/** Share of the pixels along each side, by how much is left out; from the second on all is drawn plainly. */
const SHARES = [1, 0.75, 0.55, 0.4] as const;
/** Without a graphics card it begins there. */
const SOFTWARE = 2;
/** So many pictures in a row are measured; more than so long from one to the next, on the median, is too slow, ms. */
const MEASURED = 12;
const SLOW = 26;
/** After a longer pause there was nothing to draw, ms. */
const PAUSE = 1000;

export class Haste {
  private readonly first: number;
  private on = false;
  private level = 0;
  private last = -Infinity;
  private readonly intervals: number[] = [];
  /** The first pictures have shaders to compile: they tell nothing. */
  private cold = true;

  /** @param software whether a program on the processor draws */
  constructor(software: boolean) {
    this.first = software ? SOFTWARE : 0;
  }

  get share(): number {
    return SHARES[this.level]!;
  }

  /** Whether surfaces, shadows and ground are left plain. */
  get plain(): boolean {
    return this.level > 0;
  }

  /** Within a time of haste less is drawn than before, never more: a picture that goes to and fro is worse than a coarse one. */
  set(on: boolean): void {
    if (on === this.on) return;
    this.on = on;
    this.level = on ? this.first : 0;
    this.last = -Infinity;
    this.intervals.length = 0;
    this.cold = true;
  }

  /** A picture is drawn, now (ms). @returns whether less is drawn from this one on */
  picture(now: number): boolean {
    const interval = now - this.last;
    this.last = now;
    if (!this.on || interval > PAUSE) return false;
    this.intervals.push(interval);
    if (this.intervals.length < MEASURED) return false;
    const median = this.intervals.sort((a, b) => a - b)[MEASURED / 2]!;
    this.intervals.length = 0;
    const { cold } = this;
    this.cold = false;
    if (cold || median <= SLOW || this.level === SHARES.length - 1) return false;
    this.level++;
    this.cold = true;
    return true;
  }
}
