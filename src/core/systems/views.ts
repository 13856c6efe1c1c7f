import type { SystemView } from './types.ts';
import { bicycleView } from './bicycle/view.ts';
import { cartPendulumView } from './cart-pendulum/view.ts';
import { casterRotationView } from './caster-rotation/view.ts';
import { casterboardRobotView } from './casterboard-robot/view.ts';
import { chaplyginSleighView } from './chaplygin-sleigh/view.ts';
import { ripstikView } from './ripstik/view.ts';
import { rollingWheelView } from './rolling-wheel/view.ts';
import { stiffDecayView } from './stiff-decay/view.ts';
import { wheelPendulumView } from './wheel-pendulum/view.ts';

/** Every system as the views know it; one line per system here and in `loaders.ts`. */
export const systemViews: Readonly<Record<string, SystemView>> = {
  ripstik: ripstikView,
  'caster-rotation': casterRotationView,
  'cart-pendulum': cartPendulumView,
  'rolling-wheel': rollingWheelView,
  'stiff-decay': stiffDecayView,
  'wheel-pendulum': wheelPendulumView,
  'casterboard-robot': casterboardRobotView,
  'chaplygin-sleigh': chaplyginSleighView,
  bicycle: bicycleView,
};
