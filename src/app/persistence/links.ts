/** Links to what is in the panel, made and opened. Loaded when a link is asked for or opened with. */
import { effect } from '@preact/signals';
import {
  decodeLink,
  descriptionInLink,
  encodeLink,
  LinkError,
  type LinkContent,
  type OpenedLink,
} from '../../core/scenario/link.ts';
import { ScenarioError } from '../../core/scenario/types.ts';
import { learnSystem, systemMetas } from '../../core/systems/registry.ts';
import { difference } from '../../core/scenario/patch.ts';
import type { SystemMeta } from '../../core/model/system.ts';
import { shareText as text } from './linkWords.ts';
import type { App } from '../app.ts';
import { ownCase, type CaseInfo } from '../state/cases.ts';
import { settingValues } from '../state/settings.ts';
import type { Autosave } from './autosave.ts';
import type { Work } from './savedWork.ts';
import { fromLink, toLink } from './settingsCodec.ts';

type Metas = Readonly<Record<string, SystemMeta>>;

/**
 * The text after `#` for what is in the panel; the playback time with it when it stands still on the way.
 * @throws LinkError when the draft can't run or does not fit into a link
 */
export function linkOf(app: App): string {
  const { state } = app;
  for (const [path, message] of state.draftErrors.peek()) throw new LinkError(path, message);
  const origin = state.origin.peek();
  const [time, motion] = [state.time.peek(), state.motion.peek()];
  const content: LinkContent = {
    caseId: origin.id || null,
    ...(app.cases.some(({ id, title }) => id === origin.id && title === origin.title) ? {} : { title: origin.title }),
    scenario: state.draft.peek(),
    ...toLink(settingValues(state)),
    ...(!state.playing.peek() && time > 0 && motion?.source === 'run' && time < motion.trajectory.end
      ? { time: Math.round(time * 1e6) / 1e6 }
      : {}),
  };
  return encodeLink(content, { cases: app.cases, systems: systemMetas });
}

/** Opens the address's link; a bad one is told and leaves everything as it is. Says whether it opened. */
export async function openLink(
  app: App,
  autosave: Autosave,
  systems: Metas,
  toolIds: readonly string[],
  before: Work | null,
): Promise<boolean> {
  if (location.hash.startsWith('#lesson=')) {
    await openLessonLink(app, location.hash);
    return false;
  }
  let link: OpenedLink;
  try {
    const description = descriptionInLink(location.hash);
    if (description !== null) await learnSystem(description);
    link = decodeLink(location.hash, { systems, cases: app.cases });
  } catch (error) {
    if (!(error instanceof LinkError || error instanceof ScenarioError)) throw error;
    app.actions.report('error', text.bad, [error.message, text.badHint]);
    clearAddress();
    return false;
  }
  const found = app.cases.find((c) => c.id === link.caseId);
  const origin = found
    ? link.title === undefined
      ? found
      : { ...found, title: link.title }
    : ownCase(link.title ?? app.systemOf(link.scenario.system)!.meta.title, link.scenario);
  const same = difference({ ...origin.scenario }, { ...link.scenario }).length === 0;
  const shown = app.state.motion.peek();
  app.actions.openScenario(origin, same ? origin.scenario : link.scenario, link.time === undefined);
  app.actions.setAll(fromLink(link, { toolIds }));
  if (link.time !== undefined) seekWhenThere(app, link.time, shown);
  tell(app, autosave, link, origin, toolIds, before);
  return true;
}

/**
 * Opens the lesson of the address beside the work there is; a broken one is told.
 *
 * @param app that shows it
 * @param hash of the address
 */
export async function openLessonLink({ actions }: App, hash: string): Promise<void> {
  const { lessonInAddress } = await import('../files/ownLesson.ts');
  try {
    const lesson = lessonInAddress(hash);
    if (!lesson) throw new Error(text.noLesson);
    actions.setLesson(lesson);
    actions.set('tool', 'lessons');
  } catch (error) {
    actions.report('error', text.badLesson, [error instanceof Error ? error.message : String(error)]);
  }
}

function tell(
  app: App,
  autosave: Autosave,
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
    app.actions.report(kind, text.opened(origin.title), [text.openedFresh, ...remarks], undefined, 'opened');
    return;
  }
  autosave.suspend(before, clearAddress);
  const back = { label: text.back, run: () => void autosave.restoreWork(before) };
  app.actions.report(kind, text.opened(origin.title), [text.openedHint, ...remarks], back, 'opened');
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
