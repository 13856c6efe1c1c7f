import type { SystemMeta } from '../../model/system.ts';
import { gravity } from '../gravity.ts';

const report = 'report, section 3.3.1';

/** The pendulum on a cart (report 3.3.1, Eq. 17 to 19, Fig. 7): upright at theta = +90°. Names are the report's. */
export const cartPendulumMeta = {
  id: 'cart-pendulum',
  title: 'Cart and pendulum',
  coordinates: [
    { name: 'X', symbol: 'X', label: 'cart, to the right', kind: 'length', role: 'neutral' },
    {
      name: 'theta',
      symbol: 'θ',
      label: 'pendulum, from the horizontal',
      kind: 'angle',
      role: 'first',
      rest: Math.PI / 2,
    },
  ],
  parameters: [
    {
      name: 'm1',
      symbol: 'm_1',
      label: 'cart mass',
      unit: 'kg',
      default: 0.3,
      positive: true,
      group: 'Cart',
      source: report,
    },
    {
      name: 'm2',
      symbol: 'm_2',
      label: 'pendulum mass',
      unit: 'kg',
      default: 0.1,
      positive: true,
      group: 'Pendulum',
      source: report,
    },
    {
      name: 'L',
      symbol: 'L',
      label: 'centre of mass from pivot',
      unit: 'm',
      default: 1,
      positive: true,
      group: 'Pendulum',
      note: 'also its radius of gyration about that centre',
      source: report,
    },
    gravity,
  ],
  parameterSets: {},
  constraintSets: [{ id: 'none', label: 'None: there are no constraints' }],
  inputs: [{ name: 'f_X', symbol: 'f_X', label: 'force on the cart', unit: 'N', column: { X: 1 }, tracks: ['X'] }],
  bodies: [
    { id: 'cart', label: 'cart', role: 'neutral' },
    { id: 'pendulum', label: 'pendulum', role: 'first' },
  ],
} as const satisfies SystemMeta;
