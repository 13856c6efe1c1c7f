import type { SystemFolder } from '../folder.ts';
import { bicycleCases } from './cases.ts';
import { bicycleView } from './view.ts';

export const bicycle: SystemFolder = {
  view: bicycleView,
  cases: bicycleCases,
  equations: () => import('./equations.generated.ts'),
  jacobians: () => import('./jacobians.generated.ts'),
  tape: () => import('./accelerations.generated.json'),
  typeset: () => import('./typeset.generated.json'),
  drawing: () => import('./drawing.ts'),
};
