import type { Compute } from '../compute/client/compute.ts';
import { ScenarioError } from '../core/scenario/types.ts';
import { written } from '../core/scenario/own.ts';
import { systemMetas, systemViews } from '../core/systems/registry.ts';
import type { App, AppActions, AppState } from './app.ts';
import { download } from './files/download.ts';
import { createExportService } from './files/exportService.ts';
import { createFileState } from './files/fileState.ts';
import { samples } from './files/samples.ts';
import { later } from './later.ts';
import { createPush } from './push/pushState.ts';
import type { Comparison } from './runs/comparison.ts';
import { createCompany } from './runs/company.ts';
import { LiveRuns } from './runs/live.ts';
import { ModePreviewer } from './runs/modePreview.ts';
import { PinnedRuns } from './runs/pinnedRuns.ts';
import { Runs } from './runs/runs.ts';
import { createStage } from './runs/stageState.ts';
import type { Sweep } from './runs/sweep.ts';
import type { VehicleTests } from './runs/vehicleTests.ts';
import { TrustKeeper } from './runs/trust.ts';
import { settleView } from './runs/views.ts';
import { builtInCases, firstCaseOf, ownCase, type CaseInfo } from './state/cases.ts';
import { createDialogs } from './state/dialogs.ts';
import { createExperiment } from './state/experiment.ts';
import { createFields } from './state/fields.ts';
import { createHistory } from './state/history.ts';
import { createMessages } from './state/messages.ts';
import { createPlayback } from './state/playback.ts';
import { createSettings } from './state/settings.ts';
import { listenable } from './state/signals.ts';
import { createStageLayout } from './state/stageLayout.ts';
import type { ScenarioFile } from '../core/scenario/types.ts';

export { systemMetas };

/** What the person's system asks of every page. */
export interface Preferences {
  dark: boolean;
  reducedMotion: boolean;
  /** Room for a tool beside the scene from the start. */
  roomy: boolean;
}

async function loadVehicleTests({ later: { start, cores } }: Compute): Promise<VehicleTests> {
  const [{ VehicleTests }, { testsPool }] = await Promise.all([
    import('./runs/vehicleTests.ts'),
    import('../compute/client/testsClient.ts'),
  ]);
  return new VehicleTests(testsPool(start, cores));
}

/** The application: its slices, joined. Each slice alone changes its state. */
export function createApp(compute: Compute, preferences: Preferences, comparison: Comparison, sweep: Sweep): App {
  let vehicleTests: Promise<VehicleTests> | null = null;
  const messages = createMessages();
  const experiment = createExperiment(builtInCases[0]!, systemMetas);
  const settings = createSettings({
    theme: preferences.dark ? 'dark' : 'light',
    tool: preferences.roomy ? 'now' : null,
  });
  const stage = createStage();
  const playback = createPlayback(stage.state, settings.state);
  const push = createPush();
  const company = createCompany();
  const dialogs = createDialogs();
  const layout = createStageLayout();
  const fileState = createFileState();

  const trust = new TrustKeeper({ stage: stage.state, draft: experiment.state.draft, client: compute.trust });
  const csvExport = later(
    () =>
      import('./files/csvExport.ts').then(
        ({ CsvExport }) =>
          new CsvExport({ ...stage.state, ...trust.state }, fileState.actions, compute.csv, messages.actions),
      ),
    messages.actions,
  );
  const runs = new Runs({
    stage,
    experiment: experiment.state,
    playback,
    settings: settings.state,
    pushing: push.state,
    client: compute.run,
    messages: messages.actions,
    metas: systemMetas,
    settle: () => settleView(stage.state, settings),
  });
  const pinned = new PinnedRuns(stage.state, messages.actions);
  const modes = new ModePreviewer({
    stage: stage.state,
    playback: playback.state,
    settings,
    runs,
    views: systemViews,
    metas: systemMetas,
  });
  const fields = createFields();
  const live = new LiveRuns({
    stage: stage.state,
    playback,
    settings: settings.state,
    experiment: experiment.state,
    runs,
    replays: !preferences.reducedMotion,
  });
  const history = createHistory(experiment, (edit) => {
    fields.actions.forgetRefused();
    const motion = stage.state.motion.peek();
    const another =
      edit.before.origin.scenario !== edit.after.origin.scenario || motion?.system.meta.id !== edit.after.draft.system;
    // A file on the stage stays there.
    if (another && motion?.source === 'run' && experiment.state.draftErrors.peek().size === 0) runs.run();
    else live.follow(edit);
  });
  const edit: AppActions['edit'] = (label, change) => {
    const before = { draft: experiment.state.draft.peek(), origin: experiment.state.origin.peek() };
    experiment.actions.edit(label, change);
    const after = { draft: experiment.state.draft.peek(), origin: before.origin };
    if (after.draft !== before.draft) live.follow({ label, before, after });
  };
  const byHand =
    <Args extends unknown[]>(act: (...args: Args) => void) =>
    (...args: Args): void => {
      live.stay();
      act(...args);
    };
  const openScenario = (origin: CaseInfo, draft: ScenarioFile, autoplay?: boolean): void => {
    experiment.actions.replace(origin.title, { origin, draft });
    fields.actions.forgetRefused();
    live.stay();
    runs.run(autoplay);
  };
  const files = later(async () => {
    const { FileOpener } = await import('./files/fileOpener.ts');
    return new FileOpener({
      files: fileState,
      stage: stage.state,
      experiment: experiment.state,
      csv: compute.csv,
      messages: messages.actions,
      metas: systemMetas,
      show: (motion) => runs.show(motion),
      showAgain(motion) {
        const [time, playing] = [playback.state.time.peek(), playback.state.playing.peek()];
        runs.show(motion);
        playback.actions.seek(time);
        playback.actions.setPlaying(playing);
      },
      settings,
      openScenario,
    });
  }, messages.actions);

  const state: AppState = {
    ...experiment.state,
    ...history.state,
    ...fields.state,
    ...stage.state,
    ...live.state,
    ...trust.state,
    ...playback.state,
    ...push.state,
    ...company.state,
    ...settings.state,
    ...layout.state,
    ...dialogs.state,
    ...messages.state,
    ...fileState.state,
    ...modes.state,
    pinned: pinned.runs,
  };
  const { draft, origin, drafts, draftErrors } = state;
  const { replace, restore, rename } = experiment.actions;
  const { undo, redo, goToEdit } = history.actions;
  const { refuseField, goToField, forgetRefused } = fields.actions;
  const { play, pause, togglePlaying, seek, stepRows } = playback.actions;

  const actions: AppActions = {
    ...push.actions,
    ...company.actions,
    ...settings.actions,
    ...layout.actions,
    ...dialogs.actions,
    ...messages.actions,
    edit,
    rename,
    undo,
    redo,
    goToEdit,
    refuseField,
    goToField,
    play: byHand(play),
    pause: byHand(pause),
    togglePlaying: byHand(togglePlaying),
    seek: byHand(seek),
    stepRows: byHand(stepRows),
    setLoading: fileState.actions.setLoading,
    setMeshes: fileState.actions.setMeshes,
    setLesson: fileState.actions.setLesson,
    start: () => runs.run(!preferences.reducedMotion, true),
    run() {
      const wrong = [...state.refusedFields.peek().keys(), ...draftErrors.peek().keys()][0];
      if (wrong !== undefined) return goToField(wrong);
      live.stay();
      runs.run();
    },
    cancel: () => compute.run.cancel(),
    ride(scenario, ride) {
      live.stay();
      replace(ride.title, { origin: ownCase(ride.title, scenario), draft: scenario });
      forgetRefused();
      return runs.ride(scenario, {
        ...ride,
        over(end, file) {
          replace(ride.title, { origin: ownCase(ride.title, file), draft: file });
          ride.over(end, file);
        },
      });
    },
    steer: (update) => compute.run.steer(update),
    resetDraft() {
      forgetRefused();
      edit('reset', () => origin.peek().scenario);
    },
    loadCase(id) {
      const found = builtInCases.find((c) => c.id === id);
      if (found) openScenario(found, found.scenario);
    },
    loadScenario: (scenario, title) => openScenario(ownCase(title, scenario), scenario),
    openScenario,
    chooseSystem(id) {
      const meta = systemMetas[id];
      if (id === draft.peek().system || !meta) return;
      const first = firstCaseOf(meta);
      forgetRefused();
      replace(meta.title, drafts.peek().get(id) ?? { origin: first, draft: first.scenario });
      if (draftErrors.peek().size === 0) runs.run();
    },
    restoreDrafts(current, all) {
      forgetRefused();
      restore(current.origin.title, current, all);
      history.actions.forget();
    },
    openFiles: (list) => void files.with((opener) => opener.open(list)),
    cancelReading: () => files.ifHere((opener) => opener.cancel()),
    openSample: (id) => void files.with((opener) => opener.openSample(id, samples)),
    openFile: (name, file, choices) => files.with((opener) => opener.openFile(name, file, choices)),
    answerPending: (choices) => files.with((opener) => opener.answerPending(choices)),
    keepReading: () => files.ifHere((opener) => opener.keepReading()),
    readAgain: (change) => void files.with((opener) => opener.readAgain(change)),
    exportCsv: () => void csvExport.with((file) => file.write()),
    cancelWriting: () => csvExport.ifHere((file) => file.cancel()),
    saveScenario: () =>
      download(
        'scenario.json',
        [`${JSON.stringify(written(draft.peek(), systemMetas), null, 2)}\n`],
        'application/json',
      ),
    compare: (contenders, scenario) => comparison.start(scenario ?? draft.peek(), contenders, systemMetas),
    compareRun: () => trust.compare(),
    showMotion: (motion) => runs.show(motion),
    showMode(mode, growth) {
      try {
        modes.show(mode, growth);
      } catch (error) {
        if (!(error instanceof ScenarioError)) throw error;
        messages.actions.report('error', 'The mode cannot be shown', [error.message]);
      }
    },
    leaveMode: () => modes.leave(),
  };
  return {
    state,
    actions,
    events: { draftEdited: experiment.edited, fileOpened: listenable(fileState.opened) },
    cases: builtInCases,
    samples,
    systems: Object.values(systemMetas).map(({ id, title }) => ({ id, title })),
    systemOf: (id) => systemViews[id],
    control: compute.control,
    effect: compute.effect,
    locus: compute.locus,
    gait: compute.gait,
    mechanics: compute.mechanics,
    comparison,
    pinned,
    sweep,
    vehicleTests: () => (vehicleTests ??= loadVehicleTests(compute)),
    exportService: createExportService(),
  };
}
