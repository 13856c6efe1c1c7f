/** The push by keys: a force that is chosen in steps and goes along with its body until it is released. */
import { batch, effect, signal, type ReadonlySignal } from '@preact/signals';
import type { Push } from '../../core/simulation/push.ts';
import { readonly } from '../state/signals.ts';
import { bodyVelocity, canPush, firmness, posesNear } from './pointerPush.ts';
import type { Motion } from '../runs/motion.ts';
import type { StageState } from '../runs/stageState.ts';
import type { PlaybackState } from '../state/playback.ts';
import type { PushActions, PushState } from './pushState.ts';

/** N: ahead, to the left and up, as the body heads. */
export type Force = readonly [ahead: number, left: number, up: number];

export interface KeyboardPush {
  /** Id of the body. */
  body: string;
  force: Force;
}

export interface KeyboardPusher {
  /** What is pushed and how, or null. */
  current: ReadonlySignal<KeyboardPush | null>;
  /** One step more along a direction of -1, 0 and 1; begins to push the body if need be, and no other with it. */
  press(body: string, way: Force): void;
  release(): void;
  dispose(): void;
}

/** A step stretches the push's spring by about this much, m. */
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
export function pushOf(
  motion: Motion,
  time: number,
  { body: id, force: [ahead, left, up] }: KeyboardPush,
): Push | null {
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

/** Becomes the state's push while it lasts, as the pointer's does in the scene; gives way to that one. */
export function createKeyboardPusher(
  state: Pick<StageState, 'motion' | 'run'> & Pick<PlaybackState, 'time'> & PushState,
  { setPush }: PushActions,
): KeyboardPusher {
  const current = signal<KeyboardPush | null>(null);
  let own: Push | null = null;
  const release = (): void => {
    const mine = state.push.peek() === own;
    own = null;
    batch(() => {
      current.value = null;
      if (mine) setPush(null);
    });
  };
  const act = (): void => {
    const [now, motion] = [current.peek(), state.motion.peek()];
    if (!now || !motion) return;
    if (own && state.push.peek() !== own) return release();
    const push = canPush(motion) ? pushOf(motion, state.time.peek(), now) : null;
    if (!push) return release();
    own = push;
    setPush(push);
  };
  const stops = [
    state.time.subscribe(act),
    effect(() => {
      // Over, or never begun: there is nothing left to push.
      if (state.run.value?.kind === 'ended' && own) release();
    }),
  ];
  return {
    current: readonly(current),
    press(body, way) {
      const before = current.peek()?.body === body ? current.peek()!.force : ([0, 0, 0] as const);
      const motion = state.motion.peek();
      if (!motion || !canPush(motion)) return;
      const step = stepOf(firmness(motion).stiffness);
      const more = (i: 0 | 1 | 2): number => Number((before[i] + step * way[i]).toPrecision(6));
      current.value = { body, force: [more(0), more(1), more(2)] };
      act();
      if (state.run.peek()?.kind === 'ended') release();
    },
    release,
    dispose() {
      for (const stop of stops) stop();
      if (own) release();
    },
  };
}
