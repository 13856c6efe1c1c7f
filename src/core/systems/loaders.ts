import type { System } from './types.ts';

/** How each system's dynamics are loaded, one at a time: each is large. One line per system here and in `views.ts`. */
const loaders: Readonly<Record<string, () => Promise<System>>> = {
  ripstik: async () => (await import('./ripstik/system.ts')).ripstik,
  'caster-rotation': async () => (await import('./caster-rotation/system.ts')).casterRotation,
  'cart-pendulum': async () => (await import('./cart-pendulum/system.ts')).cartPendulum,
  'rolling-wheel': async () => (await import('./rolling-wheel/system.ts')).rollingWheel,
  'stiff-decay': async () => (await import('./stiff-decay/system.ts')).stiffDecay,
  'wheel-pendulum': async () => (await import('./wheel-pendulum/system.ts')).wheelPendulum,
  'casterboard-robot': async () => (await import('./casterboard-robot/system.ts')).casterboardRobot,
  'chaplygin-sleigh': async () => (await import('./chaplygin-sleigh/system.ts')).chaplyginSleigh,
  bicycle: async () => (await import('./bicycle/system.ts')).bicycle,
};

export const systemIds: readonly string[] = Object.keys(loaders);

/** A system with its dynamics, or undefined where there is none of that name. */
export function loadSystem(id: string): Promise<System> | undefined {
  return Object.hasOwn(loaders, id) ? loaders[id]!() : undefined;
}
