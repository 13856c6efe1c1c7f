import type { SystemFolder } from '../folder.ts';
import { cartPendulumCases } from './cases.ts';
import { cartPendulumView } from './view.ts';

export const cartPendulum: SystemFolder = {
  view: cartPendulumView,
  cases: cartPendulumCases,
  equations: () => import('./equations.generated.ts'),
  jacobians: () => import('./jacobians.generated.ts'),
  typeset: () => import('./typeset.generated.json'),
  drawing: () => import('./drawing.ts'),
};
