import type { SystemMeta } from '../../model/system.ts';
import { bicycleMeta } from '../bicycle/meta.ts';

const moore = 'Moore 2012, a Batavus Browser with its rider, legs and upper body apart';
const down = 'in the axes of the paper: x forward, z down, from the rear contact';

/** Frame and fork with the legs in the frame: doi 10.6084/m9.figshare.1198429, the set `mooreriderlean2012_browser_jason` of BicycleParameters. */
const measured: Readonly<Record<string, number>> = {
  wheelbase: 1.121,
  trail: 0.0685808540382,
  steerAxisTilt: 0.399680398707,
  gravity: 9.81,
  rearRadius: 0.340958858855,
  rearMass: 3.11,
  rearIxx: 0.0904106601579,
  rearIyy: 0.152467620286,
  frameX: 0.374570794542,
  frameZ: -0.681592725778,
  frameMass: 33.044,
  frameIxx: 2.18917391377,
  frameIyy: 2.9922715238,
  frameIzz: 1.61787114693,
  frameIxz: -0.27087131147,
  forkX: 0.866949640247,
  forkZ: -0.748236400835,
  forkMass: 3.22,
  forkIxx: 0.253379594731,
  forkIyy: 0.246138810935,
  forkIzz: 0.0955770796289,
  forkIxz: -0.0720452391817,
  frontRadius: 0.34352982332,
  frontMass: 2.02,
  frontIxx: 0.0883819364527,
  frontIyy: 0.149389340425,
};

const upperBody: readonly Omit<SystemMeta['parameters'][number], 'group' | 'source'>[] = [
  {
    name: 'hingeZ',
    symbol: 'z_S',
    label: 'axis of the lean, z',
    unit: 'm',
    default: -1.011421527346159,
    note: down,
  },
  {
    name: 'riderX',
    symbol: 'x_G',
    label: 'centre of mass, x',
    unit: 'm',
    default: 0.231223496809401,
    note: down,
  },
  {
    name: 'riderZ',
    symbol: 'z_G',
    label: 'centre of mass, z',
    unit: 'm',
    default: -1.283035074598082,
    note: down,
  },
  {
    name: 'riderMass',
    symbol: 'm_G',
    label: 'mass',
    unit: 'kg',
    default: 48.816,
    min: 0,
  },
  {
    name: 'riderIxx',
    symbol: 'I_Gxx',
    label: 'inertia xx',
    unit: 'kg·m²',
    default: 2.038073562525466,
    min: 0,
  },
  {
    name: 'riderIyy',
    symbol: 'I_Gyy',
    label: 'inertia yy',
    unit: 'kg·m²',
    default: 1.692108544034995,
    min: 0,
  },
  {
    name: 'riderIzz',
    symbol: 'I_Gzz',
    label: 'inertia zz',
    unit: 'kg·m²',
    default: 1.100753962972129,
    min: 0,
  },
  {
    name: 'riderIxz',
    symbol: 'I_Gxz',
    label: 'inertia xz',
    unit: 'kg·m²',
    default: 0.002113501449812,
    note: down,
  },
  {
    name: 'leanStiffness',
    symbol: 'k_s',
    label: 'stiffness of the waist',
    unit: 'N·m/rad',
    default: 0,
    min: 0,
  },
  {
    name: 'leanDamping',
    symbol: 'c_s',
    label: 'damping of the waist',
    unit: 'N·m·s/rad',
    default: 0,
    min: 0,
  },
];

/**
 * The bicycle with a rider whose upper body leans: J. K. Moore, Human Control of a Bicycle, dissertation, University of
 * California, Davis, 2012, chapter "Extensions of the Whipple model".
 */
export const bicycleRiderMeta = {
  ...bicycleMeta,
  id: 'bicycle-rider',
  title: 'Bicycle with a leaning rider',
  coordinates: [
    ...bicycleMeta.coordinates,
    { name: 'lean', symbol: 'β', label: 'upper body on the frame, to the right', kind: 'angle', role: 'neutral' },
  ],
  parameters: [
    ...bicycleMeta.parameters.map((parameter) => ({
      ...parameter,
      default: measured[parameter.name]!,
      group: parameter.group === 'Rear frame and rider' ? 'Rear frame with legs' : parameter.group,
    })),
    ...upperBody.map((parameter) => ({ ...parameter, group: 'Upper body', source: moore })),
  ],
  inputs: [
    ...bicycleMeta.inputs,
    {
      name: 'tau_lean',
      symbol: 'τ_β',
      label: 'torque between upper body and frame',
      unit: 'N·m',
      column: { lean: 1 },
      tracks: ['lean'],
    },
  ],
  regulators: ['tau_steer', 'tau_lean'],
  bodies: [
    ...bicycleMeta.bodies.map((body) => (body.id === 'rear-frame' ? { ...body, label: 'rear frame with legs' } : body)),
    { id: 'rider', label: 'upper body', role: 'neutral' },
  ],
} as const satisfies SystemMeta;
