import type { Value } from '../../../geometry/drawing.ts';
import { clamp, type Vec3 } from '../../../geometry/vectors.ts';

/** A size of nothing cannot be drawn: a degenerate parameter shows as a millimetre. */
const smallest = 1e-3;

export interface Dimensions {
  rodLength: number;
  rodRadius: number;
  plateLength: number;
  plateWidth: number;
  plateThickness: number;
  plateOffset: number;
  pivotDrop: number;
  casterAngle: number;
  wheelRadius: number;
  /** In the caster's frame (origin at the skate point, steering axis along z). */
  pivot: Vec3;
  hub: Vec3;
  /** World's up at rest, in the caster's frame. */
  up: Vec3;
  crown: Crown;
}

/** The turntable between plate and fork. */
export interface Crown {
  radius: number;
  /** Half height. */
  half: number;
  /** How far above the pivot, along the steering axis, it sits. */
  lift: number;
}

/** @param value the board's parameters, metres and radians */
export function dimensionsOf(value: Value): Dimensions {
  const size = (name: string): number => Math.max(Math.abs(value(name)), smallest);
  const casterAngle = value('casterAngle');
  const wheelRadius = size('wheelRadius');
  const up: Vec3 = [-Math.sin(casterAngle), 0, Math.cos(casterAngle)];
  const hub: Vec3 = [wheelRadius * up[0], 0, wheelRadius * up[2]];
  const pivot: Vec3 = [value('casterTrail'), 0, value('casterDrop')];
  return {
    rodLength: size('rodLength'),
    rodRadius: size('rodRadius'),
    plateLength: size('plateLength'),
    plateWidth: size('plateWidth'),
    plateThickness: size('plateThickness'),
    plateOffset: value('plateOffset'),
    pivotDrop: value('pivotDrop'),
    casterAngle,
    wheelRadius,
    pivot,
    hub,
    up,
    crown: crownOf(pivot, hub, wheelRadius),
  };
}

/**
 * The pivot is a point on an axis, so the crown may slide along that axis: with the wheel ahead of the
 * pivot the pivot lies inside the tyre, and the crown has to sit above it.
 */
function crownOf(pivot: Vec3, hub: Vec3, wheelRadius: number): Crown {
  const radius = 0.55 * wheelRadius;
  const half = 0.11 * wheelRadius;
  const clear = 1.02 * wheelRadius;
  const across = Math.max(0, Math.abs(hub[0] - pivot[0]) - radius);
  const needed = across < clear ? hub[2] + Math.sqrt(clear * clear - across * across) + half - pivot[2] : 0;
  return { radius, half, lift: clamp(needed, 0, 1.5 * wheelRadius) };
}
