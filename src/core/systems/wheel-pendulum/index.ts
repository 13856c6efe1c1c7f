import type { SystemFolder } from '../folder.ts';
import { wheelPendulumCases } from './cases.ts';
import { wheelPendulumView } from './view.ts';

export const wheelPendulum: SystemFolder = {
  view: wheelPendulumView,
  cases: wheelPendulumCases,
  equations: () => import('./equations.generated.ts'),
  jacobians: () => import('./jacobians.generated.ts'),
  typeset: () => import('./typeset.generated.json'),
  drawing: () => import('./drawing.ts'),
};
