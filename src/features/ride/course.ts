/** A course: gates to be gone through in order, in the plane; the start is at the origin, heading along x. */
export interface Gate {
  x: number;
  y: number;
  /** Direction of going through it, rad. */
  heading: number;
}

/** Half of a gate's width, m. */
export const HALF_WIDTH = 1.2;

/** Straight on, then a gentle S. */
export const gates: readonly Gate[] = [
  { x: 5, y: 0, heading: 0 },
  { x: 10, y: 0.6, heading: 0.25 },
  { x: 15, y: 0.6, heading: -0.25 },
  { x: 20, y: 0, heading: 0 },
];

/** Goes along with a ride: which gates it has gone through, and when it was through the last one. */
export class Passage {
  passed = 0;
  /** s; null on the way. */
  finished: number | null = null;
  private last: { t: number; x: number; y: number } | null = null;
  private readonly course: readonly Gate[];

  constructor(course: readonly Gate[]) {
    this.course = course;
  }

  /** @param t s @param x m @param y m, later than the last */
  at(t: number, x: number, y: number): void {
    const { last } = this;
    this.last = { t, x, y };
    const gate = this.course[this.passed];
    if (!last || !gate || t <= last.t) return;
    const along = (p: { x: number; y: number }): number =>
      (p.x - gate.x) * Math.cos(gate.heading) + (p.y - gate.y) * Math.sin(gate.heading);
    const [before, after] = [along(last), along({ x, y })];
    if (before >= 0 || after < 0) return;
    const share = before / (before - after);
    const [px, py] = [last.x + share * (x - last.x), last.y + share * (y - last.y)];
    const across = (py - gate.y) * Math.cos(gate.heading) - (px - gate.x) * Math.sin(gate.heading);
    if (Math.abs(across) > HALF_WIDTH) return;
    this.passed++;
    if (this.passed === this.course.length) this.finished = last.t + share * (t - last.t);
  }
}
