import { computed, signal, type ReadonlySignal } from '@preact/signals';
import type { SystemMeta } from '../../core/model/system.ts';
import { MotionSampler } from '../../core/motion/motionSampler.ts';
import type { Trajectory } from '../../core/motion/trajectory.ts';
import type { PlaybackState } from '../state/playback.ts';
import { readonly } from '../state/signals.ts';
import type { Motion } from './motion.ts';
import type { StageState } from './stageState.ts';

/** What is on the stage at the playback time: the sampler of the motion being watched, and words for it. */
export interface Stage {
  sampler: ReadonlySignal<MotionSampler | null>;
  /** A text alternative for the scene, renewed at most once a second. */
  description: ReadonlySignal<string>;
  /** The sampler of any motion: the same one as long as its rows are, so that its paths are followed once. */
  samplerOf(motion: Motion): MotionSampler;
}

/** Columns of data that are spoken. */
const MOST_SAID = 4;
const DEGREE = Math.PI / 180;

/** Data has nothing to show but its numbers. */
function dataInWords({ columns = [] }: SystemMeta, title: string, t: number, at: (name: string) => number): string {
  const said = columns
    .slice(0, MOST_SAID)
    .map(({ name, label, unit }) =>
      unit === 'rad'
        ? `${label} ${(at(name) / DEGREE).toFixed(1)}°`
        : `${label} ${at(name).toPrecision(3)} ${unit}`.trim(),
    );
  return `${title} at ${t.toFixed(1)} s, without a scene: ${said.join('; ')}.`;
}

/** What the meta has a screen reader told, else every coordinate by its plain name. */
function inWords({ title, coordinates, spoken }: SystemMeta, t: number, at: (name: string) => number): string {
  const shown = (names: readonly string[]): string => {
    const sum = names.reduce((total, name) => total + at(name), 0);
    const angle = coordinates.find(({ name }) => name === names[0])?.kind === 'angle';
    return (angle ? `${(sum / DEGREE).toFixed(0)}°` : `${sum.toFixed(2)} m`).replace('-', '\u2212');
  };
  const items = spoken ?? coordinates.map(({ name, label }) => ({ label, values: [[name]] }));
  const said = items.map(({ label, values }) => `${label} ${values.map(shown).join(', ')}`);
  return `${title} at ${t.toFixed(1)} s: ${said.join('; ')}.`;
}

export function stageOf({ state }: { state: StageState & Pick<PlaybackState, 'time'> }): Stage {
  // A motion keeps its sampler when only its marks change, and when it leaves the stage and is pinned.
  const samplers = new WeakMap<Trajectory, MotionSampler>();
  const samplerOf = ({ system, parameters, trajectory, constraints }: Motion): MotionSampler => {
    const found = samplers.get(trajectory) ?? new MotionSampler(system, parameters, trajectory, constraints);
    samplers.set(trajectory, found);
    return found;
  };
  const sampler = computed(() => {
    const motion = state.motion.value;
    return motion && samplerOf(motion);
  });
  const description = signal('The scene is empty.');
  const describe = (): void => {
    const motion = state.motion.peek();
    const now = sampler.peek();
    if (!motion || !now || motion.trajectory.length === 0) return;
    const t = state.time.peek();
    const at = (name: string): number => now.interpolated(name, t) ?? 0;
    const { meta } = motion.system;
    const text = meta.bodies.length > 0 ? inWords(meta, t, at) : dataInWords(meta, motion.title, t, at);
    if (text !== description.peek()) description.value = text;
  };
  setInterval(describe, 1000);
  return { sampler, description: readonly(description), samplerOf };
}
