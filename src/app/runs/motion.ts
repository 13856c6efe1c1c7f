/** What can be watched, and what is known of the run behind it. */
import type { Trajectory } from '../../core/motion/trajectory.ts';
import type { EngineId, Scenario, ScenarioFile } from '../../core/scenario/types.ts';
import type { PushRecord } from '../../core/simulation/push.ts';
import type { ImportChoices, ImportPlan } from '../../csv/plan.ts';
import type { SystemView } from '../../core/model/system.ts';

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
  energyDrift: number | null;
  /** Energy now minus energy at the start, J. */
  energyChange: number;
  /** What inputs, controllers and pushes put in, J; null where nothing acts. */
  work: number | null;
  /** Largest constraint residual so far. */
  residual: number;
}

/** Where a run stands. `reason` is a permanent id: `end`, `touchdown`, `constraint-singular`, `step-too-small`, `non-finite`, `cancelled`, `failed`. */
export type RunState =
  /** `derived`: the share of the equations of a described system, until they are there. */
  | { kind: 'computing'; progress: number; derived?: number }
  | { kind: 'ended'; reason: string; message: string; time: number };

/** A row or cell of a CSV file that could not be used, or a note on how it was read. */
export interface FileIssue {
  /** 1-based line in the file; 0 when it concerns the whole file. */
  line: number;
  /** Last line, where the same holds for lines that follow one another. */
  to?: number;
  /** Column name or 1-based number; empty when it concerns the whole line. */
  column: string;
  message: string;
}

/** How a file was read, and what it takes to read it again. */
export interface Imported {
  file: Blob;
  plan: ImportPlan;
  /** What the person chose. */
  choices: ImportChoices;
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
  /** Of a run: what computed its steps. */
  engine?: EngineId;
  adjustments: readonly Adjustment[];
  issues: readonly FileIssue[];
  /** Event marks on the time line. */
  marks: readonly { time: number; name: string }[];
  /** The pushes on the run: with them, and only with them, the scenario can be run again. */
  pushes?: readonly PushRecord[];
  /** Of a file. */
  imported?: Imported;
  /** How well a file's numbers keep energy and constraints; null when that can't be told (runs have statistics). */
  judgement: { energyDrift: number | null; energyChange: number; residual: number } | null;
}

/** Of a motion that no run and no file stands behind: there is nothing to say of how it came about. */
export const UNRECORDED = {
  constraints: null,
  scenario: null,
  written: null,
  adjustments: [],
  issues: [],
  marks: [],
  judgement: null,
} as const satisfies Partial<Motion>;
