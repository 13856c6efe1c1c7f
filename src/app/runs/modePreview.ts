/** Eigenvectors on the stage: a mode as a motion that loops, and the way back to what was there. */
import { effect, untracked } from '@preact/signals';
import { modeTrajectory, modeDuration, type ShownMode } from '../../core/control/linearization/modeTrajectory.ts';
import { checkScenario } from '../../core/scenario/schema.ts';
import type { ScenarioFile } from '../../core/scenario/types.ts';
import type { SystemMeta, SystemView } from '../../core/model/system.ts';
import type { Runs } from './runs.ts';
import type { AppState, Motion, RunState, RunStatistics } from '../types.ts';

/** What of the person's mode was asked for, and what stood on the stage before. */
export interface Aside {
  mode: ModeRequest;
  growth: boolean;
  motion: Motion | null;
  run: RunState | null;
  statistics: RunStatistics | null;
  time: number;
  speed: number;
  loop: boolean;
}

export interface ModeRequest {
  /** The experiment whose linearization it is. */
  scenario: ScenarioFile;
  title: string;
  mode: Omit<ShownMode, 'coordinates'>;
}

/** A mode is played in about this time, s. */
const WATCHED = 5;

/** The speed of a list at which a motion takes about as long as one watches. */
export function speedFor(duration: number, speeds: readonly number[]): number {
  const away = (speed: number): number => Math.abs(Math.log(duration / speed / WATCHED));
  return speeds.reduce((best, speed) => (away(speed) < away(best) ? speed : best), speeds[0]!);
}

export class ModeStage {
  private readonly state: AppState;
  private readonly runs: Runs;
  private readonly views: Readonly<Record<string, SystemView>>;
  private readonly metas: Readonly<Record<string, SystemMeta>>;

  constructor(
    state: AppState,
    runs: Runs,
    views: Readonly<Record<string, SystemView>>,
    metas: Readonly<Record<string, SystemMeta>>,
  ) {
    this.state = state;
    this.runs = runs;
    this.views = views;
    this.metas = metas;
    effect(() => {
      if (state.motion.value?.source !== 'mode') untracked(() => this.leave());
    });
  }

  /** Shows a mode, or the one shown with or without its growth. @throws ScenarioError when the scenario is wrong */
  show(mode: ModeRequest, growth: boolean, speeds: readonly number[]): void {
    const { state } = this;
    const scenario = checkScenario(mode.scenario, this.metas);
    const system = this.views[scenario.system]!;
    const shown = { ...mode.mode, coordinates: system.meta.coordinates };
    const trajectory = modeTrajectory(shown, growth);
    const run = state.run.peek();
    const before = state.aside.peek() ?? {
      motion: state.motion.peek(),
      statistics: state.statistics.peek(),
      time: state.time.peek(),
      speed: state.speed.peek(),
      loop: state.loop.peek(),
      // A run under way ends here: the stage is another's.
      run:
        run?.kind === 'computing'
          ? { kind: 'ended' as const, reason: 'cancelled', message: '', time: state.motion.peek()?.trajectory.end ?? 0 }
          : run,
    };
    state.aside.value = { ...before, mode, growth };
    this.runs.show({
      source: 'mode',
      title: mode.title,
      system,
      parameters: scenario.parameters,
      trajectory,
      constraints: null,
      scenario: null,
      written: null,
      adjustments: [],
      issues: [],
      marks: [],
      judgement: null,
    });
    state.loop.value = true;
    state.speed.value = speedFor(modeDuration(mode.mode.eigenvalue, growth), speeds);
  }

  /** Back to what was on the stage before. */
  back(): void {
    const aside = this.state.aside.peek();
    if (!aside) return;
    if (aside.motion) this.runs.restore(aside.motion, aside.run, aside.statistics, aside.time);
    else this.runs.run();
  }

  private leave(): void {
    const { state } = this;
    const aside = state.aside.peek();
    if (!aside) return;
    state.aside.value = null;
    state.loop.value = aside.loop;
    state.speed.value = aside.speed;
  }
}
