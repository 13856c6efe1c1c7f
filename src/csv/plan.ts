import type { Dress } from './layout/dress.ts';
import type { Kind } from './units/units.ts';

/**
 * How a table of numbers is understood before its rows are read. `understand` makes a plan from the beginning of a file
 * and from what a person chose; the reader follows it; the page shows it and lets each part be changed.
 */

export type Encoding =
  | 'utf-8'
  | 'utf-16le'
  | 'utf-16be'
  | 'windows-1252'
  | 'windows-1250'
  | 'windows-1251'
  | 'shift_jis'
  | 'gb18030'
  | 'euc-kr';
/** What stands between two cells; `blanks`: any number of spaces and tabs. */
export type Separator = ',' | ';' | '\t' | '|' | 'blanks';
/** How rates that the file does not hold are made. */
export type RatesChoice = 'none' | 'savitzky-golay';

/**
 * What a person decides, on the page or on the command line; whatever is absent is found out. Columns of the file are
 * named as in `ColumnPlan.source`.
 */
export interface ImportChoices {
  encoding?: Encoding;
  separator?: Separator;
  decimal?: '.' | ',';
  /** 1-based line with the names; 0: there is none. */
  headerLine?: number;
  /** Id of a system; null: data without a system. */
  system?: string | null;
  /** By canonical name (`theta`, `theta_dot`, `t`): the column it comes from; null: from none. */
  map?: Readonly<Record<string, string | null>>;
  /** By canonical name or column: the unit its numbers have. */
  units?: Readonly<Record<string, string>>;
  /** Unit of every angle that has none of its own, here or in the file. */
  angles?: 'rad' | 'deg';
  /** Unit of every length that has none of its own, here or in the file. */
  lengths?: 'm' | 'cm' | 'mm';
  /** The column with the time; null: rows are `step` apart. */
  time?: string | null;
  /** Unit of a time that has none, by name (`s`, `ms`, `us`, `ns`, `min`, `h`). */
  timeUnit?: string;
  /** Of dates such as 3/4/2025. */
  dateOrder?: 'day first' | 'month first';
  /** Seconds between rows (frames) where no time is read. */
  step?: number;
  /** Which of several runs in one file, from 1. */
  run?: number;
  /** Which of several bodies in one file, by name. */
  body?: string;
  /** Which of a quaternion's four numbers the scalar is, where their names do not say. */
  scalar?: 'first' | 'last';
  /** The axis that points up. */
  up?: 'y' | 'z';
  rates?: RatesChoice;
}

export type QuestionId =
  'time-step' | 'time-unit' | 'degrees' | 'lengths' | 'several-runs' | 'several-bodies' | 'scalar' | 'date-order';

/** Something that the file leaves open. An answer is read by merging its choices into those there are. */
export interface Question {
  id: QuestionId;
  /** One sentence with a question mark. */
  text: string;
  answers: readonly { label: string; choices: ImportChoices }[];
  /** Index of the answer that is taken unasked. */
  safest: number;
  /** The page asks before it reads; the others are asked beside the motion. */
  first: boolean;
}

export interface ColumnPlan {
  /** Position in the file, 0-based. */
  index: number;
  /** Its name in the file without the unit; `column 3` where it has none. Unique in a plan. */
  source: string;
  /** The header's cell as written. */
  title: string;
  /** Canonical name (`t`, `alpha`, `alpha_dot`, `energy`), with data the column's own; null: not used. */
  name: string | null;
  /** Unit of the file's numbers; '' where none is said (SI, radians). */
  unit: string;
  /** Where the unit was found. */
  unitFrom: 'title' | 'units row' | 'lines above' | 'choice' | 'none';
  /** Times this is SI and radians. */
  factor: number;
  kind: Kind;
  /** What the column gives: one part of an attitude (`qx` … `qw`, `rx` … `rz`) is no angle of the system by itself. */
  role: 'time' | 'coordinate' | 'rate' | 'other' | 'attitude' | 'data' | 'unused';
}

export type TimeForm =
  | 'number'
  | 'epoch'
  | 'date-time'
  | 'clock'
  | 'date and clock'
  | 'compact clock'
  | 'parts'
  | 'frame'
  | 'steps'
  | 'counted';

export interface TimePlan {
  /** Columns it is read from: none, one, a date and a clock, or (`parts`) the last of year, month, day, hour, minute, second. */
  columns: readonly number[];
  form: TimeForm;
  /** Unit of numbers; '' for text and counted rows. */
  unit: string;
  /** Seconds from one unit. */
  factor: number;
  /** Seconds between rows or frames (`frame`, `counted`). */
  step: number | null;
}

export interface ImportPlan {
  encoding: Encoding;
  /**
   * `labelled`: every value has its name beside it; `stamped`: a clock and an arrow stand before each row; `bracketed`: rows
   * stand between brackets or bars.
   */
  lineForm: 'plain' | 'labelled' | 'stamped' | 'bracketed';
  /** What stands around the numbers of cells; null where nothing does. */
  dress: Dress | null;
  separator: Separator;
  decimal: '.' | ',';
  /** 1-based lines of the header, several where groups stand above names; empty without one. */
  headerLines: readonly number[];
  /** 1-based line with units, or null. */
  unitsLine: number | null;
  /** 1-based line of the first row of numbers. */
  firstRow: number;
  /** Cells of a row. */
  width: number;
  /** What begins a comment, in the order seen. */
  comments: readonly string[];
  /** Name and value of lines above the header. */
  properties: readonly { name: string; value: string }[];
  /** Id of the system, or null: data. */
  system: string | null;
  columns: readonly ColumnPlan[];
  time: TimePlan;
  /** One long column of names: indices of time, name, value, and the names that become columns. */
  long: { time: number; name: number; value: number; names: readonly string[] } | null;
  /** Runs found in the file, and the one that is read; 0 before all rows are read. */
  runs: number;
  run: number | null;
  /** Names of the bodies in the file, where there are several, and the one that is read. */
  bodies: readonly string[];
  body: string | null;
  /** Rows are read that have this in this column, where several bodies stand one below another. */
  only: { column: number; value: string } | null;
  /** Columns have their values at different times: each is interpolated between its own. */
  sparse: boolean;
  /** Order of the turns where the attitude is Euler angles, each about the axes turned before; null where it is not. */
  euler: string | null;
  up: 'y' | 'z';
  rates: RatesChoice;
  questions: readonly Question[];
  /** What was decided that a person may want to know, a sentence each. */
  notes: readonly string[];
  /** Columns that name again what another is. */
  repeated: readonly { title: string; message: string }[];
  /** The first rows as cells, for a preview; at most 20. */
  preview: readonly (readonly string[])[];
  /** Files of the same shape have the same key: choices made for one hold for the others. */
  shape: string;
}

/** A plan, or why there is none: one clear line that says what to do. */
export type Understanding = { kind: 'plan'; plan: ImportPlan } | { kind: 'refused'; line: number; message: string };
