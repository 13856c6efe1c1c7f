import type { SystemFolder } from '../folder.ts';
import { ripstikCases } from './cases.ts';
import { shapedBy } from './drawing/layout.ts';
import { ripstikView } from './view.ts';

export const ripstik: SystemFolder = {
  view: ripstikView,
  cases: ripstikCases,
  equations: () => import('./equations.generated.ts'),
  jacobians: () => import('./jacobians.generated.ts'),
  tape: () => import('./accelerations.generated.json'),
  typeset: () => import('./typeset.generated.json'),
  drawing: () => import('./drawing.ts'),
  shapedBy,
};
