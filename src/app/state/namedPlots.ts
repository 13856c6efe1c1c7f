/** Plots that a page around this one, or a lesson, names: which motion they belong to. */
import { DATA } from '../../core/motion/dataView.ts';
import type { Motion } from '../runs/motion.ts';
import { MOST_PANES, paneFrom, type PlotPane } from './plotPanes.ts';

/**
 * What plots belong to: another case or system brings its own.
 *
 * @param motion on the stage
 * @param caseId of the case in the panel
 */
export const plotsKey = (motion: Motion, caseId: string): string =>
  `${motion.system.meta.id}/${motion.source === 'run' ? caseId : motion.system.meta.id === DATA ? motion.title : ''}`;

/**
 * Panes as a stranger names them; without a title they are called after their columns.
 *
 * @param value a list of `{y: ["alpha"], x?: "t", title?}`
 * @returns null for anything else
 */
export function panesFrom(value: unknown): readonly PlotPane[] | null {
  if (!Array.isArray(value) || value.length > MOST_PANES) return null;
  const panes = value.map((pane: unknown) => {
    if (typeof pane !== 'object' || pane === null) return null;
    const { y } = pane as { y?: unknown };
    return Array.isArray(y) && y.length > 0 ? paneFrom({ x: 't', title: y.join(', '), ...pane }) : null;
  });
  return panes.every((pane) => pane !== null) ? panes : null;
}
