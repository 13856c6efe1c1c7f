import type { SystemMeta } from '../types.ts';

const benchmark = 'Meijaard et al. 2007, Table 1';
const degree = Math.PI / 180;
const down = 'in the axes of the paper: x forward, z down, from the rear contact';

/**
 * The Whipple bicycle with the benchmark's parameters: Meijaard, Papadopoulos, Ruina and Schwab, Proc. R. Soc. A 463
 * (2007), doi 10.1098/rspa.2007.1857, Table 1.
 */
export const bicycleMeta = {
  id: 'bicycle',
  title: 'Bicycle (Whipple)',
  coordinates: [
    { name: 'x', symbol: 'x', label: 'rear contact, forward', kind: 'length', part: 'back' },
    { name: 'y', symbol: 'y', label: 'rear contact, to the left', kind: 'length', part: 'back' },
    { name: 'yaw', symbol: 'ψ', label: 'heading, to the left', kind: 'angle', part: 'board' },
    { name: 'roll', symbol: 'φ', label: 'lean, to the right', kind: 'angle', part: 'board' },
    { name: 'pitch', symbol: 'θ', label: 'pitch of the rear frame, nose down', kind: 'angle', part: 'board' },
    { name: 'steer', symbol: 'δ', label: 'steer, to the right', kind: 'angle', part: 'front' },
    { name: 'rear_spin', symbol: 'θ_R', label: 'rear wheel in its frame, forward', kind: 'angle', part: 'back' },
    { name: 'front_spin', symbol: 'θ_F', label: 'front wheel in its fork, forward', kind: 'angle', part: 'front' },
  ],
  parameters: [
    { name: 'wheelbase', symbol: 'w', label: 'wheelbase', unit: 'm', default: 1.02, positive: true, group: 'Whole', source: benchmark },
    { name: 'trail', symbol: 'c', label: 'trail', unit: 'm', default: 0.08, group: 'Whole', note: 'positive: the steering axis meets the ground ahead of the front contact', source: benchmark },
    { name: 'steerAxisTilt', symbol: 'λ', label: 'steer axis tilt', unit: 'rad', kind: 'angle', default: 18 * degree, group: 'Whole', note: 'from the vertical, backwards; 90° less the head angle', source: benchmark },
    { name: 'gravity', symbol: 'g', label: 'gravity', unit: 'm/s²', default: 9.81, group: 'Whole', source: benchmark },
    { name: 'rearRadius', symbol: 'r_R', label: 'radius', unit: 'm', default: 0.3, positive: true, group: 'Rear wheel', source: benchmark },
    { name: 'rearMass', symbol: 'm_R', label: 'mass', unit: 'kg', default: 2, min: 0, group: 'Rear wheel', source: benchmark },
    { name: 'rearIxx', symbol: 'I_Rxx', label: 'inertia about a diameter', unit: 'kg·m²', default: 0.0603, positive: true, group: 'Rear wheel', source: benchmark },
    { name: 'rearIyy', symbol: 'I_Ryy', label: 'inertia about the axle', unit: 'kg·m²', default: 0.12, positive: true, group: 'Rear wheel', source: benchmark },
    { name: 'frameX', symbol: 'x_B', label: 'centre of mass, x', unit: 'm', default: 0.3, group: 'Rear frame and rider', note: down, source: benchmark },
    { name: 'frameZ', symbol: 'z_B', label: 'centre of mass, z', unit: 'm', default: -0.9, group: 'Rear frame and rider', note: down, source: benchmark },
    { name: 'frameMass', symbol: 'm_B', label: 'mass', unit: 'kg', default: 85, min: 0, group: 'Rear frame and rider', source: benchmark },
    { name: 'frameIxx', symbol: 'I_Bxx', label: 'inertia xx', unit: 'kg·m²', default: 9.2, min: 0, group: 'Rear frame and rider', source: benchmark },
    { name: 'frameIyy', symbol: 'I_Byy', label: 'inertia yy', unit: 'kg·m²', default: 11, min: 0, group: 'Rear frame and rider', source: benchmark },
    { name: 'frameIzz', symbol: 'I_Bzz', label: 'inertia zz', unit: 'kg·m²', default: 2.8, min: 0, group: 'Rear frame and rider', source: benchmark },
    { name: 'frameIxz', symbol: 'I_Bxz', label: 'inertia xz', unit: 'kg·m²', default: 2.4, group: 'Rear frame and rider', note: down, source: benchmark },
    { name: 'forkX', symbol: 'x_H', label: 'centre of mass, x', unit: 'm', default: 0.9, group: 'Front frame', note: down, source: benchmark },
    { name: 'forkZ', symbol: 'z_H', label: 'centre of mass, z', unit: 'm', default: -0.7, group: 'Front frame', note: down, source: benchmark },
    { name: 'forkMass', symbol: 'm_H', label: 'mass', unit: 'kg', default: 4, min: 0, group: 'Front frame', source: benchmark },
    { name: 'forkIxx', symbol: 'I_Hxx', label: 'inertia xx', unit: 'kg·m²', default: 0.05892, min: 0, group: 'Front frame', source: benchmark },
    { name: 'forkIyy', symbol: 'I_Hyy', label: 'inertia yy', unit: 'kg·m²', default: 0.06, min: 0, group: 'Front frame', source: benchmark },
    { name: 'forkIzz', symbol: 'I_Hzz', label: 'inertia zz', unit: 'kg·m²', default: 0.00708, min: 0, group: 'Front frame', source: benchmark },
    { name: 'forkIxz', symbol: 'I_Hxz', label: 'inertia xz', unit: 'kg·m²', default: -0.00756, group: 'Front frame', note: down, source: benchmark },
    { name: 'frontRadius', symbol: 'r_F', label: 'radius', unit: 'm', default: 0.35, positive: true, group: 'Front wheel', source: benchmark },
    { name: 'frontMass', symbol: 'm_F', label: 'mass', unit: 'kg', default: 3, min: 0, group: 'Front wheel', source: benchmark },
    { name: 'frontIxx', symbol: 'I_Fxx', label: 'inertia about a diameter', unit: 'kg·m²', default: 0.1405, positive: true, group: 'Front wheel', source: benchmark },
    { name: 'frontIyy', symbol: 'I_Fyy', label: 'inertia about the axle', unit: 'kg·m²', default: 0.28, positive: true, group: 'Front wheel', source: benchmark },
  ],
  parameterSets: {},
  constraintSets: [
    { id: 'rolling', label: 'Rolling: no slip at either contact, both wheels on the ground' },
  ],
  inputs: [
    { name: 'tau_roll', symbol: 'τ_φ', label: 'torque that leans the rear frame, from outside', unit: 'N·m', column: { roll: 1 }, tracks: ['roll'] },
    { name: 'tau_steer', symbol: 'τ_δ', label: 'steering torque between the frames', unit: 'N·m', column: { steer: 1 }, tracks: ['steer'] },
    { name: 'tau_rear', symbol: 'τ_R', label: 'driving torque between rear frame and wheel', unit: 'N·m', column: { rear_spin: 1 } },
  ],
  speed: { name: 'speed', label: 'forward speed, wheels rolling', along: ['x_dot', 'y_dot'], heading: 'yaw' },
  regulators: ['tau_steer'],
  bodies: [
    { id: 'rear-wheel', label: 'rear wheel', part: 'back' },
    { id: 'rear-frame', label: 'rear frame with rider', part: 'board' },
    { id: 'front-frame', label: 'front frame', part: 'board' },
    { id: 'front-wheel', label: 'front wheel', part: 'front' },
  ],
} as const satisfies SystemMeta;
