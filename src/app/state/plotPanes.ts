/** What is plotted, as a link or the storage has it: read like a stranger's file. */
import { compileExpression } from '../../core/scenario/expressions.ts';

/** One plot: columns over time or over another column. Plain data, so that it can be stored and shared. */
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

export const MOST_PANES = 24;
const MOST_COLUMNS = 100;

/** Null for anything that is not plots. */
export function plotsFrom(value: unknown): PlotsState | null {
  if (!isRecord(value) || typeof value['degrees'] !== 'boolean' || typeof value['wrapped'] !== 'boolean') return null;
  const { own, degrees, wrapped } = value;
  if (own === null) return { own, degrees, wrapped };
  if (!isRecord(own) || !isName(own['key']) || !Array.isArray(own['panes']) || own['panes'].length > MOST_PANES)
    return null;
  const panes = own['panes'].map(paneFrom);
  return panes.every((pane) => pane !== null) ? { own: { key: own['key'], panes }, degrees, wrapped } : null;
}

/** Null for anything that is no plot. */
export function paneFrom(value: unknown): PlotPane | null {
  if (!isRecord(value)) return null;
  const { title, x, y, hidden, equal, to, exact } = value;
  if (typeof title !== 'string' || title.length > 200 || !isName(x) || !areNames(y)) return null;
  if ((hidden !== undefined && !areNames(hidden)) || (equal !== undefined && typeof equal !== 'boolean')) return null;
  if (to !== undefined && !(typeof to === 'number' && Number.isFinite(to))) return null;
  const curve = exact === undefined ? undefined : curveFrom(exact);
  if (curve === null) return null;
  return {
    title,
    x,
    y,
    ...(hidden ? { hidden } : {}),
    ...(equal === undefined ? {} : { equal }),
    ...(to === undefined ? {} : { to }),
    ...(curve ? { exact: curve } : {}),
  };
}

function curveFrom(value: unknown): { label: string; expression: string } | null {
  if (!isRecord(value)) return null;
  const { label, expression } = value;
  if (typeof label !== 'string' || label.length > 200 || typeof expression !== 'string') return null;
  try {
    compileExpression(expression, { variables: ['t'] });
    return { label, expression };
  } catch {
    return null;
  }
}

const isRecord = (value: unknown): value is Record<string, unknown> =>
  typeof value === 'object' && value !== null && !Array.isArray(value);
const isName = (value: unknown): value is string => typeof value === 'string' && value.length <= 100;
const areNames = (value: unknown): value is string[] =>
  Array.isArray(value) && value.length <= MOST_COLUMNS && value.every(isName);
