import type { SystemFolder } from '../folder.ts';
import { bicycleRiderCases } from './cases.ts';
import { bicycleRiderView } from './view.ts';

export const bicycleRider: SystemFolder = {
  view: bicycleRiderView,
  cases: bicycleRiderCases,
  equations: () => import('./equations.generated.ts'),
  jacobians: () => import('./jacobians.generated.ts'),
  tape: () => import('./accelerations.generated.json'),
  typeset: () => import('./typeset.generated.json'),
  drawing: () => import('./drawing.ts'),
};
