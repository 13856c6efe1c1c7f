/** What one plot is given. */
import type { Signal } from '@preact/signals';
import type { Motion } from '../../app/runs/motion.ts';
import type { PlotPane } from '../../app/state/plotPanes.ts';
import type { Column } from '../../core/motion/columns.ts';
import type { ColumnValues } from '../../core/motion/columnValues.ts';

export interface PaneProps {
  pane: PlotPane;
  motion: Motion;
  /** What can be chosen of: it may come a little later than the motion. */
  choices: readonly Column[];
  values(name: string): ColumnValues;
  /** Of all plots over time; null for the whole. */
  range: Signal<readonly [number, number] | null>;
  first: boolean;
  onChange(pane: PlotPane | null): void;
  onUp(): void;
}
