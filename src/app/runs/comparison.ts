import { systemViews } from '../../core/systems/registry.ts';
import { signal, type ReadonlySignal } from '@preact/signals';
import { checkScenario } from '../../core/scenario/schema.ts';
import type { MethodOptions, Scenario, ScenarioFile } from '../../core/scenario/types.ts';
import type { RunCounts } from '../../core/simulation/simulation.ts';
import type { SystemMeta } from '../../core/model/system.ts';
import { Trajectory } from '../../core/motion/trajectory.ts';
import type { Pool } from '../../compute/client/pool.ts';
import type { RunClient } from '../../compute/client/runClient.ts';
import { readonly } from '../state/signals.ts';

/** One method in a comparison: a scenario's `method` with a name of its own. */
export interface Contender {
  id: string;
  label: string;
  method: Partial<MethodOptions>;
  outputStep?: number;
}

export interface Outcome {
  contender: Contender;
  state: 'waiting' | 'computing' | 'ended' | 'refused';
  /** Time spent computing, without waiting, s. */
  seconds: number;
  /** Output reached, s. */
  reached: number;
  counts: RunCounts | null;
  /** Why it ended, or why it could not begin. */
  reason: string;
  message: string;
  trajectory: Trajectory | null;
}

/** Numbers held of all methods together (192 MB): beyond them rows are thinned. */
const MOST_COMPARED = 24e6;

/** Runs one scenario with several methods, each in a worker of its own, as many at a time as there are cores. */
export class Comparison {
  private readonly list = signal<readonly Outcome[]>([]);
  private readonly rowsVersion = signal(0);
  readonly outcomes: ReadonlySignal<readonly Outcome[]> = readonly(this.list);
  /** Rises when trajectories grow: plots look again. */
  readonly version: ReadonlySignal<number> = readonly(this.rowsVersion);
  private readonly pool: Pool<RunClient>;

  constructor(pool: Pool<RunClient>) {
    this.pool = pool;
  }

  get busy(): boolean {
    return this.outcomes.value.some((o) => o.state === 'waiting' || o.state === 'computing');
  }

  /** @throws ScenarioError when the scenario itself can't run; a method that can't is told in its own row */
  start(file: ScenarioFile, contenders: readonly Contender[], metas: Readonly<Record<string, SystemMeta>>): void {
    this.stop();
    checkScenario({ ...file, method: {} }, metas);
    this.list.value = contenders.map((contender) => ({
      contender,
      state: 'waiting',
      seconds: 0,
      reached: 0,
      counts: null,
      reason: '',
      message: '',
      trajectory: null,
    }));
    this.pool.start(contenders.length, (client, index, done) => this.compute(client, index, file, metas, done));
  }

  /** Ends what is under way; what was computed stays. */
  stop(): void {
    this.pool.stop();
    this.list.value = this.outcomes
      .peek()
      .map((o) =>
        o.state === 'waiting' || o.state === 'computing'
          ? { ...o, state: 'ended', reason: 'cancelled', message: 'cancelled' }
          : o,
      );
  }

  /** Ends what is under way and forgets what was computed. */
  clear(): void {
    this.stop();
    this.list.value = [];
  }

  private compute(
    client: RunClient,
    index: number,
    file: ScenarioFile,
    metas: Readonly<Record<string, SystemMeta>>,
    done: () => void,
  ): void {
    const { contender } = this.outcomes.peek()[index]!;
    let scenario: Scenario;
    try {
      const { method, outputStep } = contender;
      scenario = checkScenario({ ...file, method, ...(outputStep === undefined ? {} : { outputStep }) }, metas);
    } catch (error) {
      this.update(index, { state: 'refused', message: (error as Error).message });
      done();
      return;
    }
    let trajectory: Trajectory | null = null;
    client.start(scenario, {
      started: (columns) => {
        trajectory = new Trajectory(
          columns,
          1024,
          Math.floor(MOST_COMPARED / (columns.length * this.outcomes.peek().length)),
        );
        trajectory.straight = systemViews[scenario.system]?.drawnAlong !== undefined;
        this.update(index, { state: 'computing', trajectory });
      },
      rows: (columns, rows, time, counts, seconds) => {
        trajectory!.append(columns, rows);
        this.rowsVersion.value++;
        this.update(index, { reached: time, counts, seconds });
      },
      ended: (end, counts, seconds) => {
        this.update(index, {
          state: 'ended',
          reached: end.time,
          reason: end.reason,
          message: end.message,
          counts,
          seconds,
        });
        done();
      },
      refused: (_path, message) => {
        this.update(index, { state: 'refused', message });
        done();
      },
    });
  }

  private update(index: number, change: Partial<Outcome>): void {
    this.list.value = this.outcomes.peek().map((o, i) => (i === index ? { ...o, ...change } : o));
  }
}
