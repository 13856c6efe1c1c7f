import { batch, signal, type ReadonlySignal } from '@preact/signals';
import type { RunClient } from '../../compute/client/runClient.ts';
import { Trajectory } from '../../core/motion/trajectory.ts';
import { checkScenario } from '../../core/scenario/schema.ts';
import { DEFAULTS } from '../../core/scenario/defaults.ts';
import {
  ScenarioError,
  type RideCommand,
  type RideControl,
  type Scenario,
  type ScenarioFile,
} from '../../core/scenario/types.ts';
import type { Push } from '../../core/simulation/push.ts';
import type { RideStart } from '../../compute/services/rideTypes.ts';
import type { SystemMeta } from '../../core/model/system.ts';
import { systemViews } from '../../core/systems/registry.ts';
import { followPush, horizonOf, PUSHED, pushesUpTo, withMark } from '../push/pushRecorder.ts';
import type { PushState } from '../push/pushState.ts';
import type { ExperimentState } from '../state/experiment.ts';
import type { MessageActions } from '../state/messages.ts';
import type { PlaybackSlice } from '../state/playback.ts';
import type { SettingsState } from '../state/settings.ts';
import { readonly } from '../state/signals.ts';
import type { Motion } from './motion.ts';
import { continuationOf, firstRows, marksOf, RETUNED, rowsOf, samePlant, type Onward } from './onward.ts';
import type { StageContent, StageSlice } from './stageState.ts';

/** A run that is pushed goes on for at least this long, s. */
const LEFT_S = 5;
/** A motion that plays goes on for so long while the run that follows it is computed, s of the clock. */
const AHEAD_S = 0.06;

export interface RunsContext {
  stage: StageSlice;
  experiment: ExperimentState;
  playback: PlaybackSlice;
  settings: Pick<SettingsState, 'speed'>;
  pushing: PushState;
  client: RunClient;
  messages: MessageActions;
  metas: Readonly<Record<string, SystemMeta>>;
  /** Called when another motion took the stage. */
  settle(): void;
}

/** How a run comes to the stage. */
interface Entry {
  /** From another run; without it from the scenario's start. */
  onward?: Onward;
  /** In the place of the run before it, at its time. */
  live?: boolean;
  autoplay?: boolean;
  soonest?: boolean;
  /** In step with the clock, told where to go. */
  ride?: Ride;
}

/** A ride as it is begun, and what is heard of it. */
export interface Ride extends RideStart {
  title: string;
  told(command: RideCommand, given: number): void;
  /** With the scenario that repeats it. */
  over(end: { reason: string; message: string; time: number }, file: ScenarioFile): void;
}

/** Share of a run after which its pace is known. */
const PACED = 0.05;
/** How often what is read of a ride is brought up to date, ms. */
const READ_MS = 200;

/** Starts runs and turns what the worker sends into the motion being watched. */
export class Runs {
  private nextMotion = 1;
  private readonly context: RunsContext;
  private readonly request = signal<ScenarioFile | null>(null);
  /** The draft that was last run; null while the stage shows something else. */
  readonly asked: ReadonlySignal<ScenarioFile | null> = readonly(this.request);
  /** A run that follows the draft is not on the stage yet; and what is to follow then. */
  private going = false;
  private next: (() => void) | null = null;
  /** The run under way, or the last one, was begun by a change of the draft. */
  private followed = false;
  /** Evaluations for a second of motion, of the last run. */
  private pace = 0;

  constructor(context: RunsContext) {
    this.context = context;
    const { stage, playback, settings, pushing, client } = context;
    followPush(
      { ...stage.state, ...playback.state, ...settings, ...pushing },
      { takeOver: (now) => this.takeOver(now), act: (live) => client.act(live) },
    );
  }

  /** Puts another motion (a file) in place; a run still computing is abandoned. */
  show(motion: Omit<Motion, 'id'>): void {
    const { stage, playback, client, settle } = this.context;
    client.abandon();
    this.settleFor(false);
    this.request.value = null;
    batch(() => {
      playback.actions.jump(motion.trajectory.start);
      stage.actions.put({ motion: { ...motion, id: this.nextMotion++ }, run: null, statistics: null });
      settle();
      playback.actions.setPlaying(true);
    });
  }

  /** Puts back what was on the stage before, paused where it was (s). */
  restore(content: StageContent, time: number): void {
    const { stage, playback, client, settle } = this.context;
    client.abandon();
    this.settleFor(false);
    this.request.value = content.motion?.source === 'run' ? content.motion.written : null;
    batch(() => {
      playback.actions.pause();
      stage.actions.put(content);
      playback.actions.jump(time);
    });
    settle();
  }

  /**
   * Runs the draft, playing it as it comes unless told not to; a refusal leaves everything as it was.
   *
   * @param soonest the first rows matter more than the last, as after the page is opened
   */
  run(autoplay = true, soonest = false): void {
    const draft = this.context.experiment.draft.peek();
    if (this.plays(draft, autoplay)) return;
    const scenario = this.checked(draft);
    if (!scenario) return;
    this.settleFor(false);
    this.start(scenario, draft, { autoplay, soonest });
  }

  /** The draft as it was changed takes the place of its run at the time where that is played, as soon as it comes so far. */
  live(): void {
    const draft = this.context.experiment.draft.peek();
    if (this.going) {
      this.next = () => this.live();
      return;
    }
    const scenario = this.checked(draft);
    if (!scenario) return;
    this.settleFor(true);
    this.followed = true;
    this.start(scenario, draft, { live: true });
  }

  /** Begins a ride of a draft whose control is one; false where it can't be. */
  ride(draft: ScenarioFile, ride: Ride): boolean {
    const scenario = this.checked(draft);
    if (scenario?.control?.type !== 'ride') return false;
    this.settleFor(false);
    this.start(scenario, draft, { ride });
    return true;
  }

  /** Evaluations that a run of a draft may be expected to take: work, not time, so that a busy machine decides nothing. */
  costOf({ duration = DEFAULTS.duration }: ScenarioFile): number {
    return this.pace * duration;
  }

  /** A run that was begun by the last change is what Run asks for: it is played from its start, not computed again. */
  private plays(draft: ScenarioFile, autoplay: boolean): boolean {
    const { stage, playback } = this.context;
    const run = stage.state.run.peek();
    const whole = run?.kind === 'computing' || (run?.kind === 'ended' && !['cancelled', 'failed'].includes(run.reason));
    if (!this.followed || this.next || this.request.peek() !== draft || !whole) return false;
    this.followed = false;
    playback.actions.jump(0);
    playback.actions.setPlaying(autoplay);
    return true;
  }

  /** @param going a run that follows the draft is begun */
  private settleFor(going: boolean): void {
    this.going = going;
    this.next = null;
    this.followed = false;
  }

  /**
   * The motion on the stage goes on from where it is played, with the draft's controller and inputs. What is not a run
   * of the same plant, or has nothing left to come, is computed from its start.
   */
  retune(): void {
    const { stage, experiment, playback } = this.context;
    const draft = experiment.draft.peek();
    const scenario = this.checked(draft);
    if (!scenario) return;
    const before = stage.state.motion.peek();
    if (!before?.scenario || before.source !== 'run') return this.run();
    if (this.going) {
      this.next = () => this.retune();
      return;
    }
    if (!samePlant(before.scenario, scenario)) return this.live();
    const row = before.trajectory.locate(playback.state.time.peek());
    const time = before.trajectory.column('t')![row]!;
    if (
      row === 0 ||
      time >= scenario.duration - scenario.outputStep ||
      (stage.state.run.peek()?.kind === 'ended' && row >= before.trajectory.length - 2)
    )
      return this.live();
    this.settleFor(true);
    this.start(scenario, draft, { onward: { before, row, time, mark: RETUNED } });
  }

  /** The run on the stage goes on from where it is played with a push on it, and plays. */
  private takeOver(push: Push): boolean {
    const { stage, experiment, playback, messages } = this.context;
    const before = stage.state.motion.peek();
    if (!before?.scenario || before.source !== 'run' || before.system.meta.order === 1 || before.trajectory.length < 2)
      return false;
    const { trajectory } = before;
    const run = stage.state.run.peek();
    const now = playback.state.time.peek();
    const row = now >= trajectory.end ? trajectory.length - 1 : trajectory.locate(now);
    const time = trajectory.column('t')![row]!;
    if (run?.kind === 'ended' && !['end', 'cancelled'].includes(run.reason) && row >= trajectory.length - 2) {
      messages.report('info', 'This run is over', ['Go back to an earlier moment, then drag.']);
      return false;
    }
    const scenario = { ...before.scenario, duration: Math.max(before.scenario.duration, time + LEFT_S) };
    this.settleFor(false);
    this.start(scenario, before.written ?? experiment.draft.peek(), {
      onward: { before, row, time, mark: PUSHED, push },
    });
    playback.actions.setPlaying(true);
    return true;
  }

  private checked(draft: ScenarioFile): Scenario | null {
    try {
      return checkScenario(draft, this.context.metas);
    } catch (error) {
      if (!(error instanceof ScenarioError)) throw error;
      this.context.messages.report('error', 'The scenario cannot run', [error.message]);
      return null;
    }
  }

  private start(scenario: Scenario, draft: ScenarioFile, entry: Entry): void {
    const { onward = null, soonest = false, ride } = entry;
    const { stage, experiment, pushing, client, messages } = this.context;
    const origin = experiment.origin.peek();
    const push = ride ? null : (onward?.push ?? pushing.push.peek());
    const title = ride
      ? ride.title
      : onward?.push
        ? onward.before.title
        : origin.scenario === draft
          ? origin.title
          : `${origin.title}, changed`;
    const pushes = onward ? pushesUpTo(onward.before, onward.time) : [];
    let motion: Motion | null = null;
    const run = stage.state.run.peek();
    this.request.value = draft;
    let adopted = false;
    let read = -Infinity;
    const take = (over: boolean): void => {
      adopted ||= this.adopt(motion!, entry, over);
    };
    // From now on what the page says of a run is said of this one.
    stage.actions.setRun({ kind: 'computing', progress: 0 });
    client.start(
      scenario,
      {
        derived: (share) => stage.actions.setRun({ kind: 'computing', progress: 0, derived: share }),
        started: (columns, adjustments, notes, engine) => {
          motion = {
            id: this.nextMotion++,
            source: 'run',
            title,
            system: systemViews[scenario.system]!,
            parameters: scenario.parameters,
            trajectory: onward
              ? firstRows(onward, columns, rowsOf(scenario))
              : new Trajectory(columns, rowsOf(scenario)),
            constraints: scenario.constraints,
            scenario,
            written: draft,
            engine,
            adjustments: onward?.before.adjustments ?? adjustments,
            issues: [],
            marks: onward ? marksOf(onward) : [],
            pushes,
            judgement: null,
          };
          motion.trajectory.straight = motion.system.drawnAlong !== undefined;
          // What is typed on may be told at the next number.
          if (notes.length > 0 && !entry.live) messages.report('info', 'About the start', notes);
        },
        rows: (columns, rows, time, counts) => {
          motion!.trajectory.append(columns, rows);
          // The first rows come after a few short steps, which tell nothing of the rest.
          if (!onward) this.pace = counts.evaluations / Math.max(time, PACED * scenario.duration);
          batch(() => {
            take(false);
            if (adopted) {
              // Nothing between what is computed and what is seen.
              if (ride) this.context.playback.actions.jump(motion!.trajectory.end);
              // What reads all rows, and what is written of them, would hold up the ride's next picture.
              if (ride && performance.now() < read + READ_MS) return;
              read = performance.now();
              stage.actions.grew();
              stage.actions.setStatistics(counts);
            }
            if (stage.state.run.peek()?.kind === 'computing')
              stage.actions.setRun({ kind: 'computing', progress: time / scenario.duration });
          });
          if (adopted) this.wentOn();
        },
        pushed: (record) => {
          const marks = withMark(motion!.marks, pushes, record);
          pushes.push(record);
          if (marks === motion!.marks) return;
          const marked: Motion = { ...motion!, marks };
          if (stage.state.motion.peek() === motion) stage.actions.setMotion(marked);
          motion = marked;
        },
        told: (command, given) => {
          (scenario.control as RideControl & { commands: RideCommand[] }).commands.push(command);
          ride?.told(command, given);
        },
        ended: (end, counts) => {
          batch(() => take(true));
          if (ride && motion) motion = this.ridden(motion, end, ride);
          if (ride && adopted) stage.actions.grew();
          if (adopted) stage.actions.setStatistics(counts);
          else this.request.value = stage.state.motion.peek()?.written ?? null;
          stage.actions.setRun({ kind: 'ended', reason: end.reason, message: end.message, time: end.time });
          if (adopted && end.reason !== 'end' && end.reason !== 'cancelled')
            stage.actions.setMotion({ ...motion!, marks: [...motion!.marks, { time: end.time, name: end.reason }] });
          if (end.reason === 'cancelled') this.next = null;
          this.wentOn();
        },
        refused: (path, message) => {
          messages.report('error', 'The run could not go on', [
            path && !message.startsWith(path) ? `${path}: ${message}` : message,
          ]);
          if (stage.state.motion.peek() === motion && motion)
            stage.actions.setRun({ kind: 'ended', reason: 'failed', message, time: motion.trajectory.end });
          else {
            stage.actions.setRun(run?.kind === 'ended' ? run : null);
            this.request.value = stage.state.motion.peek()?.written ?? null;
          }
          this.wentOn();
        },
      },
      {
        from: onward ? continuationOf(onward, scenario) : undefined,
        live: push ? { push, horizon: this.horizon() } : undefined,
        until: entry.live ? this.soon() : 0,
        soonest,
        ride: ride && { resume: ride.resume, pace: ride.pace },
      },
    );
  }

  /** A ride that is over becomes a run like any: its scenario, with what was told, repeats it to the last bit. */
  private ridden(motion: Motion, end: { reason: string; message: string; time: number }, ride: Ride): Motion {
    const { commands } = motion.scenario!.control as RideControl;
    // A fall ends it by itself, a little before the duration.
    const duration = end.reason === 'cancelled' ? end.time : Math.ceil(end.time * 10 + 1) / 10;
    const written: ScenarioFile = {
      ...motion.written!,
      control: { ...motion.written!.control!, commands: commands.filter(([t]) => t < duration) } as RideControl,
      duration,
    };
    const told = { ...motion, scenario: this.checked(written) ?? motion.scenario, written };
    this.request.value = written;
    if (this.context.stage.state.motion.peek() === motion) this.context.stage.actions.setMotion(told);
    ride.over(end, written);
    return told;
  }

  /** A run that follows the draft is on the stage; what changed meanwhile is taken up now. */
  private wentOn(): void {
    if (!this.going) return;
    const { next } = this;
    this.going = false;
    this.next = null;
    next?.();
  }

  /**
   * The new motion takes the stage, never empty: there is no stale or blank frame between. One that follows the draft
   * waits until it comes as far as the one before is played.
   *
   * @param over no more rows come
   * @returns whether it has the stage
   */
  private adopt(motion: Motion, { autoplay = true, onward, live = false, ride }: Entry, over: boolean): boolean {
    const { stage, playback, settle } = this.context;
    if (stage.state.motion.peek()?.id === motion.id) return true;
    const { end } = motion.trajectory;
    const now = playback.state.time.peek();
    if (motion.trajectory.length === 0 || (live && !over && end < now)) return false;
    if (ride && !over && end < ride.resume - motion.scenario!.outputStep) return false;
    if (live) playback.actions.jump(Math.min(now, end));
    else if (!onward) playback.actions.jump(0);
    stage.actions.setMotion(motion);
    settle();
    if (!live && !onward) playback.actions.setPlaying(autoplay);
    return true;
  }

  /** Where the motion will be played when a run that is begun now has come so far, s. */
  private soon(): number {
    const { playing, time } = this.context.playback.state;
    return time.peek() + (playing.peek() ? AHEAD_S * this.context.settings.speed.peek() : 0);
  }

  private horizon(): number {
    const { stage, playback, settings } = this.context;
    return horizonOf({ ...stage.state, ...playback.state, ...settings });
  }
}
