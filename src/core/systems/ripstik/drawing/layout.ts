/** The board on its stage, without its meshes. */
import type { Layout, Value } from '../../../geometry/drawing.ts';
import type { Vec3 } from '../../../geometry/vectors.ts';

/** Parameters that shape the meshes. */
export const shapedBy = [
  'rodLength',
  'rodRadius',
  'plateLength',
  'plateWidth',
  'plateThickness',
  'plateOffset',
  'pivotDrop',
  'casterAngle',
  'casterTrail',
  'casterDrop',
  'wheelRadius',
] as const;

/**
 * Where the wheel turns in the caster's frame (m): straight above the skate point at rest.
 *
 * @param casterAngle rad
 * @param wheelRadius m
 */
export const hubOf = (casterAngle: number, wheelRadius: number): Vec3 => [
  -wheelRadius * Math.sin(casterAngle),
  0,
  wheelRadius * Math.cos(casterAngle),
];

/**
 * Both casters' wheels turn.
 *
 * @param p parameters by name, SI
 */
export function layout(p: Value): Layout {
  const hub = hubOf(p('casterAngle'), p('wheelRadius'));
  return { spins: { 'front-caster': { hub, contact: 0 }, 'back-caster': { hub, contact: 1 } } };
}
