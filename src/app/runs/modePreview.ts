/** Eigenvectors on the stage: a mode as a motion that loops, and the way back to what was there. */
import { effect, signal, untracked, type ReadonlySignal } from '@preact/signals';
import type { ShownMode } from '../../core/control/linearization/modeTrajectory.ts';
import type { Trajectory } from '../../core/motion/trajectory.ts';
import { checkScenario } from '../../core/scenario/schema.ts';
import type { ScenarioFile } from '../../core/scenario/types.ts';
import type { SystemMeta, SystemView } from '../../core/model/system.ts';
import type { PlaybackState } from '../state/playback.ts';
import { speeds } from '../state/playbackClock.ts';
import type { SettingsSlice } from '../state/settings.ts';
import { readonly } from '../state/signals.ts';
import { UNRECORDED, type RunState } from './motion.ts';
import type { Runs } from './runs.ts';
import type { StageContent, StageState } from './stageState.ts';

export interface ModeRequest {
  /** The experiment whose linearization it is. */
  scenario: ScenarioFile;
  title: string;
  mode: Omit<ShownMode, 'coordinates'>;
  /** Its motion and how long it is shown (s): who asks has the code of it, the first view has not. */
  motionOf(mode: ShownMode, growth: boolean): { trajectory: Trajectory; duration: number };
}

/** What stood on the stage before a mode, and how it was played. */
export interface SuspendedStage extends StageContent {
  time: number;
  speed: number;
  loop: boolean;
}

/** The mode on the stage. */
export interface ModePreview {
  request: ModeRequest;
  /** Growing as it does, or by its shape alone. */
  growth: boolean;
  suspended: SuspendedStage;
}

/** A mode is played in about this time, s. */
const WATCHED = 5;

/** The speed of a list at which a motion takes about as long as one watches. */
export function speedFor(duration: number, choices: readonly number[]): number {
  const away = (speed: number): number => Math.abs(Math.log(duration / speed / WATCHED));
  return choices.reduce((best, speed) => (away(speed) < away(best) ? speed : best), choices[0]!);
}

export interface ModePreviewContext {
  stage: StageState;
  playback: PlaybackState;
  settings: SettingsSlice;
  runs: Runs;
  views: Readonly<Record<string, SystemView>>;
  metas: Readonly<Record<string, SystemMeta>>;
}

export class ModePreviewer {
  private readonly context: ModePreviewContext;
  private readonly preview = signal<ModePreview | null>(null);
  readonly state: { modePreview: ReadonlySignal<ModePreview | null> } = { modePreview: readonly(this.preview) };

  constructor(context: ModePreviewContext) {
    this.context = context;
    effect(() => {
      if (context.stage.motion.value?.source !== 'mode') untracked(() => this.end());
    });
  }

  /** Shows a mode, or the one shown with or without its growth. @throws ScenarioError when the scenario is wrong */
  show(request: ModeRequest, growth: boolean): void {
    const { settings, runs, views, metas } = this.context;
    const scenario = checkScenario(request.scenario, metas);
    const system = views[scenario.system]!;
    const mode = { ...request.mode, coordinates: system.meta.coordinates };
    const { trajectory, duration } = request.motionOf(mode, growth);
    const suspended = this.preview.peek()?.suspended ?? this.present();
    this.preview.value = { request, growth, suspended };
    runs.show({
      source: 'mode',
      title: request.title,
      system,
      parameters: scenario.parameters,
      trajectory,
      ...UNRECORDED,
    });
    settings.actions.setAll({ loop: true, speed: speedFor(duration, speeds) });
  }

  /** Back to what was on the stage before. */
  leave(): void {
    const suspended = this.preview.peek()?.suspended;
    if (!suspended) return;
    if (suspended.motion) this.context.runs.restore(suspended, suspended.time);
    else this.context.runs.run();
  }

  private present(): SuspendedStage {
    const { stage, playback, settings } = this.context;
    const motion = stage.motion.peek();
    return {
      motion,
      run: stopped(stage.run.peek(), motion?.trajectory.end ?? 0),
      statistics: stage.statistics.peek(),
      time: playback.time.peek(),
      speed: settings.state.speed.peek(),
      loop: settings.state.loop.peek(),
    };
  }

  private end(): void {
    const suspended = this.preview.peek()?.suspended;
    if (!suspended) return;
    this.preview.value = null;
    this.context.settings.actions.setAll({ loop: suspended.loop, speed: suspended.speed });
  }
}

/** A run under way ends when the stage is another's. */
function stopped(run: RunState | null, time: number): RunState | null {
  return run?.kind === 'computing' ? { kind: 'ended', reason: 'cancelled', message: '', time } : run;
}
