/**
 * What every stepper is: a way to advance `y' = f(t, y)` in time. It knows nothing of mechanics.
 * Rules for adding one: README.md beside this file.
 *
 * How a run loop takes a stepper through times at which f, y or a derivative of f jumps (a switch of an input, a sample
 * of a controller, an impact):
 *
 *     stepper.step(limit, maxStep)   one accepted step; it ends at `limit` to the last bit, never beyond
 *     stepper.restart()              at the jump: nothing learned of f before it is used after it
 *
 * 1. Let `limit` be the time of the next jump (or of the end, if that comes first), known before the step.
 * 2. Within a step f must be smooth. Methods evaluate f at the very end of a step too, and mean the value from the left:
 *    a problem with a switch there keeps the branch that it had at the start of the step, whatever t says.
 * 3. Once `stepper.t === limit`, rows are read with `interpolate` as ever; then change the branch (and `y` in place, if
 *    y itself jumps), and call `restart()`.
 * 4. `maxStep` bounds this one step, its repetitions included. It may differ at every call (a function of `stepper.t`: the
 *    width of a pulse that is near), and counts beside `StepperOptions.maxStep`: the smaller holds. A bound leaves no
 *    trace in one-step methods; multistep methods grow again from it.
 *
 * `stateChanged` is for moves of y alone, of about the local error (a projection): then bdf keeps its order.
 */

/** Why a step could not be taken. Ids are permanent; problems may add their own (`constraint-singular`, …). */
export type StepFailure = 'step-too-small' | 'non-finite' | 'newton' | (string & {});

export interface OdeProblem {
  readonly dimension: number;
  /**
   * f(t, y) into `out`; false where it has no value, with the reason in `failure`.
   * @param t time, s
   * @param y state, `dimension`
   * @param out derivative by time, `dimension`
   */
  derivative(t: number, y: Float64Array, out: Float64Array): boolean;
  /**
   * Exact df/dy where the problem has one; implicit methods else use differences.
   * @param out dimension x dimension, row-major
   */
  jacobian?(t: number, y: Float64Array, out: Float64Array): boolean;
  /**
   * Moves y, the proposed end of a step, in place onto the manifold that holds the solutions; false where it cannot. A
   * stepper that evaluates f at the end of its steps calls it before it does so (and says that it `projects`).
   */
  project?(t: number, y: Float64Array): boolean;
  readonly failure: string | null;
}

export interface Counters {
  /** Accepted steps. */
  steps: number;
  rejected: number;
  /** Calls of f. */
  evaluations: number;
  jacobians: number;
  factorizations: number;
}

export interface StepperOptions {
  /** Relative tolerance of each component. */
  rtol: number;
  /** Absolute tolerance of each component, in its own unit. */
  atol: number;
  /** Fixed-step methods: the step. Adaptive ones: the first step (chosen when absent). s */
  step?: number;
  /** Upper bound of every step, s. */
  maxStep?: number;
  /** Collocation methods. */
  stages?: number;
}

export interface Stepper {
  /** Time and state at the end of the last accepted step; `y` may be changed in place, then call `stateChanged`. */
  readonly t: number;
  readonly y: Float64Array;
  /** Start of the last accepted step. */
  readonly previousT: number;
  readonly counters: Counters;
  /** Its steps end where `problem.project` puts them: nobody else need project them. */
  readonly projects?: true;
  /**
   * Starts anew at (t, y), counters at zero: as good as a new instance.
   * @param t time, s
   * @param y state, `dimension`; copied
   */
  reset(t: number, y: Float64Array): void;
  /**
   * One accepted step.
   * @param limit where it ends at the latest, s; exactly there if it would come close
   * @param maxStep upper bound of this step, s; beside that of the options. None when absent
   * @returns null, or why there was none; `t` and `y` are then as before
   */
  step(limit: number, maxStep?: number): StepFailure | null;
  /**
   * State at a time within the last accepted step, by the method's own dense output.
   * @param t time in [previousT, t], s
   * @param out `dimension`
   */
  interpolate(t: number, out: Float64Array): void;
  /** `y` was moved (projected, or pushed): what was kept of it for the next step is stale. */
  stateChanged(): void;
  /**
   * f or `y` has jumped at `t`: the next step begins anew from there with what f is now. Slopes, Jacobians, predictions
   * and, in multistep methods, the history and the order are dropped, and the step is chosen anew: by one-step methods
   * no longer than the one they had. Counters run on, and `interpolate` still reads the last step.
   */
  restart(): void;
}

/**
 * Counters of a run that has not begun.
 */
export function zeroCounters(): Counters {
  return { steps: 0, rejected: 0, evaluations: 0, jacobians: 0, factorizations: 0 };
}
