import type { Case } from './case.ts';
import { bicycleCases } from '../systems/bicycle/cases.ts';
import { cartPendulumCases } from '../systems/cart-pendulum/cases.ts';
import { casterRotationCases } from '../systems/caster-rotation/cases.ts';
import { casterboardRobotCases } from '../systems/casterboard-robot/cases.ts';
import { chaplyginSleighCases } from '../systems/chaplygin-sleigh/cases.ts';
import { ripstikCases } from '../systems/ripstik/cases.ts';
import { rollingWheelCases } from '../systems/rolling-wheel/cases.ts';
import { stiffDecayCases } from '../systems/stiff-decay/cases.ts';
import { wheelPendulumCases } from '../systems/wheel-pendulum/cases.ts';

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
