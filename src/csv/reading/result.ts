import type { SystemMeta } from '../../core/model/system.ts';
import type { ImportChoices, ImportPlan, Question } from '../plan.ts';
import type { CsvIssue } from './issues.ts';

export interface CsvOptions {
  systems: Readonly<Record<string, SystemMeta>>;
  /** Answers `needs-time-step`, s. */
  timeStep?: number;
  /** What a person decided. */
  choices?: ImportChoices;
  /** System of a scenario behind the table, where it is known. */
  preferred?: string | null;
  /** Opens what names no system's coordinates as data; otherwise it is unusable. */
  data?: boolean;
  /** Takes the safest reading where a question would come first. */
  unasked?: boolean;
}

export type CsvResult =
  | {
      kind: 'motion';
      /** Null for data, only where `data` is asked for. */
      systemId: string | null;
      /** `t`, coordinates, velocities, then what else was recognised. */
      columns: string[];
      data: Float64Array[];
      rows: number;
      skippedRows: number;
      /** In the order of the file, the first 1,000. */
      issues: CsvIssue[];
      /** How the file was understood. */
      notes: string[];
      /** What the file leaves open; the rows were read in the safest way. */
      questions: Question[];
      plan: ImportPlan;
      /** JSON of a `# scenario:` comment, unchecked, or null. */
      scenario: unknown;
    }
  | { kind: 'needs-time-step'; offeredStep: number; columns: number }
  | { kind: 'unusable'; issues: CsvIssue[] };
