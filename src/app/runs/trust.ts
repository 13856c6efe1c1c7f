/** How far the run on the stage can be trusted: it is computed again beside the page while the person only watches. */
import { effect, signal, type ReadonlySignal } from '@preact/signals';
import type { RunClient } from '../../compute/client/runClient.ts';
import type { ScenarioFile } from '../../core/scenario/types.ts';
import type { Trust } from '../../core/simulation/trust.ts';
import { readonly } from '../state/signals.ts';
import { RETUNED } from './onward.ts';
import type { Motion, RunState, RunStatistics } from './motion.ts';
import type { StageState } from './stageState.ts';

/** What is known of the run on the stage. */
export type RunTrust =
  /** Being compared; `share` of the run so far. */
  | { kind: 'comparing'; share: number; trust: Trust | null }
  /** Compared, as far as `trust.compared`. */
  | { kind: 'compared'; trust: Trust }
  /** So long that it is compared only when asked to. */
  | { kind: 'asks' };

export interface TrustState {
  /** Null where there is nothing to say: no run, one that goes on from another or was pushed. */
  trust: ReadonlySignal<RunTrust | null>;
}

/** The page has its quiet for so long after a run or an edit, ms. */
const QUIET_MS = 700;
/** A run of more evaluations than this (some seconds) is compared when asked to. */
const MOST_UNASKED = 300_000;

/** Rows that the second run may have beyond the end of the first. */
const MORE_ROWS = 2;

export interface TrustContext {
  stage: StageState;
  draft: ReadonlySignal<ScenarioFile>;
  client: RunClient;
}

export class TrustKeeper {
  private readonly known = signal<RunTrust | null>(null);
  readonly state: TrustState = { trust: readonly(this.known) };
  private readonly context: TrustContext;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private motion: Motion | null = null;

  constructor(context: TrustContext) {
    this.context = context;
    const { stage, draft } = context;
    let run: RunState | null = null;
    effect(() => {
      const motion = stage.motion.value;
      void draft.value;
      const same = motion?.id === this.motion?.id && stage.run.value === run;
      run = stage.run.value;
      this.motion = motion;
      this.look(motion, run, stage.statistics.peek(), same);
    });
  }

  /** Compares a long run too. */
  compare(): void {
    const { motion } = this;
    const run = this.context.stage.run.peek();
    if (motion && run?.kind === 'ended' && comparable(motion)) void this.begin(motion, run);
  }

  /** The run, or the draft beside it, changed: what was compared stays, what is under way gives way and begins anew. */
  private look(motion: Motion | null, run: RunState | null, statistics: RunStatistics | null, same: boolean): void {
    const { known, context } = this;
    if (same && known.peek()?.kind !== 'comparing') return;
    clearTimeout(this.timer);
    context.client.abandon();
    known.value = null;
    if (!motion || run?.kind !== 'ended' || !comparable(motion)) return;
    if ((statistics?.evaluations ?? 0) > MOST_UNASKED) known.value = { kind: 'asks' };
    else {
      known.value = { kind: 'comparing', share: 0, trust: null };
      this.timer = setTimeout(() => void this.begin(motion, run), QUIET_MS);
    }
  }

  private async begin(motion: Motion, run: Extract<RunState, { kind: 'ended' }>): Promise<void> {
    const { known, context } = this;
    known.value = { kind: 'comparing', share: 0, trust: null };
    const asked = known.peek();
    const parts = await import('../../core/simulation/trust.ts').catch(() => null);
    // Meanwhile another run, or another draft, may have taken its place.
    if (known.peek() !== asked) return;
    if (!parts) {
      known.value = { kind: 'asks' };
      return;
    }
    const { DigitsMeter, secondScenario } = parts;
    const scenario = motion.scenario!;
    // A little longer than the first run came: an event of the second may be later.
    const duration = Math.min(scenario.duration, run.time + MORE_ROWS * scenario.outputStep);
    const second = secondScenario({ ...scenario, duration });
    const { trajectory, system } = motion;
    const meter = new DigitsMeter(system.meta, second.method);
    const names = trajectory.columns.slice(0, 1 + 2 * system.meta.coordinates.length);
    const first = names.map((name) => trajectory.column(name)!);
    let rows = 0;
    const take = (columns: readonly Float64Array[], count: number): void => {
      // No more of the first run than the second has, but for the row that an event ended it at.
      meter.take(
        'first',
        first.map((column) => column.subarray(rows, rows + count)),
        Math.min(count, Math.max(trajectory.length - rows, 0)),
      );
      meter.take('second', columns, count);
      rows += count;
    };
    const over = (reason: string): void => {
      if (rows < trajectory.length)
        meter.take(
          'first',
          first.map((column) => column.subarray(rows, rows + 1)),
          1,
        );
      const trust = meter.finish(run, { reason });
      known.value = trust.digits.length > 1 ? { kind: 'compared', trust } : null;
    };
    context.client.start(second, {
      started: () => {},
      rows: (columns, count) => {
        take(columns, count);
        known.value = { kind: 'comparing', share: meter.compared / run.time, trust: meter.trust };
      },
      ended: ({ reason }) => over(reason),
      refused: () => over('failed'),
    });
  }
}

/** A run from its start, of a scenario alone, all rows of which are kept. */
function comparable({ source, scenario, marks, pushes, trajectory }: Motion): boolean {
  return (
    source === 'run' &&
    scenario !== null &&
    (pushes ?? []).length === 0 &&
    !marks.some(({ name }) => name === RETUNED) &&
    trajectory.length > 1 &&
    trajectory.column('t')![1]! <= scenario.outputStep * (1 + 1e-9)
  );
}
