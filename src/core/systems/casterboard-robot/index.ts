import type { SystemFolder } from '../folder.ts';
import { casterboardRobotCases } from './cases.ts';
import { casterboardRobotView } from './view.ts';

export const casterboardRobot: SystemFolder = {
  view: casterboardRobotView,
  cases: casterboardRobotCases,
  equations: () => import('./equations.generated.ts'),
  jacobians: () => import('./jacobians.generated.ts'),
  typeset: () => import('./typeset.generated.json'),
  drawing: () => import('./drawing.ts'),
};
