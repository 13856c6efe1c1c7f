import type { System } from '../model/system.ts';
import { compiled, type CompiledExpression } from '../scenario/expressions.ts';
import { Schedule, type ScheduleOptions } from '../scenario/expressions/schedule.ts';
import { REACH_OF_ONE, REACH_OF_STAGES } from '../scenario/expressions/pace.ts';
import type { Scenario } from '../scenario/types.ts';
import type { HeldControl } from './heldControl.ts';
import type { Saturation } from './saturation.ts';

/** A part of a formula's largest size that may go unseen, beside the relative tolerance; rounding sets the least. */
const UNSEEN = 0.01;
const LEAST_UNSEEN = 1e-14;
const MOST_UNSEEN = 1e-5;

/** Methods that know an input by one value a step. */
const oneValue: ReadonlySet<string> = new Set(['bdf', 'ida']);

/** A fixed step has no error estimate to shorten it: so many have to fit into the bound. */
const FIXED_ROOM = 5;
/** After the first place that a fixed step passes over, so many windows are looked at for the shortest step. */
const MOST_WINDOWS = 200;

/**
 * How closely a run of a method has to look at its inputs.
 *
 * @param method of the scenario: its name, relative tolerance and stages
 */
export function sightOf(method: Scenario['method']): Pick<PlanOptions, 'quiet' | 'reach'> {
  const { name, rtol, stages } = method;
  return {
    quiet: Math.min(MOST_UNSEEN, Math.max(LEAST_UNSEEN, UNSEEN * rtol)),
    reach: oneValue.has(name) || stages === 1 ? REACH_OF_ONE : REACH_OF_STAGES,
  };
}

/** Where and when a run's inputs are formulas, and how closely they are looked at. */
export interface PlanOptions {
  from: number;
  until: number;
  /** What part of its largest size an input may change by unseen. */
  quiet: number;
  /** How much faster than a step they may change within it (`pace.ts`). */
  reach: number;
}

/**
 * What a run knows of its inputs before it takes a step: the time of their next switch (`end`) and how long a step may be
 * (`bound`), from the formulas of open-loop inputs and references; and the limits that a controller can reach.
 */
export class InputPlan {
  readonly saturations: Saturation[] = [];
  /** A controller that a computer runs. */
  held: HeldControl | null = null;
  private readonly schedules: { schedule: Schedule; name: string }[] = [];
  private readonly options: Omit<ScheduleOptions, 'withRate'>;

  constructor(options: PlanOptions) {
    this.options = options;
  }

  /**
   * @param withRate whether its rate acts too, as that of a reference
   * @returns where to look at the formula for a time of a step (`Schedule.inside`)
   */
  add(expression: CompiledExpression, name: string, withRate: boolean): (t: number) => number {
    if (expression.constant) return (t) => t;
    const schedule = new Schedule(expression, { ...this.options, withRate });
    this.schedules.push({ schedule, name });
    return (t) => schedule.inside(t);
  }

  /** Nothing is to be planned for. */
  get idle(): boolean {
    return this.schedules.length === 0 && this.saturations.length === 0 && !this.held;
  }

  /** No step may go beyond it, s. */
  get end(): number {
    let end = this.held?.end ?? Infinity;
    for (const { schedule } of this.schedules) end = Math.min(end, schedule.end);
    return end;
  }

  /** Upper bound of a step from t on, s. */
  bound(t: number): number {
    let bound = Infinity;
    for (const { schedule } of this.schedules) bound = Math.min(bound, schedule.bound(t));
    return bound;
  }

  /** A step ended at t in this state: from now on what has switched there is on its other side. Whether any input jumps. */
  arrive(t: number, q: Float64Array, v: Float64Array): boolean {
    let jumps = false;
    for (const { schedule } of this.schedules) {
      if (schedule.end > t) continue;
      schedule.begin(t);
      jumps ||= schedule.jumps;
    }
    // After the references, of which it may measure the other side.
    if (this.held?.isDue(t)) jumps = this.held.arrive(t, q, v) || jumps;
    return jumps;
  }

  /**
   * Where a fixed step passes over what an input does: the input, the first such time and the step that would do after it.
   * Spends the plan: its stretches are gone through.
   */
  unresolved(step: number): { name: string; time: number; step: number } | null {
    const { from, until } = this.options;
    let found = null as { name: string; time: number; step: number } | null;
    for (const { schedule, name } of this.schedules) {
      let more = MOST_WINDOWS;
      for (let t = from; t < until && more > 0;) {
        const bound = schedule.bound(t);
        const short = bound < FIXED_ROOM * step;
        if (short) found = { name, time: found?.time ?? t, step: Math.min(found?.step ?? step, bound / FIXED_ROOM) };
        if (found) more--;
        t = Math.min(schedule.end, t + Math.min(bound, until - t));
        if (t >= schedule.end) schedule.begin(t);
      }
      if (found) return found;
    }
    return null;
  }
}

/**
 * A plan with what the equations of a system hold of the time: what is driven by it, forces that it gives.
 *
 * @param plan of the inputs, to which it is added; null: none
 * @param options for a new one
 * @param system that the run is of
 * @param parameters of the system
 * @param q coordinates at the start, n
 * @returns null where there is nothing to plan for
 */
export function planOfTime(
  plan: InputPlan | null,
  options: PlanOptions,
  system: System,
  parameters: Float64Array,
  q: Float64Array,
): InputPlan | null {
  const { meta, timeFormulas } = system;
  if (!timeFormulas) return plan;
  const clock = meta.coordinates.findIndex(({ name }) => name === meta.clock);
  const all = plan ?? new InputPlan(options);
  for (const tree of timeFormulas(parameters, q[clock]! - options.from))
    all.add(compiled(tree), 'what is given by t', false);
  return all.idle ? null : all;
}
