/** What the views are given, and what they may ask for. The store in `store.ts` implements it with signals. */
import type { ReadonlySignal, Signal } from '@preact/signals';
import type { Comparison, Contender } from './runs/comparison.ts';
import type { Kept, KeptRun } from './runs/pinnedRuns.ts';
import type { ControlClient } from '../compute/client/controlClient.ts';
import type { LocusClient } from '../compute/client/locusClient.ts';
import type { MechanicsClient } from '../compute/client/mechanicsClient.ts';
export type { Answer } from '../compute/client/answer.ts';
import type { Case } from '../core/cases/case.ts';
import type { Look } from './state/viewSettings.ts';
import type { Aside, ModeRequest } from './runs/modePreview.ts';
import type { Sweep } from './runs/sweep.ts';
import type { Studio } from './files/exportRenderer.ts';
import type { ScenarioFile, Scenario } from '../core/scenario/types.ts';
import type { Push, PushRecord } from '../core/simulation/push.ts';
import type { SystemView } from '../core/model/system.ts';
import type { Trajectory } from '../core/motion/trajectory.ts';

/** One change that the consistent start made: a value that was named (or rest) and what it became. */
export interface Adjustment {
  name: string;
  from: number;
  to: number;
  /** Whether `initial` named it. */
  named: boolean;
}

export interface RunStatistics {
  steps: number;
  rejected: number;
  evaluations: number;
  /** Energy now minus energy at the start, over the run's largest kinetic energy so far. */
  energyDrift: number;
  /** Largest constraint residual so far. */
  residual: number;
}

/** Where a run stands. `reason` is a permanent id: `end`, `touchdown`, `constraint-singular`, `step-too-small`, `non-finite`, `cancelled`, `failed`. */
export type RunState =
  { kind: 'computing'; progress: number } | { kind: 'ended'; reason: string; message: string; time: number };

/** A row or cell of a CSV file that could not be used, or a note on how it was read. */
export interface FileIssue {
  /** 1-based line in the file; 0 when it concerns the whole file. */
  line: number;
  /** Column name or 1-based number; empty when it concerns the whole line. */
  column: string;
  message: string;
}

/** Something that can be watched: a live run, a loaded file, a mode. */
export interface Motion {
  id: number;
  /** A mode is an eigenvector shown as motion: no solution of the equations, and not a file's. */
  source: 'run' | 'file' | 'mode';
  title: string;
  system: SystemView;
  /** Parameters the bodies are drawn with. */
  parameters: Readonly<Record<string, number>>;
  trajectory: Trajectory;
  /** Multipliers are forces under this set (for the force arrows); null for files without. */
  constraints: string | null;
  scenario: Scenario | null;
  /** The scenario as the person wrote it; what an export carries. */
  written: ScenarioFile | null;
  adjustments: readonly Adjustment[];
  issues: readonly FileIssue[];
  /** Event marks on the time line. */
  marks: readonly { time: number; name: string }[];
  /** What a hand did to the run: with it, and only with it, the scenario can be run again. */
  pushes?: readonly PushRecord[];
  /** How well a file's numbers keep energy and constraints; null when that can't be told (runs have statistics). */
  judgement: { energyDrift: number; residual: number } | null;
}

export interface Message {
  id: number;
  kind: 'info' | 'warning' | 'error';
  title: string;
  /** What happened, where, what to do. */
  details: readonly string[];
  /** What the person may do about it with one press. */
  action?: MessageAction;
}

export interface MessageAction {
  label: string;
  run(): void;
}

export interface PendingFile {
  name: string;
  /** A headerless file: the time step is asked for, this one offered (s). */
  offeredStep: number;
}

/** One plot: columns over time or over another column. Plain data, so that it can be kept and shared. */
export interface PlotPane {
  title: string;
  x: string;
  y: readonly string[];
  hidden?: readonly string[];
  equal?: boolean;
  /** Where the horizontal axis ends, if before the motion. */
  to?: number;
  /** A curve in closed form, an expression of t. */
  exact?: { label: string; expression: string };
}

export interface PlotsState {
  /** What the person made for one case or system (`key`); those of the case while there is none. */
  own: { key: string; panes: readonly PlotPane[] } | null;
  degrees: boolean;
  wrapped: boolean;
}

export type ViewName = 'orbit' | 'front' | 'side' | 'top' | 'caster' | 'rider';

export interface AppState {
  // --- the experiment being edited
  draft: Signal<ScenarioFile>;
  /** The draft last edited of each system, and what it came from. */
  drafts: Signal<ReadonlyMap<string, { draft: ScenarioFile; origin: CaseInfo }>>;
  /** What the draft came from: a built-in case, or an opened scenario file. `reset` goes back to it. */
  origin: Signal<CaseInfo>;
  /** The error of each draft key that is not right, by path; empty when the draft can run. */
  draftErrors: ReadonlySignal<ReadonlyMap<string, string>>;
  // --- what is being watched
  motion: Signal<Motion | null>;
  /** Bumped whenever the motion's trajectory grows. */
  rowsVersion: Signal<number>;
  run: Signal<RunState | null>;
  statistics: Signal<RunStatistics | null>;
  /** Runs and files that stay, beside the motion. */
  kept: Signal<readonly KeptRun[]>;
  // --- playback
  time: Signal<number>;
  playing: Signal<boolean>;
  speed: Signal<number>;
  /** The speed really held over the last second, or null when not playing. */
  heldSpeed: Signal<number | null>;
  loop: Signal<boolean>;
  /** What the person drags in the scene, or null. */
  grab: Signal<Push | null>;
  /** While a mode is on the stage: which, and what it stands in for. */
  aside: Signal<Aside | null>;
  // --- view switches
  view: Signal<ViewName>;
  follow: Signal<boolean>;
  showTrails: Signal<boolean>;
  showForces: Signal<boolean>;
  look: Look;
  theme: Signal<'light' | 'dark'>;
  plots: Signal<PlotsState>;
  /** Which tool is open beside the scene, by id; null when none is. */
  tool: Signal<string | null>;
  /** Whether the export dialog is open. */
  exporting: Signal<boolean>;
  /** Makes pictures and 3-D files of what is on the stage; null without a scene. */
  studio: Signal<Studio | null>;
  // --- things to say
  messages: Signal<readonly Message[]>;
  pendingFile: Signal<PendingFile | null>;
  /** A large file on its way in. */
  reading: Signal<{ name: string; share: number; rows: number } | null>;
  /** A long run is being written as a CSV file. */
  writing: Signal<{ name: string; share: number } | null>;
  /** Meshes the person dropped, by `<system>/<model>`; a missing half is the generated one. */
  meshes: Signal<ReadonlyMap<string, { mdl?: string; mat?: string }>>;
  /** The file that was just put on the stage, until it has been stored. */
  opened: Signal<{ name: string; file: Blob; timeStep?: number } | null>;
  /** A file on its way from the server: 0 to 1, or null where its length is not known. */
  loading: Signal<{ name: string; share: number | null } | null>;
}

export interface AppActions {
  /** First run of a visit: plays by itself unless the person asks for less motion. */
  open(): void;
  run(): void;
  /** The motion being watched goes on from the playback time with the draft's controller and inputs. */
  retune(): void;
  cancel(): void;
  /** Back to the case the draft came from. */
  reset(): void;
  loadCase(id: string): void;
  /** Puts a scenario into the panel, under a title, and runs it. */
  loadScenario(scenario: ScenarioFile, title: string): void;
  /** To another system: back to the draft that was left there, else to its first case. */
  chooseSystem(id: string): void;
  openFiles(files: readonly File[]): void;
  openSample(id: string): void;
  /** A CSV or a scenario; done when it is on the stage or refused with a message. */
  openFile(name: string, file: Blob, timeStep?: number): Promise<void>;
  /** Puts a checked draft into the panel and runs it. */
  openScenario(origin: CaseInfo, draft: ScenarioFile, autoplay?: boolean): void;
  /** Gives up the file being read. */
  cancelReading(): void;
  /** Answers `pendingFile`: the time step in seconds, or null to give up. */
  answerTimeStep(step: number | null): void;
  exportCsv(): void;
  cancelWriting(): void;
  saveScenario(): void;
  play(): void;
  pause(): void;
  toggle(): void;
  seek(time: number): void;
  /** Moves by whole rows. */
  stepRows(rows: number): void;
  dismiss(messageId: number): void;
  /** Runs the draft with each of these methods. @throws ScenarioError when the draft itself can't run */
  /** Of the scenario in the panel, unless another is given. */
  compare(contenders: readonly Contender[], scenario?: ScenarioFile): void;
  /** Puts a mode on the stage, growing as it does or by its shape alone. */
  showMode(mode: ModeRequest, growth: boolean): void;
  /** From a mode back to what was on the stage before. */
  leaveMode(): void;
  /** Tells the person something that happened outside the store. */
  report(kind: Message['kind'], title: string, details: readonly string[], action?: MessageAction): void;
}

export interface CaseInfo {
  id: string;
  title: string;
  /** One line: what to look at. */
  summary: string;
  scenario: ScenarioFile;
  /** Where it comes from: figure and section of the report, or a paper. */
  source?: string | undefined;
  figure?: string | undefined;
  chapter?: string | undefined;
  /** Where its picture is taken. */
  picture?: Case['picture'] | undefined;
}

export interface SampleInfo {
  id: string;
  title: string;
  /** Relative to the page. */
  url: string;
}

export interface App {
  state: AppState;
  actions: AppActions;
  cases: readonly CaseInfo[];
  samples: readonly SampleInfo[];
  systems: readonly { id: string; title: string }[];
  systemOf(id: string): SystemView | undefined;
  /** Linearization and design, computed aside. */
  control: ControlClient;
  locus: LocusClient;
  /** The equations in numbers. */
  mechanics: MechanicsClient;
  comparison: Comparison;
  kept: Kept;
  sweep: Sweep;
}
