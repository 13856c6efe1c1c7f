import { signal } from '@preact/signals';
import { MOST_SWEEP_RUNS, withAxisValue, type SweepAxis, type SweepValue } from '../../core/scenario/sweepAxes.ts';
import type { SweepMeasure } from '../../core/motion/sweepMeasures.ts';
import { written } from '../../core/scenario/own.ts';
import type { ScenarioFile } from '../../core/scenario/types.ts';
import { systemMetas } from '../../core/systems/registry.ts';
import type { Answer } from '../../compute/client/answer.ts';
import type { Pool } from '../../compute/client/pool.ts';
import type { SweepClient } from '../../compute/client/sweepClient.ts';
import type { Reduced } from '../../core/sweep/reduceRun.ts';
import { readonly } from '../state/signals.ts';

/** What is run and what is measured of it. */
export interface SweepPlan {
  title: string;
  file: ScenarioFile;
  /** One or two; the first varies fastest. */
  axes: readonly SweepAxis[];
  measures: readonly SweepMeasure[];
  /** The form it was asked for with, as the form wants it. */
  form?: unknown;
}

/** One run of a sweep: its numbers in the order of the measures, NaN where it has none. */
export interface SweepResult {
  values: readonly number[];
  /** A permanent id as in `RunEnd`, or `refused`. */
  reason: string;
  message: string;
}

/** Signals are renewed this often at most, however fast results come. */
const TELL_MS = 200;

/** Computes a sweep in workers of its own; what has come so far is there at any time. */
export class Sweep {
  private readonly ownPlan = signal<SweepPlan | null>(null);
  private readonly ownVersion = signal(0);
  private readonly ownState = signal<'empty' | 'computing' | 'ended' | 'cancelled'>('empty');
  readonly plan = readonly(this.ownPlan);
  /** By place in the plan; read anew when `version` rises. */
  readonly results: (SweepResult | undefined)[] = [];
  readonly version = readonly(this.ownVersion);
  readonly state = readonly(this.ownState);
  /** Runs done, with the shares of those under way. */
  progress = 0;
  /** Runs done. */
  done = 0;
  private readonly pool: Pool<SweepClient>;
  private shares = new Float64Array(0);
  private timer: ReturnType<typeof setTimeout> | null = null;

  constructor(pool: Pool<SweepClient>) {
    this.pool = pool;
  }

  get cores(): number {
    return this.pool.size;
  }

  get total(): number {
    return runsOf(this.plan.peek());
  }

  /** @throws Error when there are too many runs, with words for the form */
  start(plan: SweepPlan): void {
    const total = runsOf(plan);
    if (total > MOST_SWEEP_RUNS)
      throw new Error(`${total} runs are more than the ${MOST_SWEEP_RUNS} of a sweep; take fewer values`);
    this.shares = new Float64Array(total);
    this.results.length = 0;
    this.results.length = total;
    this.done = this.progress = 0;
    this.ownPlan.value = plan;
    this.ownState.value = 'computing';
    this.tell();
    this.pool.start(
      total,
      (lane, job, over) => {
        const request = { file: written(scenarioAt(plan, job), systemMetas), measures: plan.measures };
        void lane
          .measure(request, (share) => this.reach(job, share))
          .then((answer) => {
            if (!answer) return;
            this.record(plan, job, answer);
            over();
          });
      },
      () => this.finish('ended'),
    );
  }

  /** Puts back what was computed before; a sweep that was cut off is a cancelled one. */
  restore({ plan, results }: { plan: SweepPlan; results: readonly (SweepResult | undefined)[] }): void {
    const total = runsOf(plan);
    this.results.length = 0;
    this.results.push(...results.slice(0, total));
    this.results.length = total;
    this.done = this.progress = this.results.filter(Boolean).length;
    this.ownPlan.value = plan;
    this.finish(this.done === total ? 'ended' : 'cancelled');
  }

  /** What was computed stays. */
  cancel(): void {
    if (this.state.peek() !== 'computing') return;
    this.pool.stop();
    this.finish('cancelled');
  }

  private record({ measures }: SweepPlan, job: number, answer: Answer<Reduced>): void {
    this.done++;
    this.results[job] = answer.ok
      ? { values: answer.value.values, reason: answer.value.end.reason, message: answer.value.end.message }
      : { values: measures.map(() => NaN), reason: 'refused', message: answer.message };
    this.reach(job, 1);
  }

  private reach(job: number, share: number): void {
    const reached = Math.min(1, Math.max(0, share));
    this.progress += reached - this.shares[job]!;
    this.shares[job] = reached;
    this.tell();
  }

  private finish(state: 'ended' | 'cancelled'): void {
    this.ownState.value = state;
    this.tell();
  }

  private tell(): void {
    this.timer ??= setTimeout(() => {
      this.timer = null;
      this.ownVersion.value++;
    }, TELL_MS);
  }
}

export const runsOf = (plan: Pick<SweepPlan, 'axes'> | null): number =>
  plan ? plan.axes.reduce((product, { values }) => product * values.length, 1) : 0;

/** Its place on each axis. */
export function placesOf({ axes }: Pick<SweepPlan, 'axes'>, job: number): number[] {
  let rest = job;
  return axes.map(({ values }) => {
    const place = rest % values.length;
    rest = (rest - place) / values.length;
    return place;
  });
}

export function valuesAt(plan: Pick<SweepPlan, 'axes'>, job: number): SweepValue[] {
  return placesOf(plan, job).map((place, a) => plan.axes[a]!.values[place]!);
}

/** The scenario of one run, ready for the panel. */
export function scenarioAt(plan: SweepPlan, job: number): ScenarioFile {
  return valuesAt(plan, job).reduce((file, value, a) => withAxisValue(file, plan.axes[a]!, value), plan.file);
}
