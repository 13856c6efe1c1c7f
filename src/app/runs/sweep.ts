import { signal, type Signal } from '@preact/signals';
import { MOST_SWEEP_RUNS, withAxisValue, type SweepAxis, type SweepValue } from '../../core/scenario/sweepAxes.ts';
import type { SweepMeasure } from '../../core/motion/sweepMeasures.ts';
import type { ScenarioFile } from '../../core/scenario/types.ts';
import type { SweepReply, SweepRequest } from '../../compute/sweepProtocol.ts';
import { Pool, type Lane } from '../../compute/pool.ts';

/** What is run and what is kept of it. */
export interface SweepPlan {
  title: string;
  file: ScenarioFile;
  /** One or two; the first varies fastest. */
  axes: readonly SweepAxis[];
  measures: readonly SweepMeasure[];
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

/** Computes a sweep aside, a worker a core but one; what has come so far is there at any time. */
export class Sweep {
  readonly plan: Signal<SweepPlan | null> = signal(null);
  /** By place in the plan; read anew when `version` rises. */
  readonly results: (SweepResult | undefined)[] = [];
  readonly version = signal(0);
  readonly state: Signal<'empty' | 'computing' | 'ended' | 'cancelled'> = signal('empty');
  /** Runs done, with the shares of those under way. */
  progress = 0;
  /** Runs done. */
  done = 0;
  private readonly pool: Pool<SweepLane>;
  private timer: ReturnType<typeof setTimeout> | null = null;

  constructor(create: () => Worker, cores: number) {
    this.pool = new Pool(() => new SweepLane(create), cores);
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
    const shares = new Float64Array(total);
    this.results.length = 0;
    this.results.length = total;
    this.done = this.progress = 0;
    this.plan.value = plan;
    this.state.value = 'computing';
    this.tell();
    this.pool.start(
      total,
      (lane, job, over) =>
        lane.compute({ job, file: scenarioAt(plan, job), measures: plan.measures }, (reply) => {
          const share = reply.type === 'progress' ? Math.min(1, Math.max(0, reply.share)) : 1;
          this.progress += share - shares[job]!;
          shares[job] = share;
          if (reply.type === 'progress') return this.tell();
          this.done++;
          this.results[job] =
            reply.type === 'measured'
              ? { values: reply.values, reason: reply.end.reason, message: reply.end.message }
              : { values: plan.measures.map(() => NaN), reason: 'refused', message: reply.message };
          this.tell();
          over();
        }),
      () => this.finish('ended'),
    );
  }

  /** What was computed stays. */
  cancel(): void {
    if (this.state.peek() !== 'computing') return;
    this.pool.stop();
    this.finish('cancelled');
  }

  private finish(state: 'ended' | 'cancelled'): void {
    this.state.value = state;
    this.tell();
  }

  private tell(): void {
    this.timer ??= setTimeout(() => {
      this.timer = null;
      this.version.value++;
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

/** A worker that measures one run at a time. */
class SweepLane implements Lane {
  private readonly create: () => Worker;
  private worker: Worker | null = null;
  private hear: ((reply: SweepReply) => void) | null = null;

  constructor(create: () => Worker) {
    this.create = create;
  }

  compute(request: SweepRequest, hear: (reply: SweepReply) => void): void {
    this.worker ??= this.open();
    this.hear = (reply) => {
      if (reply.job === request.job) hear(reply);
    };
    this.worker.onerror = (event) => {
      // A worker that died takes its run with it; the next run gets a new one.
      this.worker?.terminate();
      this.worker = null;
      hear({
        type: 'refused',
        job: request.job,
        path: '',
        message: `the computation stopped unexpectedly${event.message ? ` (${event.message})` : ''}`,
      });
    };
    this.worker.postMessage(request);
  }

  close(): void {
    this.hear = null;
    this.worker?.terminate();
    this.worker = null;
  }

  private open(): Worker {
    const worker = this.create();
    worker.onmessage = ({ data }: MessageEvent<SweepReply>) => this.hear?.(data);
    return worker;
  }
}
