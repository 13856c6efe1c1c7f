import type { SystemFolder } from '../folder.ts';
import { casterRotationCases } from './cases.ts';
import { casterRotationView } from './view.ts';

export const casterRotation: SystemFolder = {
  view: casterRotationView,
  cases: casterRotationCases,
  equations: () => import('./equations.generated.ts'),
  jacobians: () => import('./jacobians.generated.ts'),
  typeset: () => import('./typeset.generated.json'),
  drawing: () => import('./drawing.ts'),
};
