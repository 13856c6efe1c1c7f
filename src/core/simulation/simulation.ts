import { REACH_OF_ONE } from '../scenario/expressions/pace.ts';
import { ConstrainedSystem } from '../mechanics/constrainedSystem.ts';
import { AttitudeCharts } from '../mechanics/attitudeCharts.ts';
import { consistentStart, type StartAdjustment } from '../mechanics/consistentStart.ts';
import { eventsOf, type EventFunction } from '../mechanics/events.ts';
import { actuationOf, type Actuation } from './actuation.ts';
import { EnergyBalance, type EnergyNumbers, type Power } from './energyBalance.ts';
import { planOfTime, sightOf, type InputPlan, type PlanOptions } from './inputPlan.ts';
import { firstCrossing, type Crossing } from './firstCrossing.ts';
import { failureMessage } from './failureMessage.ts';
import type { Saturation } from './saturation.ts';
import type { Feedback, Forcing } from '../mechanics/forcing.ts';
import type { StateMap } from '../mechanics/formulations/contract.ts';
import { Projection } from '../mechanics/projection.ts';
import { zeroCounters, type Counters, type Stepper } from '../integrators/contract.ts';
import { maxAbs } from '../linalg/dense.ts';
import type { EngineId, Scenario } from '../scenario/types.ts';
import type { System } from '../model/system.ts';
import { methods } from '../integrators/methods.ts';
import { DEFAULT_STEP } from '../integrators/shared/fixedStepper.ts';
import { MULTIPLIERS, motionOf } from './motion.ts';
import { turnsAway, turnWarnings } from './turnsAway.ts';
import type { Push, PushRecord } from './push.ts';
import { PushForce, together } from './pushForce.ts';

/** How a run ended. `reason` is a permanent id; `message` is for people. */
export interface RunEnd {
  reason: string;
  message: string;
  time: number;
}

export interface RunCounts extends EnergyNumbers {
  steps: number;
  rejected: number;
  evaluations: number;
  jacobians: number;
  factorizations: number;
  /** Largest constraint residual of an emitted row. */
  residual: number;
}

/** What a run may be given besides its scenario. */
export interface RunOptions {
  /** Extra columns, in place of the scenario's. */
  extras?: readonly string[];
  /** Goes on from there, with the row after it, in place of a consistent start at t = 0. */
  from?: Continuation | undefined;
  /** State feedback by input: what an `lqr` in the scenario asks (see `feedbackOf`). */
  feedback?: ReadonlyMap<string, Feedback> | null;
  /**
   * What pushes by hand act, in the order of their times; those up to the start act from it. An empty list lets `push`
   * be called; without a list it must not be.
   */
  pushes?: readonly PushRecord[] | undefined;
}

/** A row of an earlier run to go on from: `time` is a multiple of the output step, q and v as in that row. */
export interface Continuation {
  time: number;
  q: readonly number[];
  v: readonly number[];
}

/** Rows that a chunk starts with room for; it grows when a long step brings more. */
const CHUNK_ROWS = 512;

/** A time closer than this (s) to one that was to be reached is that time. */
const REACHED = 1e-9;

/** A clock that goes along with t is it to this, beside itself or 1 s. */
const CLOCK_ROUNDING = 8 * Number.EPSILON;

/** A fixed step that passes over less than this part of an input is as good as its method is. */
const SMALL_PART = 1e-3;

/** Of how near a free body's fixed steps may come to pitch 90° (`AttitudeCharts.nearness`) without a word. */
const MOST_NEARNESS = 0.5;

/** Places within a step where a controller is asked whether it has reached its limit, or left it. */
const LIMIT_LOOKS = 4;

/** Limits that are reached and left at one moment: beyond so many turns the limit acts at every moment of one step. */
const MOST_TURNS = 6;

/** An event is glanced at over ways of a coordinate no longer than this, m and rad, in up to so many pieces of a step. */
const LOOKED_AT = { length: 0.1, angle: 0.2 };
const MOST_PIECES = 500;

/** How far an event may be off before a projection, beside how far it is at the end of the step. */
const UNPROJECTED = 8;

/** What `columns` of a scenario may ask for; state columns are always there. */
export const EXTRA_COLUMNS = ['lambda', 'energy', 'residual', 'inputs'] as const;

/** What the page asks for: kinetic and potential energy too, columns `kinetic` and `potential`. */
export const PAGE_COLUMNS = [...EXTRA_COLUMNS, 'energy-parts'] as const;

/**
 * A run of a scenario, row by row: construct, then call `advance` until `end` is set, taking chunks in between.
 * It owns no clock and no thread, so that a worker, the command line and a test drive the same code.
 *
 * @throws ScenarioError, StartError from the constructor
 */
export class Simulation {
  readonly columns: readonly string[];
  adjustments: readonly StartAdjustment[];
  notes: readonly string[];
  /** Why the run is not to be trusted as it is. */
  readonly warnings: readonly string[];
  /** What computes the steps: the scenario's choice, or the fastest there is; TypeScript where WebAssembly does not serve. */
  readonly engine: EngineId;
  readonly dynamics: ConstrainedSystem;
  readonly q: Float64Array;
  readonly v: Float64Array;
  end: RunEnd | null = null;
  /** Not computed beyond it, s: for a run that a hand acts on while it is watched. */
  horizon = Infinity;
  /** Rows waiting in the chunk. */
  rows = 0;

  private scenario: Scenario;
  private readonly system: System;
  private readonly n: number;
  /** As the formulas stand, for rows. */
  private readonly actuation: Actuation;
  /** What the steps know of the inputs beforehand. */
  private readonly plan: InputPlan | null;
  /** A controller's limit to be reached or left, and when: steps end there. */
  private turning: { saturation: Saturation; time: number } | null = null;
  private turns = 0;
  /** Index of the coordinate by which equations take the time, or -1; and what it is ahead of t, s. */
  private readonly clock: number;
  private readonly ahead: number;
  /** State at the start of the step, where controllers have limits. */
  private readonly before: Float64Array;
  private readonly projection: Projection;
  /** The formulation, or the residual of `ida`. */
  private readonly formulation: StateMap;
  private readonly stepper: Stepper;
  private readonly projecting: boolean;
  /** Where the attitude is free: the formulation works in their present one. */
  private readonly charts: AttitudeCharts | null;
  /** Work before the stepper was last restarted. */
  private readonly earlier = zeroCounters();
  /** For rows, so that a look between steps leaves the factors of the step's end alone. */
  private readonly rowDynamics: ConstrainedSystem;
  private readonly rowProjection: Projection;
  private readonly events: EventFunction[];
  private readonly eventValues: Float64Array;
  /** State at which events were last looked at. */
  private readonly eventQ: Float64Array;
  private readonly eventV: Float64Array;
  private chunk: Float64Array[];
  private readonly lambda: Float64Array;
  private readonly u: Float64Array;
  private readonly energies = new Float64Array(2);
  private balance: EnergyBalance;
  /** State at the end of the last step, and at a time within it. */
  private readonly endQ: Float64Array;
  private readonly endV: Float64Array;
  private readonly sample: Float64Array;
  private readonly sampleQ: Float64Array;
  private readonly sampleV: Float64Array;
  private readonly extras: ReadonlySet<string>;
  private readonly hand: PushForce | null;
  /** Pushes to come, the next one last. */
  private readonly coming: PushRecord[];
  private emitted = 0;
  private largestResidual = 0;

  constructor(
    scenario: Scenario,
    system: System,
    { extras = scenario.columns, from, feedback = null, pushes }: RunOptions = {},
  ) {
    this.scenario = scenario;
    this.system = system;
    const { meta } = system;
    const n = (this.n = meta.coordinates.length);
    const parameters = Float64Array.from(meta.parameters, (p) => scenario.parameters[p.name]!);
    const hold = scenario.hold.map((name) => meta.coordinates.findIndex((c) => c.name === name));
    const startTime = from?.time ?? 0;
    this.actuation = actuationOf(scenario, meta, feedback);
    const planned = { from: startTime, until: scenario.duration, ...sightOf(scenario.method) };
    const stepped = this.actuation.forcing
      ? actuationOf(scenario, meta, feedback, planned, this.actuation.held)
      : this.actuation;
    const start = from
      ? { q: Float64Array.from(from.q), v: Float64Array.from(from.v), adjustments: [], notes: [] }
      : consistentStart(system, parameters, scenario.constraints, hold, scenario.initial);
    this.adjustments = start.adjustments;
    const withTime = (plan: InputPlan | null, options: PlanOptions): InputPlan | null =>
      planOfTime(plan, options, system, parameters, start.q);
    this.plan = withTime(stepped.plan, planned);
    this.clock = system.timeFormulas ? meta.coordinates.findIndex(({ name }) => name === meta.clock) : -1;
    this.ahead = this.clock < 0 ? 0 : start.q[this.clock]! - startTime;
    const unresolved = this.plan && fixedStepOf(scenario.method);
    const closely = { ...planned, quiet: SMALL_PART, reach: REACH_OF_ONE };
    this.warnings = [
      ...(unresolved
        ? tooFast(withTime(actuationOf(scenario, meta, feedback, closely).plan, closely), unresolved)
        : []),
      ...(feedback && !from ? turnWarnings(turnsAway(meta, start.q, feedback.values())) : []),
    ];
    this.q = start.q;
    this.v = start.v;
    this.hand = pushes ? new PushForce(system, parameters) : null;
    this.coming = [...(pushes ?? [])].reverse();
    const forced = ({ forcing }: Actuation): Forcing | null =>
      this.hand ? together(forcing, this.hand.forcing) : forcing;
    this.balance = new EnergyBalance(forced(stepped), n, this.outsidePower());
    this.charts = AttitudeCharts.of(system, parameters, scenario.constraints, hold);
    this.dynamics = new ConstrainedSystem(
      this.charts?.system ?? system,
      parameters,
      scenario.constraints,
      hold,
      this.charts ? this.charts.forcing(forced(stepped), parameters) : forced(stepped),
    );
    this.projection = new Projection(this.dynamics);
    this.rowDynamics = new ConstrainedSystem(system, parameters, scenario.constraints, hold, forced(this.actuation));
    this.lambda = new Float64Array(this.dynamics.m);
    this.u = new Float64Array(this.actuation.names.length);
    this.endQ = new Float64Array(n);
    this.endV = new Float64Array(n);
    this.sampleQ = new Float64Array(n);
    this.sampleV = new Float64Array(n);
    this.extras = new Set(extras);
    this.columns = this.columnNames();
    this.chunk = this.newChunk();
    this.events = eventsOf(system, this.dynamics, scenario.events);
    this.eventQ = new Float64Array(n);
    this.eventV = new Float64Array(n);
    this.eventValues = new Float64Array(this.events.length);
    const { engine, map, stepper, problem, rowProjection } = motionOf(scenario.method, this.dynamics);
    this.rowProjection = rowProjection?.(this.rowDynamics) ?? new Projection(this.rowDynamics);
    this.engine = engine;
    this.notes = [...start.notes, ...this.engineNotes()];
    this.formulation = this.charts?.map(map) ?? map;
    this.stepper = stepper;
    this.projecting = scenario.method.projection && this.dynamics.m > 0;
    if (this.projecting && problem) problem.project = (t, y) => this.projectEnd(t, y);
    this.sample = new Float64Array(this.stepper.y.length);
    this.before = new Float64Array(this.stepper.y.length);
    this.begin(startTime);
    if (from) {
      this.rows = 0;
      this.emitted = Math.round(from.time / scenario.outputStep) + 1;
    }
  }

  /**
   * Begins anew with another scenario that differs in parameters and start alone: what a sweep does a thousand times, without
   * building everything again. Rows that were not taken are gone.
   * @returns whether it did; else a new simulation has to be constructed
   * @throws StartError
   */
  again(scenario: Scenario): boolean {
    const { system, dynamics, rowDynamics, hand, actuation, charts } = this;
    const { name, formulation = MULTIPLIERS } = scenario.method;
    if (
      hand ||
      charts ||
      actuation.forcing ||
      system.timeFormulas ||
      system.firstOrder ||
      name === 'ida' ||
      formulation !== MULTIPLIERS
    )
      return false;
    if (scenario.hold.length > 0 || frameOf(scenario) !== frameOf(this.scenario)) return false;
    const values = system.meta.parameters.map((p) => scenario.parameters[p.name]!);
    if (!dynamics.renew(values) || !rowDynamics.renew(values)) return false;
    const start = consistentStart(system, dynamics.parameters, scenario.constraints, [], scenario.initial, rowDynamics);
    rowDynamics.forget();
    this.scenario = scenario;
    this.adjustments = start.adjustments;
    this.notes = [...start.notes, ...this.engineNotes()];
    this.q.set(start.q);
    this.v.set(start.v);
    this.balance = new EnergyBalance(null, this.n, this.outsidePower());
    Object.assign(this.earlier, zeroCounters());
    this.end = null;
    this.horizon = Infinity;
    this.rows = this.emitted = this.largestResidual = 0;
    this.begin(0);
    return true;
  }

  get time(): number {
    return this.stepper.t;
  }

  /** Computed as far as its horizon. */
  get waits(): boolean {
    return !this.end && this.stepper.t >= this.horizon - REACHED;
  }

  get counts(): RunCounts {
    const { steps, rejected, evaluations, jacobians, factorizations } = addCounters(
      this.earlier,
      this.stepper.counters,
    );
    return {
      steps,
      rejected,
      evaluations,
      jacobians,
      factorizations,
      ...this.balance.numbers,
      residual: this.largestResidual,
    };
  }

  /**
   * From now on, the end of what is computed, this push acts, or none: the stepper starts anew there.
   * @throws ScenarioError for a push that means nothing
   */
  push(push: Push | null): PushRecord {
    this.hand!.set(push);
    this.dynamics.forget();
    this.rowDynamics.forget();
    this.restart();
    return { time: this.stepper.t, push };
  }

  /** Steps until the run ends, its horizon is reached or `pause` (asked after every step) says so. */
  advance(pause: () => boolean): void {
    while (!this.end && !this.waits) {
      this.oneStep();
      if (pause()) return;
    }
  }

  /** Hands over the rows so far, column by column, and starts a new chunk. */
  takeChunk(): { columns: Float64Array[]; rows: number } {
    const taken = { columns: this.chunk.map((c) => c.slice(0, this.rows)), rows: this.rows };
    this.rows = 0;
    return taken;
  }

  /** Ends the run from outside, keeping everything computed. */
  stop(reason: string, message: string, time = this.stepper.t): void {
    this.end ??= { reason, message, time };
  }

  private engineNotes(): string[] {
    if (this.scenario.method.engine !== 'wasm' || this.engine === 'wasm') return [];
    return [
      'computed by TypeScript: WebAssembly serves explicit pairs on multipliers, nothing held, where the host compiles it',
    ];
  }

  private begin(time: number): void {
    const { stepper, formulation, sample, q, v } = this;
    while (this.isDue(time)) this.hand!.set(this.coming.pop()!.push);
    this.endQ.set(q);
    this.endV.set(v);
    formulation.rebase(q, v);
    formulation.fromState(q, v, sample);
    stepper.reset(time, sample);
    this.sampleQ.set(q);
    this.sampleV.set(v);
    this.plan?.held?.begin(time, q, v);
    this.emit(time);
    for (const saturation of this.plan?.saturations ?? []) saturation.decide(time, q, v);
    this.eventQ.set(q);
    this.eventV.set(v);
    this.events.forEach((event, i) => {
      const value = event.value(time, this.q, this.v);
      this.eventValues[i] = value;
      // Dependent constraints at the very start leave nothing to integrate; a corner below ground may rise.
      if (event.id === 'constraint-singular' && !(value > 0)) this.stop(event.id, event.message(time));
    });
  }

  /** Whether the next of the pushes to come is there. */
  private isDue(time: number): boolean {
    return (this.coming.at(-1)?.time ?? Infinity) <= time + REACHED;
  }

  private oneStep(): void {
    const { stepper, formulation, scenario, plan, endQ: q, endV: v } = this;
    const limit = Math.min(
      scenario.duration,
      this.horizon,
      this.coming.at(-1)?.time ?? Infinity,
      plan?.end ?? Infinity,
      this.turning?.time ?? Infinity,
    );
    if (plan && plan.saturations.length > 0) this.before.set(stepper.y);
    const failure = stepper.step(limit, plan?.bound(stepper.t));
    if (failure) return this.stop(failure, this.failureMessage(failure, stepper.t) + this.doubt());
    if (this.projecting && !stepper.projects) {
      if (!this.projectEnd(stepper.t, stepper.y)) {
        const reason = this.dynamics.failure ?? 'constraint-singular';
        return this.stop(reason, this.failureMessage(reason, stepper.previousT));
      }
      stepper.stateChanged();
    }
    formulation.toState(stepper.y, q, v);
    this.charts?.stepped(q);
    if (plan && this.turnsWithin(plan)) return;
    const crossing = this.findCrossing();
    if (crossing) {
      this.addWork(crossing.time);
      this.emitBefore(crossing.time);
      this.lookAt(crossing.time);
      this.emit(crossing.time);
      return this.stop(crossing.event.id, crossing.event.message(crossing.time), crossing.time);
    }
    this.addWork(stepper.t);
    this.emitBefore(stepper.t);
    if (stepper.t >= scenario.duration) {
      this.sampleQ.set(q);
      this.sampleV.set(v);
      this.emit(stepper.t);
      return this.stop('end', `ran to t = ${scenario.duration} s${this.doubt()}`);
    }
    if (plan) this.pass(plan);
    // Last, because the dense output of the step is in the old meaning of y.
    if (formulation.rebase(q, v)) {
      this.dynamics.forget();
      this.restart();
    }
    while (this.isDue(stepper.t)) this.push(this.coming.pop()!.push);
  }

  /** A step ended: where inputs switch or a limit is reached there, the next one begins with what they are from now on. */
  private pass(plan: InputPlan): void {
    const { stepper, turning, endQ, endV } = this;
    const { t } = stepper;
    let jumps = false;
    if (t >= plan.end) jumps = plan.arrive(t, endQ, endV);
    if (turning && t >= turning.time) {
      turning.saturation.turn(t, endQ, endV);
      this.turning = null;
      jumps = true;
    }
    for (const saturation of plan.saturations) {
      if (saturation.side === saturation.side) continue;
      saturation.decide(t, endQ, endV);
      jumps = true;
    }
    if (!jumps) return;
    this.dynamics.forget();
    if (this.clock < 0) return stepper.restart();
    // The equations decide by their clock, which is t but for rounding: from now on it is beyond what switched at t.
    const now = t + this.ahead;
    endQ[this.clock] = now + CLOCK_ROUNDING * Math.max(1, Math.abs(now));
    if (this.projecting) this.projection.project(t, endQ, endV, true);
    this.restart();
  }

  /**
   * Whether a controller reached or left its limit within the last step, which is then taken back: the next ones end
   * there (the step itself was computed with the old side, so that it and its dense output are smooth).
   */
  private turnsWithin(plan: InputPlan): boolean {
    const { stepper, before } = this;
    const { t, previousT } = stepper;
    let first: { saturation: Saturation; time: number } | null = null;
    for (const saturation of plan.saturations) {
      const left = (time: number): boolean => {
        if (time === t) return saturation.left(t, this.endQ, this.endV);
        this.lookAt(time);
        return saturation.left(time, this.sampleQ, this.sampleV);
      };
      const until: number = first?.time ?? t;
      for (let look = 1, low = previousT; look <= LIMIT_LOOKS; look++) {
        const high: number = look === LIMIT_LOOKS ? until : previousT + ((until - previousT) * look) / LIMIT_LOOKS;
        if (left(high)) {
          first = { saturation, time: firstTime(left, low, high) };
          break;
        }
        low = high;
      }
    }
    // Where the step was to end for it, it may be a last digit early or late.
    const due = this.turning && t >= this.turning.time ? this.turning.saturation : null;
    if (!first || first.saturation === due) {
      this.turns = 0;
      return false;
    }
    const at = first.time - previousT <= REACHED * (t - previousT) ? previousT : first.time;
    this.rewind(previousT, before);
    if (at > previousT) {
      this.turning = { saturation: first.saturation, time: at };
      return true;
    }
    if (++this.turns > MOST_TURNS) first.saturation.side = NaN;
    else first.saturation.turn(previousT, this.endQ, this.endV);
    return true;
  }

  /** Takes the last step back. */
  private rewind(t: number, y: Float64Array): void {
    const { stepper, earlier } = this;
    Object.assign(earlier, addCounters(earlier, stepper.counters));
    stepper.reset(t, y);
    this.formulation.toState(y, this.endQ, this.endV);
    this.dynamics.forget();
  }

  /** What drives and forces of the system itself put in, W. */
  private outsidePower(): Power | null {
    const { system, n } = this;
    if (!system.outsidePower) return null;
    const a = new Float64Array(n);
    return (t, q, v) => {
      const { rowDynamics: dynamics, lambda } = this;
      if (system.clock !== undefined && !dynamics.acceleration(t, q, v, a, lambda)) return NaN;
      let power = system.outsidePower!(q, v, a, dynamics.parameters);
      if (system.clock !== undefined) for (let r = 0; r < dynamics.m; r++) power -= lambda[r]! * dynamics.drift[r]!;
      return power;
    };
  }

  private addWork(until: number): void {
    const { balance, stepper, sampleQ, sampleV } = this;
    balance.step(stepper.previousT, until, sampleQ, sampleV, (t) => this.lookAt(t));
  }

  /** Puts y, the end of a step, on the constraint manifold. */
  private projectEnd(t: number, y: Float64Array): boolean {
    const { formulation, endQ: q, endV: v } = this;
    formulation.toState(y, q, v);
    if (!this.projection.project(t, q, v, true)) return false;
    formulation.fromState(q, v, y);
    return true;
  }

  /** The formulation changed the meaning of y: the stepper starts anew from the end of the last step. */
  private restart(): void {
    const { stepper, sample } = this;
    Object.assign(this.earlier, addCounters(this.earlier, stepper.counters));
    this.formulation.fromState(this.endQ, this.endV, sample);
    stepper.reset(stepper.t, sample);
  }

  /** State at a time within the last step into `sampleQ`, `sampleV`. */
  private lookAt(time: number): void {
    this.stepper.interpolate(time, this.sample);
    this.formulation.toState(this.sample, this.sampleQ, this.sampleV);
  }

  /** Emits the rows due before a time of the last step; the run's last row is emitted by its end. */
  private emitBefore(time: number): void {
    const { outputStep } = this.scenario;
    // A row closer than this to the end of the run or to an event would only repeat it.
    const last = time - 1e-9 * outputStep;
    for (let next = this.emitted * outputStep; next < last && !this.end; next = this.emitted * outputStep) {
      this.lookAt(next);
      this.emit(next);
    }
  }

  /** The earliest downward crossing in the last step, whose end state is `endQ`, `endV`. */
  private findCrossing(): { event: EventFunction; time: number } | null {
    const { stepper, events } = this;
    const { previousT, t } = stepper;
    let first: { event: EventFunction; time: number } | null = null;
    const pieces = events.some(({ smooth }) => smooth) ? this.piecesOf(t - previousT) : 1;
    for (let e = 0; e < events.length; e++) {
      const event = events[e]!;
      const before = this.eventValues[e]!;
      const value = (this.eventValues[e] = event.value(t, this.endQ, this.endV));
      if (!event.smooth && (value > 0 || !(before > 0))) continue;
      const within = event.smooth ? this.crossingOf(event, before, value, pieces) : ([previousT, t] as const);
      if (!within) continue;
      const time = this.bisect(event, ...within);
      if (!first || time < first.time) first = { event, time };
    }
    return first;
  }

  /** By how far the state goes in a step of h: what an event is a function of. */
  private piecesOf(h: number): number {
    const { eventQ, eventV, endQ, endV, system } = this;
    let most = 1;
    system.meta.coordinates.forEach(({ kind, pure }, i) => {
      const way = Math.max(Math.abs(endQ[i]! - eventQ[i]!), h * Math.abs(eventV[i]!), h * Math.abs(endV[i]!));
      if (!pure) most = Math.max(most, way / LOOKED_AT[kind]);
    });
    eventQ.set(endQ);
    eventV.set(endV);
    return Math.min(MOST_PIECES, Math.ceil(most));
  }

  /** In the last step, at whose ends an event has these values: of the motion as its rows show it, projected. */
  private crossingOf(event: EventFunction, before: number, after: number, pieces: number): Crossing | null {
    const { previousT, t } = this.stepper;
    const atEnds =
      (within: (time: number) => number) =>
      (time: number): number =>
        time === previousT ? before : time === t ? after : within(time);
    const nearly = (time: number): number => {
      this.lookAt(time);
      return event.value(time, this.sampleQ, this.sampleV);
    };
    if (!this.projecting) return firstCrossing({ value: atEnds(nearly), pieces }, previousT, t);
    const off = UNPROJECTED * Math.abs(nearly(t) - after);
    const value = atEnds((time) => this.projectedValueAt(event, time));
    return firstCrossing({ value, pieces, nearly: atEnds(nearly), off }, previousT, t);
  }

  private projectedValueAt(event: EventFunction, time: number): number {
    this.lookAt(time);
    if (this.projecting) this.rowProjection.project(time, this.sampleQ, this.sampleV);
    return event.value(time, this.sampleQ, this.sampleV);
  }

  /** What is to be said at the end of a free body's run whose fixed steps were too long beside pitch 90°. */
  private doubt(): string {
    const step = fixedStepOf(this.scenario.method);
    const nearness = this.charts?.nearness ?? 0;
    if (step === null || !(nearness > MOST_NEARNESS)) return '';
    return (
      `; a step of ${step} s passed too near to pitch 90° to be right there: take one of ` +
      `${((step * MOST_NEARNESS) / Math.max(2 * MOST_NEARNESS, nearness)).toPrecision(1)} s, or a method that chooses its steps`
    );
  }

  /** First time in (low, high] at which the event's value is not positive, to the last digits of t. */
  private bisect(event: EventFunction, low: number, high: number): number {
    for (let middle = 0.5 * (low + high); middle > low && middle < high; middle = 0.5 * (low + high)) {
      if (this.projectedValueAt(event, middle) > 0) low = middle;
      else high = middle;
    }
    return high;
  }

  /** One row: the state in `sampleQ`, `sampleV`, projected if projection is on, and what is derived from it. Ends the run where that is not finite. */
  private emit(time: number): void {
    const { n, extras, rowDynamics: dynamics, sampleQ: q, sampleV: v } = this;
    const projected = this.projecting && this.rowProjection.project(time, q, v);
    if (!(maxAbs(q) < Infinity && maxAbs(v) < Infinity))
      return this.stop('non-finite', this.failureMessage('non-finite', time), time);
    if (this.rows >= this.chunk[0]!.length) this.grow();
    const row = this.rows++;
    let c = 0;
    this.chunk[c++]![row] = time;
    for (let i = 0; i < n; i++) this.chunk[c++]![row] = q[i]!;
    for (let i = 0; i < n; i++) this.chunk[c++]![row] = v[i]!;
    if (extras.has('lambda')) {
      if (!this.rowProjection.multipliers(time, q, v, this.lambda)) this.lambda.fill(NaN);
      for (let r = 0; r < dynamics.m; r++) this.chunk[c++]![row] = this.lambda[r]!;
    }
    (this.charts ?? this.system).energy(q, v, dynamics.parameters, this.energies);
    this.balance.row(this.energies[0]!, this.energies[1]!);
    const residual = projected ? this.rowProjection.left : this.rowProjection.residual(q, v);
    this.largestResidual = Math.max(this.largestResidual, residual);
    if (extras.has('energy')) this.chunk[c++]![row] = this.energies[0]! + this.energies[1]!;
    if (extras.has('residual')) this.chunk[c++]![row] = residual;
    if (extras.has('inputs')) {
      this.actuation.values(time, q, v, this.u);
      for (let i = 0; i < this.u.length; i++) this.chunk[c++]![row] = this.u[i]!;
    }
    if (extras.has('energy-parts')) {
      this.chunk[c++]![row] = this.energies[0]!;
      this.chunk[c++]![row] = this.energies[1]!;
    }
    this.emitted++;
  }

  private columnNames(): string[] {
    const names = this.system.meta.coordinates.map((c) => c.name);
    const list = ['t', ...names, ...names.map((name) => `${name}_dot`)];
    if (this.extras.has('lambda')) for (let r = 1; r <= this.dynamics.m; r++) list.push(`lambda_${r}`);
    if (this.extras.has('energy')) list.push('energy');
    if (this.extras.has('residual')) list.push('residual');
    if (this.extras.has('inputs')) list.push(...this.actuation.names);
    if (this.extras.has('energy-parts')) list.push('kinetic', 'potential');
    return list;
  }

  private newChunk(): Float64Array[] {
    const { duration, outputStep } = this.scenario;
    const rows = Math.min(CHUNK_ROWS, Math.ceil(duration / outputStep) + 2);
    return this.columns.map(() => new Float64Array(rows));
  }

  private failureMessage(reason: string, t: number): string {
    return failureMessage(reason, t, this.endQ, this.endV, this.system, this.dynamics, this.scenario.method);
  }

  private grow(): void {
    this.chunk = this.chunk.map((old) => {
      const grown = new Float64Array(2 * old.length);
      grown.set(old);
      return grown;
    });
  }
}

/** All of a scenario but its parameters and start. */
function frameOf(scenario: Scenario): string {
  return JSON.stringify({ ...scenario, parameters: null, parameterSet: null, initial: null });
}

/** The step of a method that has no other; null for one that chooses its steps. */
function fixedStepOf({ name, step, maxStep }: Scenario['method']): number | null {
  if (methods.find((m) => m.id === name)?.adaptive !== false) return null;
  return Math.min(step ?? DEFAULT_STEP, maxStep ?? Infinity);
}

/** A warning where a fixed step passes over what an input does. */
function tooFast(plan: InputPlan | null, step: number): string[] {
  const found = plan?.unresolved(step);
  if (!found) return [];
  return [
    `${found.name} changes within a step at t = ${found.time.toPrecision(6)} s: a fixed step of ${step} s cannot follow it; ` +
      `take one of ${found.step.toPrecision(2)} s, or a method that chooses its steps`,
  ];
}

/** First time in (low, high] at which a test holds that holds at `high`, to the last digits of t. */
function firstTime(test: (t: number) => boolean, low: number, high: number): number {
  for (let middle = 0.5 * (low + high); middle > low && middle < high; middle = 0.5 * (low + high)) {
    if (test(middle)) high = middle;
    else low = middle;
  }
  return high;
}

function addCounters(a: Counters, b: Counters): Counters {
  return {
    steps: a.steps + b.steps,
    rejected: a.rejected + b.rejected,
    evaluations: a.evaluations + b.evaluations,
    jacobians: a.jacobians + b.jacobians,
    factorizations: a.factorizations + b.factorizations,
  };
}
