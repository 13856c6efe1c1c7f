import type { SystemFolder } from '../folder.ts';
import { shapedBy } from '../ripstik/drawing/layout.ts';
import { ripstikRiderCases } from './cases.ts';
import { ripstikRiderView } from './view.ts';

export const ripstikRider: SystemFolder = {
  view: ripstikRiderView,
  cases: ripstikRiderCases,
  equations: () => import('./equations.generated.ts'),
  jacobians: () => import('./jacobians.generated.ts'),
  tape: () => import('./accelerations.generated.json'),
  typeset: () => import('./typeset.generated.json'),
  drawing: () => import('./drawing.ts'),
  shapedBy: [...shapedBy, 'riderHeight'],
};
