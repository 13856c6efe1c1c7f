/** The run on the stage follows the draft as it is changed: at once where a run is cheap, else it is marked as stale. */
import { computed, effect, signal, type ReadonlySignal } from '@preact/signals';
import type { ScenarioFile } from '../../core/scenario/types.ts';
import { sameContent } from '../state/draft.ts';
import type { DraftEdit, ExperimentState } from '../state/experiment.ts';
import type { PlaybackSlice } from '../state/playback.ts';
import type { SettingsState } from '../state/settings.ts';
import { readonly } from '../state/signals.ts';
import type { Motion } from './motion.ts';
import type { Runs } from './runs.ts';
import type { StageState } from './stageState.ts';

/** Why the run on the stage is not one of the draft: following is switched off, takes too long, or would lose pushes. */
export type Stale = 'off' | 'costly' | 'pushed' | 'refused';

export interface LiveState {
  /** The draft that the stage shows a run of, or is about to; null where it shows something else. */
  asked: ReadonlySignal<ScenarioFile | null>;
  /** Null where the stage shows a run of the draft, or no run. */
  stale: ReadonlySignal<Stale | null>;
  /** The run before what is being changed, seen beside it as a ghost. */
  former: ReadonlySignal<Motion | null>;
}

/** A run of no more evaluations than this (a second or two) follows every change. */
const MOST_FOLLOWED = 300_000;
/** So long after the last change of the start the motion goes on from where it was, ms. */
const REST_MS = 900;
/** So long the run before stays beside the new one, ms. */
const GHOST_MS = 3000;

export interface LiveContext {
  stage: StageState;
  playback: PlaybackSlice;
  settings: Pick<SettingsState, 'live'>;
  experiment: ExperimentState;
  runs: Runs;
  /** A motion that was over plays again once a change rests. */
  replays: boolean;
}

export class LiveRuns {
  private readonly context: LiveContext;
  private readonly before = signal<Motion | null>(null);
  private readonly costly = signal(false);
  readonly state: LiveState;
  /** How the motion was played before the stage went to its start. */
  private left: { time: number; playing: boolean; over: boolean } | null = null;
  private resting: ReturnType<typeof setTimeout> | undefined;
  private fading: ReturnType<typeof setTimeout> | undefined;

  constructor(context: LiveContext) {
    this.context = context;
    const { stage, experiment, settings, runs } = context;
    this.state = {
      asked: runs.asked,
      former: readonly(this.before),
      stale: computed(() => {
        const motion = stage.motion.value;
        const asked = runs.asked.value;
        if (motion?.source !== 'run' || asked === null || sameContent(asked, experiment.draft.value)) return null;
        if (experiment.draftErrors.value.size > 0) return 'refused';
        if (!settings.live.value) return 'off';
        return (motion.pushes ?? []).length > 0 ? 'pushed' : this.costly.value ? 'costly' : 'refused';
      }),
    };
    // Another motion than a run takes what is under way.
    effect(() => {
      if (stage.motion.value?.source !== 'run') this.drop();
    });
  }

  /** Takes up a change of the draft. */
  follow({ before, after }: DraftEdit): void {
    const { stage, settings, experiment, runs } = this.context;
    const { draft } = after;
    const motion = stage.motion.peek();
    if (motion?.source !== 'run' || motion.system.meta.id !== draft.system) return;
    if (!settings.live.peek() || experiment.draftErrors.peek().size > 0) return;
    if (onlyControl(before.draft, draft)) return runs.retune();
    this.costly.value = runs.costOf(draft) > MOST_FOLLOWED;
    if (this.costly.peek() || (motion.pushes ?? []).length > 0) return;
    this.remember(motion);
    if (before.draft.initial !== draft.initial) this.showStart();
    runs.live();
  }

  /** The run as it was when the person began to change something. */
  private remember(motion: Motion): void {
    this.before.value ??= motion;
    clearTimeout(this.fading);
    this.fading = setTimeout(() => (this.before.value = null), GHOST_MS);
  }

  /** While the start is changed, the stage shows it. */
  private showStart(): void {
    const { stage, playback } = this.context;
    const { time, playing } = playback.state;
    const rows = stage.motion.peek()!.trajectory;
    this.left ??= {
      time: time.peek(),
      playing: playing.peek(),
      over: !playing.peek() && rows.length > 1 && time.peek() >= rows.end && stage.run.peek()?.kind === 'ended',
    };
    playback.actions.pause();
    playback.actions.jump(rows.start);
    clearTimeout(this.resting);
    this.resting = setTimeout(() => this.goOn(), REST_MS);
  }

  /** The person plays, pauses or goes somewhere: there the motion stays. */
  stay(): void {
    clearTimeout(this.resting);
    this.left = null;
  }

  private goOn(): void {
    const { stage, playback, replays } = this.context;
    const { left } = this;
    this.left = null;
    if (!left) return;
    const start = stage.motion.peek()?.trajectory.start ?? 0;
    playback.actions.seek(left.over ? start : left.time);
    playback.actions.setPlaying(left.playing || (left.over && replays));
  }

  private drop(): void {
    this.stay();
    clearTimeout(this.fading);
    this.before.value = null;
  }
}

/** What acts on the same plant: the motion goes on with it. */
function onlyControl(a: ScenarioFile, b: ScenarioFile): boolean {
  const keys = new Set([...Object.keys(a), ...Object.keys(b)] as (keyof ScenarioFile)[]);
  return a.control !== b.control && [...keys].every((key) => key === 'control' || a[key] === b[key]);
}
