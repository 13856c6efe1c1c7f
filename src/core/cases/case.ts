import type { ScenarioFile } from '../scenario/types.ts';

/** A built-in case: data for the page's gallery, the command line, documentation and tests. */
export interface Case {
  id: string;
  title: string;
  /** The figure or paper it reproduces, or empty. */
  source: string;
  /** Figures of the report that it reproduces, e.g. `Fig. 8 to 10`. */
  figure?: string | undefined;
  /** Section of the report. */
  chapter?: string | undefined;
  /** One line: what to look at. */
  look: string;
  /** Of cases that differ in one thing: the id that they share, and this one's value of it, e.g. `2 m/s`. */
  among?: { id: string; value: string };
  scenario: ScenarioFile;
  /** Numbers known from elsewhere, which the run meets within their tolerance. */
  published?: readonly Published[] | undefined;
  /** The moment and view that tell what it is about. */
  picture?: Shot | undefined;
  /** Figures of the report that are views of the scene. */
  figures?: readonly (Shot & { title: string })[];
  /** What to plot; a figure of the report on its own axes. */
  plots?: readonly CasePlot[];
}

/** A picture of the scene. */
export interface Shot {
  /** In s; without it, when 0.4 of the run have passed. */
  time?: number;
  /** `orbit` unless named. */
  view?: 'orbit' | 'front' | 'side' | 'top' | 'caster';
  /** How many times as far off as the view stands by itself. */
  distance?: number;
}

export interface Published {
  /** In words, e.g. `x at 5 s`. */
  what: string;
  measure: Measure;
  value: number;
  unit?: string;
  tolerance: number;
  /** Where the number comes from. */
  source: string;
}

/**
 * A number of a run; `column` as in `CaseColumns`, times in s (a whole run where they are left out).
 *
 * `end`: last value; `at`: value of the row at a time; `max`, `min`: over the rows from `from` to `to`;
 * `diameter`: of the circle that fits the points (x, y) of the rows best, in the least-squares sense;
 * `energy`: what the inputs put in, J: the integral of the sum of u times its rate (`net`), or of its absolute values
 * (`gross`: what motors that take nothing back would spend; a rider's muscles spend more);
 * `distance`: length of the path of (x, y), m; `speed`: that over the time it took, m/s;
 * `energyPerMetre`: energy over distance, J/m.
 */
export type Measure =
  | { kind: 'end'; column: string }
  | { kind: 'at'; column: string; time: number }
  | { kind: 'max' | 'min'; column: string; from?: number; to?: number }
  | { kind: 'diameter' | 'distance' | 'speed'; x: string; y: string; from?: number; to?: number }
  | { kind: 'energy'; spent: 'net' | 'gross'; from?: number; to?: number }
  | { kind: 'energyPerMetre'; spent: 'net' | 'gross'; x: string; y: string; from?: number; to?: number };

/** A plot of columns against a column, with the report's axes where it reproduces a figure. */
export interface CasePlot {
  title: string;
  /** Column on the horizontal axis. */
  x: string;
  y: readonly string[];
  /** Of the vertical axis; angles are recorded in rad and shown in what is named here. */
  unit: 'deg' | 'rad' | 'm' | 'm/s' | 'rad/s' | 'N·m' | 'N' | 'W' | '1';
  /** Where the figure's horizontal axis ends, if before the run. */
  to?: number;
  /** The same length on both axes shows as the same length. */
  equal?: boolean;
  /** A curve in closed form, an expression of t, drawn with them. */
  exact?: { label: string; expression: string };
}
