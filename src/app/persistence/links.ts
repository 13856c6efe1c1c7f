/** Links to what is in the panel, made and opened. Loaded when a link is asked for or opened with. */
import { effect } from '@preact/signals';
import { decodeLink, encodeLink, LinkError, type LinkContent, type OpenedLink } from '../../core/scenario/link.ts';
import { difference } from '../../core/scenario/patch.ts';
import type { SystemMeta } from '../../core/model/system.ts';
import { shareText as text } from '../words.ts';
import type { Keeper } from './autosave.ts';
import { isView, workOf, type Work } from './savedWork.ts';
import { isPlain, plotsFrom } from '../state/plotPanes.ts';
import type { App, CaseInfo } from '../types.ts';

type Metas = Readonly<Record<string, SystemMeta>>;

/**
 * The text after `#` for what is in the panel; the playback time with it when it stands still on the way.
 * @throws LinkError when the draft can't run or does not fit into a link
 */
export function linkOf(app: App): string {
  const { state } = app;
  for (const [path, message] of state.draftErrors.peek()) throw new LinkError(path, message);
  const plots = state.plots.peek();
  const origin = state.origin.peek();
  const [tool, time] = [state.tool.peek(), state.time.peek()];
  const [view, motion] = [state.view.peek(), state.motion.peek()];
  const content: LinkContent = {
    caseId: origin.id || null,
    title: origin.title,
    scenario: state.draft.peek(),
    ...(tool === null ? {} : { tool }),
    ...(view === 'orbit' ? {} : { view }),
    ...(!state.playing.peek() && time > 0 && motion?.source === 'run' && time < motion.trajectory.end
      ? { time: Math.round(time * 1e6) / 1e6 }
      : {}),
    ...(isPlain(plots) ? {} : { plots }),
  };
  return encodeLink(content, app);
}

/** Opens the address's link; a bad one is told and leaves everything as it is. Says whether it opened. */
export function openLink(
  app: App,
  keeper: Keeper,
  systems: Metas,
  toolIds: readonly string[],
  before: Work | null,
): boolean {
  let link: OpenedLink;
  try {
    link = decodeLink(location.hash, { systems, cases: app.cases });
  } catch (error) {
    if (!(error instanceof LinkError)) throw error;
    app.actions.report('error', text.bad, [error.message, text.badHint]);
    clearAddress();
    return false;
  }
  const found = app.cases.find((c) => c.id === link.caseId);
  const origin: CaseInfo = found ?? {
    id: '',
    title: link.title ?? app.systemOf(link.scenario.system)!.meta.title,
    summary: '',
    scenario: link.scenario,
  };
  const same = difference({ ...origin.scenario }, { ...link.scenario }).length === 0;
  const shown = app.state.motion.peek();
  app.actions.openScenario(origin, same ? origin.scenario : link.scenario, link.time === undefined);
  look(app, link, toolIds);
  if (link.time !== undefined) seekWhenThere(app, link.time, shown);
  tell(app, keeper, link, origin, toolIds, before);
  return true;
}

/** What a link came on top of. */
export const workBefore = (app: App): Work => workOf(app.state);

function look({ state }: App, { tool, view, plots }: OpenedLink, toolIds: readonly string[]): void {
  if (tool !== undefined && toolIds.includes(tool)) state.tool.value = tool;
  state.view.value = isView(view) ? view : 'orbit';
  const shown = plotsFrom(plots);
  if (shown) state.plots.value = shown;
}

function tell(
  app: App,
  keeper: Keeper,
  { tool, altered }: OpenedLink,
  origin: CaseInfo,
  toolIds: readonly string[],
  before: Work | null,
): void {
  const remarks = [
    ...(altered ? [text.altered] : []),
    ...(tool !== undefined && !toolIds.includes(tool) ? [text.unknownTool(tool)] : []),
  ];
  const kind = altered ? 'warning' : 'info';
  if (!before) {
    app.actions.report(kind, text.opened(origin.title), [text.openedFresh, ...remarks]);
    return;
  }
  keeper.showOnly(before, clearAddress);
  app.actions.report(kind, text.opened(origin.title), [text.openedHint, ...remarks], {
    label: text.back,
    run: () => void keeper.putBack(before),
  });
}

/** What is edited is no longer what the address says: a reload then brings back the edits. */
function clearAddress(): void {
  history.replaceState(history.state, '', location.pathname + location.search);
}

/** Goes to a time as soon as the run has come so far. */
function seekWhenThere({ state, actions }: App, time: number, before: unknown): void {
  let stop = (): void => {};
  let done = false;
  stop = effect(() => {
    void state.rowsVersion.value;
    const [motion, run] = [state.motion.value, state.run.value];
    if (done || !motion || motion === before || (motion.trajectory.end < time && run?.kind === 'computing')) return;
    done = true;
    queueMicrotask(() => {
      stop();
      actions.seek(time);
    });
  });
}
