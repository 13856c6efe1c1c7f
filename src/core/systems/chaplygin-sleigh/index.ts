import type { SystemFolder } from '../folder.ts';
import { chaplyginSleighCases } from './cases.ts';
import { chaplyginSleighView } from './view.ts';

export const chaplyginSleigh: SystemFolder = {
  view: chaplyginSleighView,
  cases: chaplyginSleighCases,
  equations: () => import('./equations.generated.ts'),
  jacobians: () => import('./jacobians.generated.ts'),
  typeset: () => import('./typeset.generated.json'),
  drawing: () => import('./drawing.ts'),
};
