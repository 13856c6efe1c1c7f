import type { Case } from './case.ts';
import { bicycleCases } from './bicycle.ts';
import { cartPendulumCases } from './cartPendulum.ts';
import { casterRotationCases } from './casterRotation.ts';
import { casterboardRobotCases } from './casterboardRobot.ts';
import { chaplyginSleighCases } from './chaplyginSleigh.ts';
import { ripstikCases } from './ripstik.ts';
import { rollingWheelCases } from './rollingWheel.ts';
import { stiffDecayCases } from './stiffDecay.ts';
import { wheelPendulumCases } from './wheelPendulum.ts';

export type { Case } from './case.ts';

/** Every built-in case; one line per system. The first one is what the page opens with. */
export const cases: readonly Case[] = [
  ...ripstikCases,
  ...casterRotationCases,
  ...cartPendulumCases,
  ...rollingWheelCases,
  ...stiffDecayCases,
  ...wheelPendulumCases,
  ...casterboardRobotCases,
  ...bicycleCases,
  ...chaplyginSleighCases,
];
