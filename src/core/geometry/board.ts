/** The board on its stage, without its meshes: light enough for the first view, which loads those as files. */
import type { Stage, Wearer } from './drawing.ts';
import type { Vec3 } from './vectors.ts';

/** Parameters that shape the board's meshes; when one differs from its default they are made anew instead of loaded. */
export const boardShape = [
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

/** Where the wheel turns in the caster's frame (m): straight above the skate point at rest. */
export const hubOf = (casterAngle: number, wheelRadius: number): Vec3 => [
  -wheelRadius * Math.sin(casterAngle),
  0,
  wheelRadius * Math.cos(casterAngle),
];

/** Both casters are drawn from one pair. */
export function boardBodies(parameters: Readonly<Record<string, number>>): readonly Wearer[] {
  const hub = hubOf(parameters['casterAngle'] ?? Math.PI / 6, parameters['wheelRadius'] ?? 0.04);
  return [
    { id: 'rod', part: 'board', model: 'rod' },
    { id: 'front-plate', part: 'front', model: 'front-plate' },
    { id: 'back-plate', part: 'back', model: 'back-plate' },
    { id: 'front-caster', part: 'front', model: 'caster', spin: { hub, contact: 0 } },
    { id: 'back-caster', part: 'back', model: 'caster', spin: { hub, contact: 1 } },
  ];
}

export const boardStage: Stage = { subject: 0, facing: 'nose', still: false, floor: 0, closeUp: 3 };
