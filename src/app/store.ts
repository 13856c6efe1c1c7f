import { batch, computed, effect, signal } from '@preact/signals';
import { cases, systemViews } from '../core/systems/registry.ts';
import { collectScenarioErrors } from '../core/scenario/schema.ts';
import { ScenarioError, type ScenarioFile } from '../core/scenario/types.ts';
import type { Comparison } from './runs/comparison.ts';
import type { Compute } from '../compute/client/compute.ts';
import { CsvExport } from './files/csvExport.ts';
import { download } from './files/download.ts';
import { FileOpener } from './files/fileOpener.ts';
import { Kept } from './runs/pinnedRuns.ts';
import { initialLook } from './state/viewSettings.ts';
import { Messages } from './state/messages.ts';
import { ModeStage } from './runs/modePreview.ts';
import { runPlaybackClock, speeds } from './state/playbackClock.ts';
import { Runs } from './runs/runs.ts';
import { samples } from './files/samples.ts';
import type { Sweep } from './runs/sweep.ts';
import type { App, AppActions, AppState, CaseInfo } from './types.ts';

export const systemMetas = Object.fromEntries(Object.entries(systemViews).map(([id, view]) => [id, view.meta]));

/** What the person's system asks of every page. */
export interface Preferences {
  dark: boolean;
  reducedMotion: boolean;
  /** Room for a tool beside the scene from the start. */
  roomy: boolean;
}

/** The application: state as signals, and the only code that changes it. */
export function createApp(compute: Compute, preferences: Preferences, comparison: Comparison, sweep: Sweep): App {
  const state = initialState(preferences);
  const messages = new Messages(state.messages);
  const csvExport = new CsvExport(state, compute.csv, messages);
  const runs = new Runs(state, compute.run, messages, systemMetas, () => settleView(state));
  const modes = new ModeStage(state, runs, systemViews, systemMetas);
  keepDrafts(state);
  const files = new FileOpener({
    state,
    csv: compute.csv,
    messages,
    metas: systemMetas,
    show: (motion) => runs.show(motion),
    runDraft: () => runs.run(),
  });
  runPlaybackClock(state, {
    start: () => state.motion.peek()?.trajectory.start ?? 0,
    end: () => state.motion.peek()?.trajectory.end ?? 0,
    growing: () => state.run.peek()?.kind === 'computing',
  });

  const actions: AppActions = {
    open: () => runs.run(!preferences.reducedMotion),
    run: () => runs.run(),
    retune: () => runs.retune(),
    cancel: () => compute.run.cancel(),
    reset: () => void (state.draft.value = state.origin.peek().scenario),
    loadCase(id) {
      const found = caseInfos.find((c) => c.id === id);
      if (!found) return;
      batch(() => {
        state.origin.value = found;
        state.draft.value = found.scenario;
      });
      runs.run();
    },
    loadScenario(scenario, title) {
      batch(() => {
        state.origin.value = { id: '', title, summary: '', scenario };
        state.draft.value = scenario;
      });
      runs.run();
    },
    chooseSystem(id) {
      if (id === state.draft.peek().system || !systemViews[id]) return;
      const left = state.drafts.peek().get(id);
      const origin = left?.origin ?? caseInfos.find((c) => c.scenario.system === id) ?? blank(id);
      batch(() => {
        state.origin.value = origin;
        state.draft.value = left?.draft ?? origin.scenario;
      });
      if (state.draftErrors.peek().size === 0) runs.run();
    },
    openFiles: (list) => void files.open(list),
    cancelReading: () => files.cancel(),
    openSample: (id) => void files.openSample(id, samples),
    openFile: (name, file, timeStep) => files.openFile(name, file, timeStep),
    openScenario(origin, draft, autoplay) {
      batch(() => {
        state.origin.value = origin;
        state.draft.value = draft;
      });
      runs.run(autoplay);
    },
    answerTimeStep: (step) => files.answerTimeStep(step),
    exportCsv: () => void csvExport.write(),
    cancelWriting: () => csvExport.cancel(),
    saveScenario: () =>
      download('scenario.json', [`${JSON.stringify(state.draft.peek(), null, 2)}\n`], 'application/json'),
    play: () => play(state),
    pause: () => void (state.playing.value = false),
    toggle: () => (state.playing.peek() ? actions.pause() : actions.play()),
    seek: (time) => void (state.time.value = clampTime(state, time)),
    stepRows: (rows) => stepRows(state, rows),
    dismiss: (id) => messages.dismiss(id),
    compare: (contenders, scenario) => comparison.start(scenario ?? state.draft.peek(), contenders, systemMetas),
    showMode(mode, growth) {
      try {
        modes.show(mode, growth, speeds);
      } catch (error) {
        if (!(error instanceof ScenarioError)) throw error;
        messages.add('error', 'The mode cannot be shown', [error.message]);
      }
    },
    leaveMode: () => modes.back(),
    report: (kind, title, details, action) => messages.add(kind, title, details, action),
  };
  return {
    state,
    actions,
    cases: caseInfos,
    samples,
    systems: Object.values(systemMetas).map(({ id, title }) => ({ id, title })),
    systemOf: (id) => systemViews[id],
    comparison,
    kept: new Kept(state, messages),
    sweep,
    control: compute.control,
    locus: compute.locus,
    mechanics: compute.mechanics,
  };
}

const caseInfos: readonly CaseInfo[] = cases.map(({ look, ...one }) => ({ ...one, summary: look }));

/** A system nobody has made a case for starts with everything at its default. */
const blank = (id: string): CaseInfo => ({
  id: '',
  title: systemMetas[id]!.title,
  summary: '',
  scenario: { version: 1, system: id },
});

/** What was last edited of each system stays, whatever takes the panel to another one. */
function keepDrafts(state: AppState): void {
  effect(() => {
    const [draft, origin] = [state.draft.value, state.origin.value];
    if (origin.scenario.system === draft.system)
      state.drafts.value = new Map(state.drafts.peek()).set(draft.system, { draft, origin });
  });
}

function initialState({ dark, roomy }: Preferences): AppState {
  const draft = signal<ScenarioFile>(caseInfos[0]!.scenario);
  return {
    draft,
    drafts: signal(new Map()),
    origin: signal(caseInfos[0]!),
    draftErrors: computed(() => collectScenarioErrors(draft.value, systemMetas)),
    motion: signal(null),
    rowsVersion: signal(0),
    kept: signal([]),
    run: signal(null),
    statistics: signal(null),
    time: signal(0),
    playing: signal(false),
    speed: signal(1),
    heldSpeed: signal(null),
    loop: signal(false),
    grab: signal(null),
    aside: signal(null),
    view: signal('orbit'),
    follow: signal(true),
    showTrails: signal(true),
    showForces: signal(false),
    look: initialLook(),
    theme: signal(dark ? 'dark' : 'light'),
    plots: signal({ own: null, degrees: true, wrapped: false }),
    tool: signal(roomy ? 'now' : null),
    exporting: signal(false),
    studio: signal(null),
    messages: signal([]),
    pendingFile: signal(null),
    reading: signal(null),
    writing: signal(null),
    meshes: signal(new Map()),
    opened: signal(null),
    loading: signal(null),
  };
}

/** A look that another system does not offer is no view. */
function settleView({ motion, view }: AppState): void {
  const meta = motion.peek()?.system.meta;
  if (!meta) return;
  if ((view.peek() === 'caster' && !meta.views?.closeUp) || (view.peek() === 'rider' && !meta.views?.ridden))
    view.value = 'orbit';
}

function clampTime(state: AppState, time: number): number {
  const trajectory = state.motion.peek()?.trajectory;
  return trajectory ? Math.min(Math.max(time, trajectory.start), trajectory.end) : 0;
}

function play(state: AppState): void {
  const trajectory = state.motion.peek()?.trajectory;
  if (!trajectory) return;
  // Play at the end starts over, as every player does; while rows still come, it waits for them.
  if (state.time.peek() >= trajectory.end && state.run.peek()?.kind !== 'computing')
    state.time.value = trajectory.start;
  state.playing.value = true;
}

function stepRows(state: AppState, rows: number): void {
  const trajectory = state.motion.peek()?.trajectory;
  if (!trajectory || trajectory.length === 0) return;
  state.playing.value = false;
  const t = trajectory.column('t')!;
  const here = trajectory.locate(state.time.peek());
  // From between two rows, a step back goes to the row before, a step forward to the one after.
  const nearest = state.time.peek() >= t[Math.min(here + 1, t.length - 1)]! ? here + 1 : here;
  const between = rows < 0 && state.time.peek() > t[nearest]! ? 1 : 0;
  state.time.value = t[Math.min(Math.max(nearest + rows + between, 0), t.length - 1)]!;
}
