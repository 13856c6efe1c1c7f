import type { Dimensions } from './dimensions.ts';
import { monotoneCurve } from '../../../geometry/shapes.ts';
import { clamp, mix, smoothStep, steps } from '../../../geometry/vectors.ts';

/**
 * The form of one platform, in a frame of its own: x from the waist (-length/2) to the kick (+length/2).
 * `s` runs 0..1 along x, `t` -1..1 across, from edge to edge.
 */
export interface Deck {
  /** Outline of the bumper, and of the skin inside it; one side (y >= 0), waist to tip. */
  outline: readonly PlanStation[];
  inset: readonly PlanStation[];
  bumperWidth: number;
  halfWidthAt(x: number): number;
  top(s: number, t: number): number;
  under(s: number, t: number): number;
  bumperHeight(s: number): number;
  /** Height of the skin's rim. */
  edge(s: number): number;
  /** Surface heights by plan position. */
  topAt(x: number, y: number): number;
  underAt(x: number, y: number): number;
  along(x: number): number;
}

export interface PlanStation {
  x: number;
  y: number;
}

/** Knots of the outline, waist to tip: a hand-drawn paddle after the report's Fig. 1, in fractions of length and half width. */
const outlineS = [0.006, 0.1, 0.2, 0.3, 0.41, 0.53, 0.67, 0.8, 0.9, 0.955, 0.988, 1];
const outlineW = [0, 0.01, 0.17, 0.58, 0.9, 1, 0.94, 0.75, 0.54, 0.39, 0.2, 0];
const stationsPerKnot = 4;

export const waistHalfWidth = (d: Dimensions): number =>
  Math.min(Math.max(0.29 * (d.plateWidth / 2), 1.55 * d.rodRadius), 0.6 * (d.plateWidth / 2));

/**
 * Form of a plate: its outline and surfaces, and the bumper round it.
 *
 * @param d dimensions, m
 * @param kickHeight m
 */
export function deckOf(d: Dimensions, kickHeight: number): Deck {
  const [L, W, T] = [d.plateLength, d.plateWidth, d.plateThickness];
  const bumperWidth = Math.min(0.12 * T, 0.06 * W, 0.03 * L);
  const outline = outlineOf(L, W / 2, waistHalfWidth(d) / (W / 2));
  const inset = insetOf(outline, bumperWidth);
  const along = (x: number): number => clamp((x + L / 2) / L, 0, 1);

  const kick = (s: number): number => kickHeight * smoothStep(0.68, 1.1, s) * 1.35;
  const edge = (s: number): number => mix(0.3 * T, 0.5 * T, smoothStep(0, 0.28, s)) + kick(s);
  const bumperHeight = (s: number): number => 0.32 * T * (1 - 0.25 * smoothStep(0.8, 1, s));
  // Both surfaces flatten out towards the tip, where all of t is one point.
  const bowl = (s: number): number => smoothStep(0.02, 0.34, s) * (1 - smoothStep(0.78, 1, s));
  const top = (s: number, t: number): number => edge(s) - 0.2 * T * bowl(s) * (1 - Math.abs(t) ** 2.4);
  const under = (s: number, t: number): number =>
    edge(s) - bumperHeight(s) - 0.1 * T * bowl(s) * (1 - Math.abs(t) ** 3);

  const halfWidthAt = (x: number): number => {
    const i = inset.findIndex((p) => p.x >= x);
    const [before, after] = [inset[Math.max(0, i - 1)], inset[i < 0 ? inset.length - 1 : i]];
    if (!before || !after || after.x <= before.x) return after?.y ?? 0;
    return mix(before.y, after.y, clamp((x - before.x) / (after.x - before.x), 0, 1));
  };
  const across = (x: number, y: number): number => clamp(y / Math.max(halfWidthAt(x), 1e-6), -1, 1);
  return {
    outline,
    inset,
    bumperWidth,
    halfWidthAt,
    top,
    under,
    bumperHeight,
    edge,
    along,
    topAt: (x, y) => top(along(x), across(x, y)),
    underAt: (x, y) => under(along(x), across(x, y)),
  };
}

function outlineOf(L: number, halfWidth: number, waist: number): PlanStation[] {
  const x = monotoneCurve(outlineS.map((s) => (s - 0.5) * L));
  // The tip closes; elsewhere the knots fill what is left beside the waist.
  const y = monotoneCurve(
    outlineW.map(
      (w, i) => (i < outlineW.length - 1 ? Math.min(1, Math.max(w, i > 6 ? 0 : mix(waist, 1, w))) : 0) * halfWidth,
    ),
  );
  const last = outlineS.length - 1;
  const drawn = steps(0, last, last * stationsPerKnot).map((u) => ({ x: x(u), y: y(u) }));
  return fitted(smoothed(drawn, 6), L, halfWidth);
}

/** Monotone curves bend abruptly at their knots; a few passes of averaging even that out. */
function smoothed(path: readonly PlanStation[], passes: number): PlanStation[] {
  let now = [...path];
  for (let pass = 0; pass < passes; pass++) {
    now = now.map((p, i) => {
      const before = now[i - 1];
      const after = now[i + 1] ?? { x: before?.x ?? p.x, y: -(before?.y ?? 0) };
      if (!before) return p;
      return { x: (before.x + 2 * p.x + after.x) / 4, y: (before.y + 2 * p.y + after.y) / 4 };
    });
  }
  return now;
}

/** Averaging shrinks: stretch the outline back to the prism's plan. */
function fitted(path: readonly PlanStation[], L: number, halfWidth: number): PlanStation[] {
  const start = path[0]?.x ?? 0;
  const tip = path[path.length - 1]?.x ?? 0;
  const widest = path.reduce((most, p) => Math.max(most, p.y), 0);
  return path.map((p, i) =>
    i === path.length - 1
      ? { x: L / 2, y: 0 }
      : { x: start + ((p.x - start) * (L / 2 - start)) / (tip - start), y: (p.y * halfWidth) / widest },
  );
}

/** The outline moved inwards by a distance; x keeps rising, y stays on its side. */
function insetOf(outline: readonly PlanStation[], distance: number): PlanStation[] {
  let reached = -Infinity;
  return outline.map((p, i) => {
    const before = outline[i - 1] ?? p;
    const last = i === outline.length - 1;
    const after = outline[i + 1] ?? { x: before.x, y: -before.y }; // beyond the tip lies the mirror image
    const [dx, dy] = i === 0 ? [1, 0] : [after.x - before.x, after.y - before.y];
    const size = Math.hypot(dx, dy) || 1;
    reached = Math.max(reached, p.x + (distance * dy) / size);
    return { x: reached, y: last ? 0 : Math.max(0, p.y - (distance * dx) / size) };
  });
}
