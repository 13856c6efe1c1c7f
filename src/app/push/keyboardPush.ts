/** The hand by keys: a force that is chosen in steps and goes along with its body until it is let go. */
import { batch, effect, signal, type ReadonlySignal } from '@preact/signals';
import type { Push } from '../../core/simulation/push.ts';
import { bodyVelocity, canPush, firmness, posesNear } from './pointerPush.ts';
import type { AppState, Motion } from '../types.ts';

/** N: ahead, to the left and up, as the body heads. */
export type Force = readonly [ahead: number, left: number, up: number];

export interface Hold {
  /** Id of the body. */
  body: string;
  force: Force;
}

export interface KeyHand {
  /** What is held, or null. */
  hold: ReadonlySignal<Hold | null>;
  /** One step more along a direction of -1, 0 and 1; takes hold of the body if need be, and of no other with it. */
  press(body: string, way: Force): void;
  letGo(): void;
  dispose(): void;
}

/** A step stretches the hand's spring by about this much, m. */
const STRETCH = 0.02;

/** One step (N) of a spring (N/m): the number of 1, 2 or 5 times a power of ten that is nearest to a stretch of 2 cm. */
export function stepOf(stiffness: number): number {
  const wanted = STRETCH * stiffness;
  const ten = 10 ** Math.floor(Math.log10(wanted));
  const away = (n: number): number => Math.abs(Math.log((n * ten) / wanted));
  return Number(([1, 2, 5, 10].reduce((best, n) => (away(n) < away(best) ? n : best)) * ten).toPrecision(1));
}

/**
 * The push that pulls at a body's origin with a force, going along with it from a time on (s): its spring is stretched
 * by force over stiffness, and its damper is at rest as long as the body goes on as it does.
 */
export function pushOf(motion: Motion, time: number, { body: id, force: [ahead, left, up] }: Hold): Push | null {
  const body = motion.system.meta.bodies.findIndex((one) => one.id === id);
  const { trajectory } = motion;
  if (body < 0 || trajectory.length === 0) return null;
  const row = trajectory.locate(time);
  const since = trajectory.column('t')![row]!;
  const pose = posesNear(motion, row).subarray(12 * body, 12 * body + 12);
  const [cos, sin] = headingOf(pose);
  const spring = firmness(motion);
  const stretched = (x: number, along: number): number => x + along / spring.stiffness;
  const target = [
    stretched(pose[0]!, cos * ahead - sin * left),
    stretched(pose[1]!, sin * ahead + cos * left),
    stretched(pose[2]!, up),
  ] as const;
  return {
    body: id,
    point: [0, 0, 0],
    target,
    moving: { velocity: bodyVelocity(motion, since, body), since },
    ...spring,
  };
}

/** Cosine and sine of the heading of what rolls across its axle (y); the world's x where the axle stands upright. */
function headingOf(pose: Float64Array): readonly [number, number] {
  const [x, y] = [pose[4]!, pose[7]!];
  const level = Math.hypot(x, y);
  return level > 1e-6 ? [y / level, -x / level] : [1, 0];
}

/** Becomes the state's grab while something is held, as the hand in the scene does; gives way to that one. */
export function createKeyHand(state: AppState): KeyHand {
  const hold = signal<Hold | null>(null);
  let own: Push | null = null;
  const letGo = (): void => {
    const mine = state.grab.peek() === own;
    own = null;
    batch(() => {
      hold.value = null;
      if (mine) state.grab.value = null;
    });
  };
  const pull = (): void => {
    const [now, motion] = [hold.peek(), state.motion.peek()];
    if (!now || !motion) return;
    if (own && state.grab.peek() !== own) return letGo();
    const push = canPush(motion) ? pushOf(motion, state.time.peek(), now) : null;
    if (!push) return letGo();
    own = push;
    state.grab.value = push;
  };
  const stops = [
    state.time.subscribe(pull),
    effect(() => {
      // Over, or never begun: there is nothing left to pull at.
      if (state.run.value?.kind === 'ended' && own) letGo();
    }),
  ];
  return {
    hold,
    press(body, way) {
      const before = hold.peek()?.body === body ? hold.peek()!.force : ([0, 0, 0] as const);
      const motion = state.motion.peek();
      if (!motion || !canPush(motion)) return;
      const step = stepOf(firmness(motion).stiffness);
      const more = (i: 0 | 1 | 2): number => Number((before[i] + step * way[i]).toPrecision(6));
      hold.value = { body, force: [more(0), more(1), more(2)] };
      pull();
      if (state.run.peek()?.kind === 'ended') letGo();
    },
    letGo,
    dispose() {
      for (const stop of stops) stop();
      if (own) letGo();
    },
  };
}
