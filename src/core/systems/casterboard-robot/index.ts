import type { SystemFolder } from '../folder.ts';
import { casterboardRobotCases } from './cases.ts';
import { casterboardRobotView } from './view.ts';

export const casterboardRobot: SystemFolder = {
  view: casterboardRobotView,
  cases: casterboardRobotCases,
  equations: () => import('./equations.generated.ts'),
  typeset: () => import('./typeset.generated.json'),
  drawing: () => import('./drawing.ts'),
};
