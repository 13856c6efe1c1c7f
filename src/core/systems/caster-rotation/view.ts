import type { SystemView } from '../../model/system.ts';
import { casterRotationMeta } from './meta.ts';
import { poses } from './poses.generated.ts';

/** The caster's origin is its skate point Ry(casterAngle) Rz(theta_c) (-casterTrail, 0, -casterDrop); steering axis along its z, axle along its y. */
export const casterRotationView: SystemView = {
  meta: casterRotationMeta,
  poses,
  contacts: [],
  tracks: [{ body: 0, role: 'first' }],
};
