/** Pinned runs and the last sweep survive a reload, in IndexedDB. */
import { effect } from '@preact/signals';
import type { SystemView } from '../../core/model/system.ts';
import type { App } from '../app.ts';
import { text } from '../words.ts';
import type { BrowserStorage } from './browserStorage.ts';
import { written } from '../../core/scenario/own.ts';
import { learnSystemOf, systemMetas } from '../../core/systems/registry.ts';
import { LARGEST_SAVED_RUNS, runsFrom, storedRuns, sweepFrom, type StoredRun, type StoredSweep } from './savedRuns.ts';

/** Names in the browser's storage: permanent. */
const RUNS = 'pinned';
const SWEEP = 'sweep';
/** Writing waits for this long (ms): names are typed, results come fast. */
const CALM = 400;
const CALM_SWEEP = 2000;

type Views = Readonly<Record<string, SystemView>>;

/** Puts back what was stored, then stores every change. */
export async function keepRuns(app: App, storage: BrowserStorage, views: Views): Promise<void> {
  const [runs, sweep] = await Promise.all([storage.large(RUNS), storage.large(SWEEP)]);
  const scenarios = [
    ...(Array.isArray(runs) ? (runs as StoredRun[]).map((run) => run?.motion?.written) : []),
    (sweep as StoredSweep | undefined)?.plan?.file,
  ];
  // A description that can't be read leaves out what was run with it.
  for (const scenario of scenarios) await learnSystemOf(scenario).catch(() => {});
  app.pinned.restore(runsFrom(runs, views));
  try {
    const metas = Object.fromEntries(Object.entries(views).map(([id, { meta }]) => [id, meta]));
    if (sweep !== undefined && app.sweep.state.peek() === 'empty') app.sweep.restore(sweepFrom(sweep, metas));
  } catch {
    // Another version's, or another hand's: the next sweep takes its place.
  }
  watchRuns(app, storage);
  watchSweep(app, storage);
}

function watchRuns({ pinned, actions }: App, storage: BrowserStorage): void {
  let timer: ReturnType<typeof setTimeout> | undefined;
  let known = pinned.runs.peek();
  const said = new Set<string>();
  const write = (): void => {
    const { stored, left } = storedRuns(pinned.runs.peek());
    for (const name of left.filter((one) => !said.has(one))) {
      said.add(name);
      actions.report('info', text.runLarge(name), [text.runLargeHint(LARGEST_SAVED_RUNS / 1e6)]);
    }
    void storage.putLarge(RUNS, stored.length > 0 ? stored : null);
  };
  effect(() => {
    if (pinned.runs.value === known) return;
    known = pinned.runs.value;
    clearTimeout(timer);
    timer = setTimeout(write, CALM);
  });
}

function watchSweep({ sweep }: App, storage: BrowserStorage): void {
  let timer: ReturnType<typeof setTimeout> | null = null;
  let known = sweep.plan.peek();
  const write = (): void => {
    timer = null;
    const plan = sweep.plan.peek();
    void storage.putLarge(
      SWEEP,
      plan && { plan: { ...plan, file: written(plan.file, systemMetas) }, results: [...sweep.results] },
    );
  };
  effect(() => {
    void sweep.version.value;
    const ended = sweep.state.value !== 'computing';
    if (sweep.plan.value === known && ended) return;
    if (ended) known = sweep.plan.value;
    if (ended && timer) clearTimeout(timer);
    if (ended) timer = setTimeout(write);
    else timer ??= setTimeout(write, CALM_SWEEP);
  });
}
