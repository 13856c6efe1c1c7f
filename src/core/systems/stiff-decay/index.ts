import type { SystemFolder } from '../folder.ts';
import { stiffDecayCases } from './cases.ts';
import { stiffDecayView } from './view.ts';

export const stiffDecay: SystemFolder = {
  view: stiffDecayView,
  cases: stiffDecayCases,
  equations: () => import('./equations.generated.ts'),
  jacobians: () => import('./jacobians.generated.ts'),
  typeset: () => import('./typeset.generated.json'),
  drawing: () => import('./drawing.ts'),
};
