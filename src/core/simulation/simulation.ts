import { REACH_OF_ONE } from '../scenario/expressions/pace.ts';
import { ConstrainedSystem } from '../mechanics/constrainedSystem.ts';
import { AttitudeCharts } from '../mechanics/attitudeCharts.ts';
import { consistentStart, type StartAdjustment } from '../mechanics/consistentStart.ts';
import { eventsOf } from '../mechanics/events.ts';
import { Projection } from '../mechanics/projection.ts';
import type { Forcing } from '../mechanics/forcing.ts';
import type { EngineId, Scenario } from '../scenario/types.ts';
import type { System } from '../model/system.ts';
import { actuationOf, type Actuation } from './actuation.ts';
import { Crossings } from './crossings.ts';
import { EnergyBalance, outsidePowerOf } from './energyBalance.ts';
import { failureMessage } from './failureMessage.ts';
import { doubtAtPole, fixedStepOf, SMALL_PART, tooFast } from './fixedStep.ts';
import { planOfTime, sightOf, type InputPlan, type PlanOptions } from './inputPlan.ts';
import { LastStep } from './lastStep.ts';
import { LimitTurns } from './limitTurns.ts';
import { MULTIPLIERS, motionOf } from './motion.ts';
import type { Push, PushRecord } from './push.ts';
import { PushForce, together } from './pushForce.ts';
import { Rows } from './rows.ts';
import { REACHED, type RunCounts, type RunEnd, type RunOptions } from './run.ts';
import { turnsAway, turnWarnings } from './turnsAway.ts';

export { EXTRA_COLUMNS, PAGE_COLUMNS, type Continuation, type RunCounts, type RunEnd, type RunOptions } from './run.ts';

/** A clock that goes along with t is it to this, beside itself or 1 s. */
const CLOCK_ROUNDING = 8 * Number.EPSILON;

/** What is left out before a switch that equations decide by their clock, beside the time or 1 s: more than the clock is ahead. */
const CLOCK_SKIPS = 48 * Number.EPSILON;

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

  private scenario: Scenario;
  private readonly system: System;
  /** As the formulas stand, for rows. */
  private readonly actuation: Actuation;
  /** What the steps know of the inputs beforehand. */
  private readonly plan: InputPlan | null;
  private readonly turns: LimitTurns;
  /** Index of the coordinate by which equations take the time, or -1; and what it is ahead of t, s. */
  private readonly clock: number;
  private readonly ahead: number;
  private readonly step: LastStep;
  private readonly charts: AttitudeCharts | null;
  private readonly rowDynamics: ConstrainedSystem;
  private readonly crossings: Crossings;
  private readonly emitted: Rows;
  private balance: EnergyBalance;
  private readonly hand: PushForce | null;
  /** Pushes to come, the next one last. */
  private readonly coming: PushRecord[];

  constructor(
    scenario: Scenario,
    system: System,
    { extras = scenario.columns, from, feedback = null, pushes }: RunOptions = {},
  ) {
    this.scenario = scenario;
    this.system = system;
    const { meta } = system;
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
    const charts = (this.charts = AttitudeCharts.of(system, parameters, scenario.constraints, hold));
    this.dynamics = new ConstrainedSystem(
      charts?.system ?? system,
      parameters,
      scenario.constraints,
      hold,
      charts ? charts.forcing(forced(stepped), parameters) : forced(stepped),
    );
    const dynamics = new ConstrainedSystem(system, parameters, scenario.constraints, hold, forced(this.actuation));
    this.rowDynamics = dynamics;
    this.balance = new EnergyBalance(forced(stepped), dynamics.n, outsidePowerOf(system, dynamics));
    const { engine, map, stepper, problem, rowProjection } = motionOf(scenario.method, this.dynamics);
    this.engine = engine;
    this.notes = [...start.notes, ...this.engineNotes()];
    const projection = rowProjection?.(dynamics) ?? new Projection(dynamics);
    const projecting = scenario.method.projection && this.dynamics.m > 0;
    this.step = new LastStep(
      { map: charts?.map(map) ?? map, stepper },
      this.dynamics,
      charts,
      projecting ? { ends: new Projection(this.dynamics), rows: projection } : null,
    );
    if (projecting && problem) problem.project = (t, y) => this.step.projectEnd(t, y);
    this.turns = new LimitTurns(this.plan?.saturations ?? [], this.step);
    this.crossings = new Crossings(eventsOf(system, this.dynamics, scenario.events), meta.coordinates, this.step);
    this.emitted = new Rows({ system, dynamics, projection, actuation: this.actuation, charts, extras }, scenario);
    this.columns = this.emitted.columns;
    this.begin(startTime);
    if (from) {
      this.emitted.count = 0;
      this.emitted.emitted = Math.round(from.time / scenario.outputStep) + 1;
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
    if ((scenario.hold.length > 0 && !dynamics.direct) || frameOf(scenario) !== frameOf(this.scenario)) return false;
    const values = system.meta.parameters.map((p) => scenario.parameters[p.name]!);
    if (!dynamics.renew(values) || !rowDynamics.renew(values)) return false;
    const { parameters, held } = dynamics;
    const start = consistentStart(system, parameters, scenario.constraints, held, scenario.initial, rowDynamics);
    rowDynamics.forget();
    this.scenario = scenario;
    this.adjustments = start.adjustments;
    this.notes = [...start.notes, ...this.engineNotes()];
    this.q.set(start.q);
    this.v.set(start.v);
    this.balance = new EnergyBalance(null, dynamics.n, outsidePowerOf(system, rowDynamics));
    this.end = null;
    this.horizon = Infinity;
    this.emitted.clear();
    this.begin(0);
    return true;
  }

  get time(): number {
    return this.step.t;
  }

  /** Rows waiting in the chunk. */
  get rows(): number {
    return this.emitted.count;
  }

  /** Computed as far as its horizon. */
  get waits(): boolean {
    return !this.end && this.step.t >= this.horizon - REACHED;
  }

  get counts(): RunCounts {
    const { steps, rejected, evaluations, jacobians, factorizations } = this.step.counters;
    return {
      steps,
      rejected,
      evaluations,
      jacobians,
      factorizations,
      ...this.balance.numbers,
      residual: this.emitted.largestResidual,
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
    this.step.restart();
    return { time: this.step.t, push };
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
    return this.emitted.take();
  }

  /** Ends the run from outside, keeping everything computed. */
  stop(reason: string, message: string, time = this.step.t): void {
    this.end ??= { reason, message, time };
  }

  private engineNotes(): string[] {
    if (this.scenario.method.engine !== 'wasm' || this.engine === 'wasm') return [];
    return [
      'computed by TypeScript: WebAssembly serves explicit pairs on multipliers, nothing held, where the host compiles it',
    ];
  }

  private begin(time: number): void {
    const { q, v } = this;
    while (this.isDue(time)) this.hand!.set(this.coming.pop()!.push);
    this.step.begin(time, q, v);
    this.plan?.held?.begin(time, q, v);
    this.emit(time);
    this.turns.begin(time, q, v);
    const happened = this.crossings.begin(time, q, v);
    if (happened) this.stop(happened.id, happened.message(time));
  }

  /** Whether the next of the pushes to come is there. */
  private isDue(time: number): boolean {
    return (this.coming.at(-1)?.time ?? Infinity) <= time + REACHED;
  }

  /**
   * Where a step ends for the next switch, s. Equations that decide by a clock of their own, which is t but for rounding, must not
   * see its other side at the end of the step: the last digits to the switch are skipped.
   */
  private get switchEnd(): number {
    const { plan, clock, scenario, step } = this;
    const end = plan?.end ?? Infinity;
    if (clock < 0 || !(end <= scenario.duration)) return end;
    const shy = end - CLOCK_SKIPS * Math.max(1, Math.abs(end));
    return shy > step.t ? shy : end;
  }

  private oneStep(): void {
    const { step, scenario, plan, switchEnd } = this;
    const limit = Math.min(
      scenario.duration,
      this.horizon,
      this.coming.at(-1)?.time ?? Infinity,
      switchEnd,
      this.turns.end,
    );
    this.turns.remember();
    const failed = step.take(limit, plan?.bound(step.t));
    if (failed) return this.fail(failed.reason, failed.time);
    if (plan && this.turns.takeBack()) return;
    const crossing = this.crossings.find();
    if (crossing) {
      const { event, time } = crossing;
      this.addWork(time);
      this.emitBefore(time);
      step.lookAt(time);
      this.emit(time);
      return this.stop(event.id, event.message(time), time);
    }
    this.addWork(step.t);
    this.emitBefore(step.t);
    if (step.t >= scenario.duration) {
      step.lookAtEnd();
      this.emit(step.t);
      return this.stop('end', `ran to t = ${scenario.duration} s${doubtAtPole(scenario.method, this.charts)}`);
    }
    if (plan) this.pass(plan, step.t >= switchEnd && plan.end < scenario.duration);
    // Last, because the dense output of the step is in the old meaning of y.
    step.rebase();
    while (this.isDue(step.t)) this.push(this.coming.pop()!.push);
  }

  /** A step ended: where inputs switch or a limit is reached there, the next one begins with what they are from now on. */
  private pass(plan: InputPlan, isSwitch: boolean): void {
    const { step } = this;
    const { q, v } = step;
    const t = isSwitch ? Math.max(step.t, plan.end) : step.t;
    let jumps = isSwitch && plan.arrive(t, q, v);
    jumps = this.turns.arrive() || jumps;
    if (!jumps) return;
    this.dynamics.forget();
    if (this.clock < 0) return step.stepper.restart();
    // From now on the clock is beyond what switched at t.
    const now = t + this.ahead;
    q[this.clock] = now + CLOCK_ROUNDING * Math.max(1, Math.abs(now));
    step.projections?.ends.project(t, q, v, true);
    step.restart(t);
  }

  private addWork(until: number): void {
    const { balance, step } = this;
    balance.step(step.previousT, until, step.atQ, step.atV, (t) => step.lookAt(t));
  }

  /** Emits the rows due before a time of the last step; the run's last row is emitted by its end. */
  private emitBefore(time: number): void {
    const { step, emitted } = this;
    const { outputStep } = this.scenario;
    // A row closer than this to the end of the run or to an event would only repeat it.
    const last = time - 1e-9 * outputStep;
    for (let next = emitted.emitted * outputStep; next < last && !this.end; next = emitted.emitted * outputStep) {
      step.lookAt(next);
      this.emit(next);
    }
  }

  /** One row, of the state that was looked at. Ends the run where that is not finite. */
  private emit(time: number): void {
    if (!this.emitted.emit(time, this.step, this.balance))
      this.stop('non-finite', this.failureMessage('non-finite', time), time);
  }

  private fail(reason: string, time: number): void {
    this.stop(reason, this.failureMessage(reason, time) + doubtAtPole(this.scenario.method, this.charts));
  }

  private failureMessage(reason: string, t: number): string {
    const { step, system, dynamics, scenario } = this;
    return failureMessage(reason, t, step.q, step.v, system, dynamics, scenario.method);
  }
}

/** All of a scenario but its parameters and start. */
function frameOf(scenario: Scenario): string {
  return JSON.stringify({ ...scenario, parameters: null, parameterSet: null, initial: null });
}
