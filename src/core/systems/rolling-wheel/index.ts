import type { SystemFolder } from '../folder.ts';
import { rollingWheelCases } from './cases.ts';
import { rollingWheelView } from './view.ts';

export const rollingWheel: SystemFolder = {
  view: rollingWheelView,
  cases: rollingWheelCases,
  equations: () => import('./equations.generated.ts'),
  jacobians: () => import('./jacobians.generated.ts'),
  typeset: () => import('./typeset.generated.json'),
  drawing: () => import('./drawing.ts'),
};
