import { batch } from '@preact/signals';
import { checkScenario } from '../../core/scenario/schema.ts';
import { ScenarioError, type Scenario, type ScenarioFile } from '../../core/scenario/types.ts';
import type { Continuation, RunCounts } from '../../core/simulation/simulation.ts';
import type { SystemMeta } from '../../core/model/system.ts';
import { systemViews } from '../../core/systems/registry.ts';
import { Trajectory } from '../../core/motion/trajectory.ts';
import type { Push } from '../../core/simulation/push.ts';
import { followGrab, horizonOf, PUSHED, pushesUpTo, withMark } from '../push/pushRecorder.ts';
import type { Messages } from '../state/messages.ts';
import type { RunClient } from '../../compute/client/runClient.ts';
import type { AppState, Motion, RunState, RunStatistics } from '../types.ts';

/** A mark where the controller was changed under way; one that follows sooner than this (s) takes the place of the last. */
const RETUNED = 'retuned';
const MARKS_APART = 0.25;
/** A run that is grabbed goes on for at least this long, s. */
const LEFT_S = 5;

/** Starts runs and turns what the worker sends into the motion being watched. */
export class Runs {
  private nextMotion = 1;
  private readonly state: AppState;
  private readonly client: RunClient;
  private readonly messages: Messages;
  private readonly metas: Readonly<Record<string, SystemMeta>>;
  private readonly settle: () => void;
  /** A run that goes on from another has not sent its first rows yet; and the draft changed since. */
  private going = false;
  private stale = false;

  /** @param settle called when another motion took the stage */
  constructor(
    state: AppState,
    client: RunClient,
    messages: Messages,
    metas: Readonly<Record<string, SystemMeta>>,
    settle: () => void,
  ) {
    this.state = state;
    this.client = client;
    this.messages = messages;
    this.metas = metas;
    this.settle = settle;
    followGrab(state, { takeOver: (push) => this.takeOver(push), act: (live) => client.act(live) });
  }

  /** Puts another motion (a file) in place; a run still computing is abandoned. */
  show(motion: Omit<Motion, 'id'>): void {
    this.client.abandon();
    this.going = this.stale = false;
    const { state } = this;
    batch(() => {
      state.run.value = null;
      state.statistics.value = null;
      state.time.value = motion.trajectory.start;
      state.motion.value = { ...motion, id: this.nextMotion++ };
      this.settle();
      state.rowsVersion.value++;
      state.playing.value = true;
    });
  }

  /** Puts a motion back that was on the stage before, paused where it was. */
  restore(motion: Motion, run: RunState | null, statistics: RunStatistics | null, time: number): void {
    this.client.abandon();
    const { state } = this;
    batch(() => {
      state.playing.value = false;
      state.run.value = run;
      state.statistics.value = statistics;
      state.motion.value = motion;
      state.time.value = time;
      state.rowsVersion.value++;
    });
    this.settle();
  }

  /** Runs the draft, playing it as it comes unless told not to; a refusal leaves everything as it was. */
  run(autoplay = true): void {
    const draft = this.state.draft.peek();
    const scenario = this.checked(draft);
    if (!scenario) return;
    this.going = this.stale = false;
    this.start(scenario, draft, null, autoplay);
  }

  /**
   * The motion on the stage goes on from where it is played, with the draft's controller and inputs. What is not a run
   * of the same plant, or has nothing left to come, is run from its start.
   */
  retune(): void {
    const { state } = this;
    const draft = state.draft.peek();
    const scenario = this.checked(draft);
    if (!scenario) return;
    const before = state.motion.peek();
    if (!before?.scenario || before.source !== 'run' || !samePlant(before.scenario, scenario)) return this.run();
    if (this.going) {
      this.stale = true;
      return;
    }
    const row = before.trajectory.locate(state.time.peek());
    const time = before.trajectory.column('t')![row]!;
    if (
      row === 0 ||
      time >= scenario.duration - scenario.outputStep ||
      (state.run.peek()?.kind === 'ended' && row >= before.trajectory.length - 2)
    )
      return this.run();
    this.going = true;
    this.start(scenario, draft, { before, row, time, mark: RETUNED }, state.playing.peek());
  }

  /** The run on the stage goes on from where it is played with a hand on it, and plays. */
  private takeOver(push: Push): boolean {
    const { state } = this;
    const before = state.motion.peek();
    if (!before?.scenario || before.source !== 'run' || before.system.meta.order === 1 || before.trajectory.length < 2)
      return false;
    const { trajectory } = before;
    const run = state.run.peek();
    const row = state.time.peek() >= trajectory.end ? trajectory.length - 1 : trajectory.locate(state.time.peek());
    const time = trajectory.column('t')![row]!;
    if (run?.kind === 'ended' && !['end', 'cancelled'].includes(run.reason) && row >= trajectory.length - 2) {
      this.messages.add('info', 'This run is over', ['Go back to an earlier moment, then drag.']);
      return false;
    }
    const scenario = { ...before.scenario, duration: Math.max(before.scenario.duration, time + LEFT_S) };
    this.going = this.stale = false;
    this.start(scenario, before.written ?? state.draft.peek(), { before, row, time, mark: PUSHED, push }, true);
    state.playing.value = true;
    return true;
  }

  private checked(draft: ScenarioFile): Scenario | null {
    try {
      return checkScenario(draft, this.metas);
    } catch (error) {
      if (!(error instanceof ScenarioError)) throw error;
      this.messages.add('error', 'The scenario cannot run', [error.message]);
      return null;
    }
  }

  private start(scenario: Scenario, draft: ScenarioFile, onward: Onward | null, autoplay: boolean): void {
    const { state, messages } = this;
    const origin = state.origin.peek();
    const push = onward?.push ?? this.state.grab.peek();
    const title = onward?.push
      ? onward.before.title
      : origin.scenario === draft
        ? origin.title
        : `${origin.title}, changed`;
    const pushes = onward ? pushesUpTo(onward.before, onward.time) : [];
    let motion: Motion | null = null;
    const run = state.run.peek();
    // From now on what the page says of a run is said of this one.
    state.run.value = { kind: 'computing', progress: 0 };
    this.client.start(
      scenario,
      {
        started: (columns, adjustments, notes) => {
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
            adjustments: onward?.before.adjustments ?? adjustments,
            issues: [],
            marks: onward ? marksOf(onward) : [],
            pushes,
            judgement: null,
          };
          if (notes.length > 0) messages.add('info', 'About the start', notes);
        },
        rows: (columns, rows, time, counts) => {
          motion!.trajectory.append(columns, rows);
          batch(() => {
            this.adopt(motion!, autoplay, onward !== null);
            state.rowsVersion.value++;
            this.count(counts);
            if (state.run.peek()?.kind === 'computing')
              state.run.value = { kind: 'computing', progress: time / scenario.duration };
          });
          this.wentOn();
        },
        pushed: (record) => {
          const marks = withMark(motion!.marks, pushes, record);
          pushes.push(record);
          if (marks === motion!.marks) return;
          const marked: Motion = { ...motion!, marks };
          if (state.motion.peek() === motion) state.motion.value = marked;
          motion = marked;
        },
        ended: (end, counts) => {
          this.count(counts);
          state.run.value = { kind: 'ended', reason: end.reason, message: end.message, time: end.time };
          if (end.reason !== 'end' && end.reason !== 'cancelled') {
            state.motion.value = { ...motion!, marks: [...motion!.marks, { time: end.time, name: end.reason }] };
          }
        },
        refused: (path, message) => {
          messages.add('error', 'The run could not go on', [
            path && !message.startsWith(path) ? `${path}: ${message}` : message,
          ]);
          if (state.motion.peek() === motion && motion)
            state.run.value = { kind: 'ended', reason: 'failed', message, time: motion.trajectory.end };
          else state.run.value = run?.kind === 'ended' ? run : null;
          this.wentOn();
        },
      },
      onward ? continuationOf(onward, scenario) : undefined,
      push ? { push, horizon: horizonOf(state) } : undefined,
    );
  }

  /** The first answer of a run that goes on is there; what changed meanwhile is taken up now. */
  private wentOn(): void {
    this.going = false;
    if (!this.stale) return;
    this.stale = false;
    this.retune();
  }

  /** The new motion takes the stage with its first rows, never empty: there is no stale or blank frame between. */
  private adopt(motion: Motion, autoplay: boolean, goesOn: boolean): void {
    const { state } = this;
    if (state.motion.peek()?.id === motion.id) return;
    if (!goesOn) state.time.value = 0;
    state.motion.value = motion;
    this.settle();
    if (!goesOn) state.playing.value = autoplay;
  }

  private count(counts: RunCounts): void {
    this.state.statistics.value = counts;
  }
}

/** The row of a motion from which another run goes on. */
interface Onward {
  before: Motion;
  row: number;
  time: number;
  /** Name of what happens there. */
  mark: string;
  push?: Push;
}

/** The same equations of motion, rows and times: only what acts on them may differ. */
function samePlant(a: Scenario, b: Scenario): boolean {
  const plant = ({ system, parameters, constraints, hold, outputStep }: Scenario): string =>
    JSON.stringify([system, parameters, constraints, hold, outputStep]);
  return plant(a) === plant(b);
}

function continuationOf({ before: { system, trajectory }, row, time }: Onward, scenario: Scenario): Continuation {
  const names = system.meta.coordinates.map((c) => c.name);
  const at = (name: string): number => trajectory.column(name)![row]!;
  return {
    time: Math.round(time / scenario.outputStep) * scenario.outputStep,
    q: names.map(at),
    v: names.map((name) => at(`${name}_dot`)),
  };
}

/** Rows to be expected of a run: room is made for them at once, for copying a long run into larger columns would stop the page. */
const rowsOf = ({ duration, outputStep }: Scenario): number => Math.ceil(duration / outputStep) + 2;

/** The rows up to and with the one to go on from, in the new run's columns; what the old run did not have is not a number. */
function firstRows({ before: { trajectory }, row }: Onward, columns: readonly string[], expected: number): Trajectory {
  const rows = row + 1;
  const kept = new Trajectory(columns, Math.max(2 * rows, expected));
  kept.recorded = trajectory.recorded;
  kept.append(
    columns.map((name) => trajectory.column(name)?.subarray(0, rows) ?? new Float64Array(rows).fill(NaN)),
    rows,
  );
  return kept;
}

/** The marks before, one where the controller was changed; a push marks itself when it acts. */
function marksOf({ before, time, mark }: Onward): Motion['marks'] {
  const earlier = before.marks.filter((m) => m.time <= time && !(m.name === mark && time - m.time < MARKS_APART));
  return mark === PUSHED ? earlier : [...earlier, { time, name: mark }];
}
