/** The application as the views have it: state to read, actions to ask for, events to hear, services to use. `store.ts` makes it. */
import type { ReadonlySignal } from '@preact/signals';
import type { ControlClient } from '../compute/client/controlClient.ts';
import type { GaitClient } from '../compute/client/gaitClient.ts';
import type { LocusClient } from '../compute/client/locusClient.ts';
import type { MechanicsClient } from '../compute/client/mechanicsClient.ts';
import type { CompanyActions, CompanyState } from './runs/company.ts';
import type { RideUpdate } from '../compute/services/rideTypes.ts';
import type { ScenarioFile } from '../core/scenario/types.ts';
import type { ImportChoices } from '../csv/plan.ts';
import type { SystemView } from '../core/model/system.ts';
import type { ExportService } from './files/exportService.ts';
import type { FileActions, FileState, OpenedFile } from './files/fileState.ts';
import type { SampleInfo } from './files/samples.ts';
import type { PushActions, PushState } from './push/pushState.ts';
import type { Comparison, Contender } from './runs/comparison.ts';
import type { LiveState } from './runs/live.ts';
import type { Motion } from './runs/motion.ts';
import type { ModePreview, ModeRequest } from './runs/modePreview.ts';
import type { PinnedRun, PinnedRuns } from './runs/pinnedRuns.ts';
import type { Ride } from './runs/runs.ts';
import type { StageState } from './runs/stageState.ts';
import type { Sweep } from './runs/sweep.ts';
import type { VehicleTests } from './runs/vehicleTests.ts';
import type { TrustState } from './runs/trust.ts';
import type { CaseInfo } from './state/cases.ts';
import type { DialogActions, DialogState } from './state/dialogs.ts';
import type { DraftAndOrigin, DraftEdit, ExperimentActions, ExperimentState } from './state/experiment.ts';
import type { FieldActions, FieldState } from './state/fields.ts';
import type { HistoryActions, HistoryState } from './state/history.ts';
import type { MessageActions, MessageState } from './state/messages.ts';
import type { PlaybackActions, PlaybackState } from './state/playback.ts';
import type { SettingsActions, SettingsState } from './state/settings.ts';
import type { AppEvent } from './state/signals.ts';
import type { StageLayoutActions, StageLayoutState } from './state/stageLayout.ts';

/** How `control` and `locus` answer. */
export type { Answer } from '../compute/client/answer.ts';

/** Read-only: what changes it is an action. */
export interface AppState
  extends
    ExperimentState,
    HistoryState,
    FieldState,
    StageState,
    LiveState,
    TrustState,
    PlaybackState,
    PushState,
    CompanyState,
    SettingsState,
    StageLayoutState,
    DialogState,
    MessageState,
    FileState {
  /** Runs and files that stay, beside the motion. */
  pinned: ReadonlySignal<readonly PinnedRun[]>;
  /** The mode on the stage and what it suspends, or null. */
  modePreview: ReadonlySignal<ModePreview | null>;
}

export interface RunActions {
  /** The first run after the page is opened: plays by itself unless the person asks for less motion. */
  start(): void;
  /** Runs the draft; where a field has something wrong, goes there instead. */
  run(): void;
  cancel(): void;
  /** Begins a ride of a scenario whose control is one, in step with the clock; false where it can't be. It is over when its run is. */
  ride(scenario: ScenarioFile, ride: Ride): boolean;
  /** What the ride is told, or how fast its clock goes. */
  steer(update: RideUpdate): void;
  /** Runs the draft, or another scenario, with each of these methods. @throws ScenarioError when it can't run itself */
  compare(contenders: readonly Contender[], scenario?: ScenarioFile): void;
  /** Computes the run on the stage again by another method, however long it takes. */
  compareRun(): void;
  /** Puts a motion on the stage and plays it; a run still computing is abandoned. */
  showMotion(motion: Omit<Motion, 'id'>): void;
  /** Puts a mode on the stage, growing as it does or by its shape alone. */
  showMode(mode: ModeRequest, growth: boolean): void;
  /** From a mode back to what was on the stage before. */
  leaveMode(): void;
}

export interface DraftActions {
  /** Back to what the draft came from. */
  resetDraft(): void;
  loadCase(id: string): void;
  /** Puts a scenario into the panel, under a title, and runs it. */
  loadScenario(scenario: ScenarioFile, title: string): void;
  /** Puts a checked draft into the panel and runs it. */
  openScenario(origin: CaseInfo, draft: ScenarioFile, autoplay?: boolean): void;
  /** To another system: back to the draft that was left there, else to its first case. */
  chooseSystem(id: string): void;
  /** Puts stored drafts back, without running. */
  restoreDrafts(current: DraftAndOrigin, drafts: ReadonlyMap<string, DraftAndOrigin>): void;
}

export interface OpenAndSaveActions {
  openFiles(files: readonly File[]): void;
  openSample(id: string): void;
  /** A CSV or a scenario; done when it is on the stage or refused with a message. */
  openFile(name: string, file: Blob, choices?: ImportChoices): Promise<void>;
  /** Gives up the file being read. */
  cancelReading(): void;
  /** Answers `pendingFile`, or null to give up. */
  answerPending(choices: ImportChoices | null): void;
  /** Reads the file on the stage again with this changed, and remembers it for files of its shape; null: as found. */
  readAgain(change: ImportChoices | null): void;
  /** Gives up choices that can't be read (`refusedReading`). */
  keepReading(): void;
  exportCsv(): void;
  cancelWriting(): void;
  saveScenario(): void;
}

export interface AppActions
  extends
    RunActions,
    DraftActions,
    ExperimentActions,
    HistoryActions,
    FieldActions,
    OpenAndSaveActions,
    PlaybackActions,
    PushActions,
    CompanyActions,
    SettingsActions,
    StageLayoutActions,
    DialogActions,
    MessageActions,
    Pick<FileActions, 'setLoading' | 'setMeshes' | 'setLesson'> {}

export interface AppEvents {
  draftEdited: AppEvent<DraftEdit>;
  fileOpened: AppEvent<OpenedFile>;
}

export interface App {
  state: AppState;
  actions: AppActions;
  events: AppEvents;
  cases: readonly CaseInfo[];
  samples: readonly SampleInfo[];
  systems: readonly { id: string; title: string }[];
  systemOf(id: string): SystemView | undefined;
  /** Linearization and design, computed in a worker. */
  control: ControlClient;
  /** Regulators tried in whole runs. */
  effect: ControlClient;
  locus: LocusClient;
  gait: GaitClient;
  /** The equations in numbers. */
  mechanics: MechanicsClient;
  comparison: Comparison;
  pinned: PinnedRuns;
  sweep: Sweep;
  /** Manoeuvres with pass or fail; loaded when it is asked for. */
  vehicleTests(): Promise<VehicleTests>;
  exportService: ExportService;
}
