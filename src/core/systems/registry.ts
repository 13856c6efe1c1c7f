import type { System } from './types.ts';
import { cartPendulum } from './cart-pendulum/system.ts';
import { casterRotation } from './caster-rotation/system.ts';
import { casterboardRobot } from './casterboard-robot/system.ts';
import { ripstik } from './ripstik/system.ts';
import { rollingWheel } from './rolling-wheel/system.ts';
import { stiffDecay } from './stiff-decay/system.ts';
import { wheelPendulum } from './wheel-pendulum/system.ts';

/** Every system with its dynamics: for the worker, the command line and tests, not for the page. */
export const systems: Readonly<Record<string, System>> = {
  ripstik,
  'caster-rotation': casterRotation,
  'cart-pendulum': cartPendulum,
  'rolling-wheel': rollingWheel,
  'stiff-decay': stiffDecay,
  'wheel-pendulum': wheelPendulum,
  'casterboard-robot': casterboardRobot,
};
