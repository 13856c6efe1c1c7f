import type { SystemMeta } from '../types.ts';

const authors = 'model of the report’s authors';
const degree = Math.PI / 180;

/** The board: five bodies, ten coordinates, four multipliers. Order and names are part of every file format. */
export const ripstikMeta = {
  id: 'ripstik',
  title: 'RipStik (caster board)',
  coordinates: [
    { name: 'X', symbol: 'X', label: 'rod centre, forward', kind: 'length', part: 'board' },
    { name: 'Y', symbol: 'Y', label: 'rod centre, to the left', kind: 'length', part: 'board' },
    { name: 'Z', symbol: 'Z', label: 'rod centre, height', kind: 'length', part: 'board' },
    { name: 'alpha', symbol: 'α', label: 'rod roll', kind: 'angle', part: 'board' },
    { name: 'psi', symbol: 'ψ', label: 'pitch', kind: 'angle', part: 'board' },
    { name: 'theta', symbol: 'θ', label: 'yaw (heading)', kind: 'angle', part: 'board' },
    { name: 'alpha_fp', symbol: 'α_fp', label: 'front plate roll on the rod', kind: 'angle', part: 'front' },
    { name: 'alpha_bp', symbol: 'α_bp', label: 'back plate roll on the rod', kind: 'angle', part: 'back' },
    { name: 'theta_fc', symbol: 'θ_fc', label: 'front caster steer', kind: 'angle', part: 'front' },
    { name: 'theta_bc', symbol: 'θ_bc', label: 'back caster steer', kind: 'angle', part: 'back' },
  ],
  parameters: [
    { name: 'rodMass', symbol: 'm_r', label: 'rod mass', unit: 'kg', default: 2, min: 0, group: 'Rod', source: authors },
    { name: 'rodLength', symbol: 'L_r', label: 'rod length', unit: 'm', default: 0.25, min: 0, group: 'Rod', source: authors },
    { name: 'rodRadius', symbol: 'R_r', label: 'rod radius', unit: 'm', default: 0.02, min: 0, group: 'Rod', source: authors },
    { name: 'plateMass', symbol: 'm_p', label: 'plate mass', unit: 'kg', default: 1, min: 0, group: 'Plates', source: authors },
    { name: 'plateLength', symbol: 'L_p', label: 'plate length', unit: 'm', default: 0.36, min: 0, group: 'Plates', source: authors },
    { name: 'plateWidth', symbol: 'W_p', label: 'plate width', unit: 'm', default: 0.22, min: 0, group: 'Plates', source: authors },
    { name: 'plateThickness', symbol: 'T_p', label: 'plate thickness', unit: 'm', default: 0.05, min: 0, group: 'Plates', source: authors },
    { name: 'plateOffset', symbol: 'd_p', label: 'plate centre from rod centre', unit: 'm', default: 0.26, min: 0, group: 'Plates', source: authors },
    { name: 'pivotDrop', symbol: 'd_v', label: 'caster pivot below plate centre', unit: 'm', default: 0.05, group: 'Casters', source: authors },
    { name: 'casterAngle', symbol: 'φ', label: 'caster angle', unit: 'rad', kind: 'angle', default: 30 * degree, group: 'Casters', note: 'tilt of the steering axis about y; its lower end points backwards', source: authors },
    { name: 'casterTrail', symbol: 'c', label: 'caster trail', unit: 'm', default: 0.04, group: 'Casters', note: 'positive: the wheel is behind its pivot', source: 'size from the model of the report’s authors; its sign is the product’s, theirs is in the set “authors”' },
    { name: 'casterDrop', symbol: 'd_c', label: 'skate point below pivot', unit: 'm', default: 0.06, group: 'Casters', source: authors },
    { name: 'casterMass', symbol: 'm_c', label: 'caster mass', unit: 'kg', default: 0.5, min: 0, group: 'Casters', source: authors },
    { name: 'wheelRadius', symbol: 'R_w', label: 'wheel radius', unit: 'm', default: 0.04, min: 0, group: 'Casters', source: authors },
    { name: 'gravity', symbol: 'g', label: 'gravity', unit: 'm/s²', default: 9.81, group: 'World', source: 'the earth’s, rounded' },
    { name: 'torsionStiffness', symbol: 'k_t', label: 'torsion bar stiffness', unit: 'N·m/rad', default: 0, min: 0, group: 'Springs and losses', source: 'none, as the report assumes' },
    { name: 'torsionDamping', symbol: 'c_t', label: 'torsion bar damping', unit: 'N·m·s/rad', default: 0, min: 0, group: 'Springs and losses', source: 'none, as the report assumes' },
    { name: 'jointDamping', symbol: 'c_j', label: 'plate joint damping', unit: 'N·m·s/rad', default: 0, min: 0, group: 'Springs and losses', source: 'none, as the report assumes' },
    { name: 'casterDamping', symbol: 'c_c', label: 'caster bearing damping', unit: 'N·m·s/rad', default: 0, min: 0, group: 'Springs and losses', source: 'none, as the report assumes' },
    { name: 'wheelDrag', symbol: 'c_w', label: 'wheel drag', unit: 'N·s/m', default: 0, min: 0, group: 'Springs and losses', source: 'none, as the report assumes' },
  ],
  parameterSets: { street: {}, authors: { casterTrail: -0.04 } },
  constraintSets: [
    { id: 'rolling', label: 'Rolling: each skate moves in its own plane, on the ground' },
    { id: 'report', label: 'As the report: no world-Y motion of the skates, on the ground' },
    { id: 'none', label: 'None: free bodies' },
  ],
  inputs: [
    { name: 'tau_fp', symbol: 'τ_fp', label: 'foot torque on the front plate', unit: 'N·m', column: { alpha: 1, alpha_fp: 1 }, tracks: ['alpha', 'alpha_fp'] },
    { name: 'tau_bp', symbol: 'τ_bp', label: 'foot torque on the back plate', unit: 'N·m', column: { alpha: 1, alpha_bp: 1 }, tracks: ['alpha', 'alpha_bp'] },
    { name: 'tau_twist', symbol: 'τ_tw', label: 'torque between the plates', unit: 'N·m', column: { alpha_fp: 1, alpha_bp: -1 }, tracks: ['alpha_fp'] },
    { name: 'tau_fc', symbol: 'τ_fc', label: 'front steering motor', unit: 'N·m', column: { theta_fc: 1 }, tracks: ['theta_fc'] },
    { name: 'tau_bc', symbol: 'τ_bc', label: 'back steering motor', unit: 'N·m', column: { theta_bc: 1 }, tracks: ['theta_bc'] },
  ],
  regulators: ['tau_fc', 'tau_bc'],
  forward: { along: ['X_dot', 'Y_dot'], heading: 'theta' },
  bodies: [
    { id: 'rod', label: 'rod', part: 'board' },
    { id: 'front-plate', label: 'front plate', part: 'front' },
    { id: 'back-plate', label: 'back plate', part: 'back' },
    { id: 'front-caster', label: 'front caster', part: 'front' },
    { id: 'back-caster', label: 'back caster', part: 'back' },
  ],
} as const satisfies SystemMeta;
