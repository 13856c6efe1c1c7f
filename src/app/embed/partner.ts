/**
 * The page around this one speaks to it: `docs/embedding.md` has the words. Only messages of the window around this one, of
 * the origin that the address names, are heard, and answers go to that origin alone.
 */
import { effect } from '@preact/signals';
import { columnOf } from '../../core/motion/columns.ts';
import { TURN } from '../../core/motion/interpolation.ts';
import { valueAt } from '../../core/motion/resample.ts';
import { written } from '../../core/scenario/own.ts';
import { parseScenario } from '../../core/scenario/schema.ts';
import { withValue } from '../../core/scenario/sweepAxes.ts';
import { systemMetas } from '../../core/systems/registry.ts';
import type { App } from '../app.ts';
import { scenarioIn } from '../files/scenarioText.ts';
import type { EmbeddedPlots } from './plots.ts';

/** Of the words, not of the program: a word is added without a new number, none is changed or taken away. */
export const PROTOCOL = 1;

/** What the page around may say; `id` comes back with the answer. */
type Asked = { ripstik: number; id?: unknown; type?: unknown } & Record<string, unknown>;

/** Of the window, what is used: tests have their own. */
export interface Surroundings {
  /** The page around this one; this window itself where there is none. */
  parent: Pick<Window, 'postMessage'>;
  addEventListener(type: 'message', hear: (event: MessageEvent<unknown>) => void): void;
}

const text = {
  unknown: (type: unknown) =>
    `type ${JSON.stringify(type)} is not known; right would be load, set, run, cancel, play, pause, seek, plots or state`,
  nothing: 'load needs a case, a scenario or a csv',
  noCase: (id: unknown, ids: string) => `there is no case ${JSON.stringify(id)}; right would be one of ${ids}`,
  path: 'set needs a path such as "initial.alpha" and a value: a number in SI units, or an expression as text',
  time: 'seek needs a time, a number of seconds',
  open: (question: string) => `the table leaves something open: ${question} Say it in the file`,
  unread: 'the table was not read to its end',
  stale: 'the scenario in the panel has a mistake; set or load another',
};

/**
 * Answers the page around this one, from now on.
 *
 * @param app whose stage it is
 * @param plots beside it
 * @param partner origin that may speak; `*` where the page around wrote this one itself
 * @param version of the program
 * @param around the window
 */
export function speakWith(
  app: App,
  plots: EmbeddedPlots,
  partner: string,
  version: string,
  around: Surroundings,
): void {
  const say = (message: object): void => around.parent.postMessage({ ripstik: PROTOCOL, ...message }, partner);
  const tellEnd = (): void => {
    const run = app.state.run.peek();
    if (run?.kind === 'ended') say({ type: 'ended', reason: run.reason, message: run.message, time: run.time });
  };
  around.addEventListener('message', ({ source, origin, data }) => {
    if (source !== around.parent || (partner !== '*' && origin !== partner) || !isAsked(data)) return;
    const { id } = data;
    void answer(app, plots, data).then(
      () => {
        say({ type: 'state', id, ...stateOf(app) });
        // What followed the last change by itself may be this run already: its end was told before it was asked for.
        if (data.type === 'run') tellEnd();
      },
      (error: unknown) => say({ type: 'error', id, message: error instanceof Error ? error.message : String(error) }),
    );
  });
  effect(() => {
    void app.state.run.value;
    tellEnd();
  });
  say({ type: 'ready', version });
}

const isAsked = (data: unknown): data is Asked =>
  typeof data === 'object' && data !== null && (data as Asked).ripstik === PROTOCOL;

async function answer(app: App, plots: EmbeddedPlots, asked: Asked): Promise<void> {
  const { actions, state } = app;
  switch (asked.type) {
    case 'load':
      return load(app, asked);
    case 'set':
      return set(app, asked['path'], asked['value']);
    case 'run':
      if (state.draftErrors.peek().size > 0) throw new Error(text.stale);
      return actions.run();
    case 'cancel':
      return actions.cancel();
    case 'play':
      return actions.play();
    case 'pause':
      return actions.pause();
    case 'seek':
      if (typeof asked['time'] !== 'number' || !Number.isFinite(asked['time'])) throw new Error(text.time);
      return actions.seek(asked['time']);
    case 'plots':
      return plots.ask(asked['panes']);
    case 'state':
      return;
    default:
      throw new Error(text.unknown(asked.type));
  }
}

async function load(app: App, asked: Asked): Promise<void> {
  const { case: id, scenario, csv, title } = asked as Record<string, unknown>;
  const name = typeof title === 'string' ? title.slice(0, 200) : 'scenario';
  if (typeof id === 'string') {
    if (!app.cases.some((one) => one.id === id))
      throw new Error(text.noCase(id, app.cases.map((one) => one.id).join(', ')));
    return app.actions.loadCase(id);
  }
  if (typeof csv === 'string') {
    return loadTable(app, typeof title === 'string' ? name : 'motion.csv', csv);
  }
  if (typeof scenario !== 'object' || scenario === null) throw new Error(text.nothing);
  app.actions.loadScenario(await scenarioIn(JSON.stringify(scenario), systemMetas), name);
}

/** What the page tells of a table that it can't use is the answer; no one here can be asked what it leaves open. */
async function loadTable({ state, actions }: App, name: string, csv: string): Promise<void> {
  const [shown, told] = [state.motion.peek(), state.messages.peek().at(-1)?.id];
  await actions.openFile(name, new Blob([csv]));
  const pending = state.pendingFile.peek();
  if (pending) actions.answerPending(null);
  if (state.motion.peek() !== shown) return;
  const last = state.messages.peek().at(-1);
  throw new Error(
    pending
      ? text.open(pending.question.text)
      : last && last.id !== told
        ? last.details.slice(0, -1).join('; ')
        : text.unread,
  );
}

/** One number or expression; what the scenario refuses leaves it as it was. */
function set({ state, actions }: App, path: unknown, value: unknown): void {
  if (typeof path !== 'string' || !(typeof value === 'number' || typeof value === 'string')) throw new Error(text.path);
  const before = state.draft.peek();
  const after = withValue(before, path, value);
  parseScenario(JSON.stringify(written(after, systemMetas)), systemMetas);
  actions.edit(path, () => after);
}

/** What is on the stage, as plain data. */
export function stateOf({ state }: App): object {
  const motion = state.motion.peek();
  const run = state.run.peek();
  const [time, trajectory] = [state.time.peek(), motion?.trajectory];
  const values: Record<string, number | null> = {};
  if (motion && trajectory && trajectory.length > 0) {
    for (const column of trajectory.columns) {
      const turns = trajectory.recorded && columnOf(motion.system.meta, column).turns;
      const value = valueAt(trajectory, column, time, turns ? TURN : 0);
      values[column] = value !== null && Number.isFinite(value) ? value : null;
    }
  }
  return {
    title: motion?.title ?? null,
    system: motion?.system.meta.id ?? null,
    source: motion?.source ?? null,
    run: run === null ? null : run.kind === 'computing' ? { kind: run.kind } : { ...run },
    time,
    end: trajectory?.length ? trajectory.end : null,
    playing: state.playing.peek(),
    scenario: written(state.draft.peek(), systemMetas),
    values,
  };
}
