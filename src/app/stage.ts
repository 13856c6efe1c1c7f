import { computed, signal, type ReadonlySignal } from '@preact/signals';
import { MotionSampler } from '../core/trajectory/motionSampler.ts';
import type { App } from './types.ts';

/** What is on the stage at the playback time: the sampler of the motion being watched, and words for it. */
export interface Stage {
  sampler: ReadonlySignal<MotionSampler | null>;
  /** A text alternative for the scene, renewed at most once a second. */
  description: ReadonlySignal<string>;
}

const DEGREE = Math.PI / 180;

export function stageOf(app: App): Stage {
  const { state } = app;
  // A motion keeps its sampler when only its marks change.
  let last: { id: number; sampler: MotionSampler } | null = null;
  const sampler = computed(() => {
    const motion = state.motion.value;
    if (!motion) return null;
    if (last?.id !== motion.id) {
      last = { id: motion.id, sampler: new MotionSampler(motion.system, motion.parameters, motion.trajectory, motion.constraints) };
    }
    return last.sampler;
  });
  const description = signal('The scene is empty.');
  const describe = (): void => {
    const motion = state.motion.peek();
    const now = sampler.peek();
    if (!motion || !now || motion.trajectory.length === 0) return;
    const t = state.time.peek();
    const at = (name: string): number => now.interpolated(name, t) ?? 0;
    const lean = at('alpha') / DEGREE;
    const heading = at('theta') / DEGREE;
    const text = motion.trajectory.has('alpha_fp')
      ? `Board at ${t.toFixed(1)} s: position ${at('X').toFixed(2)}, ${at('Y').toFixed(2)} m, heading ${heading.toFixed(0)}°, ` +
        `front plate roll ${(lean + at('alpha_fp') / DEGREE).toFixed(0)}°, back plate roll ${(lean + at('alpha_bp') / DEGREE).toFixed(0)}°.`
      : `${motion.title} at ${t.toFixed(1)} s.`;
    if (text !== description.peek()) description.value = text;
  };
  setInterval(describe, 1000);
  return { sampler, description };
}
