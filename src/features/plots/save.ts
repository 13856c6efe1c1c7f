/** A plot as numbers. */
import { download } from '../../app/files/download.ts';
import { writeCsv } from '../../csv/csv.ts';
import { fileName } from '../../ui/kit/saveMenu.tsx';
import { limits } from './drawing.ts';
import type { PaneProps } from './paneProps.ts';

/** Every row of the times that are shown, SI and radians. */
export function saveCsv({ pane, motion, values, range }: PaneProps): void {
  const [from, to] = limits(motion, range.peek(), pane.to);
  const t = motion.trajectory.column('t')!;
  const names = ['t', ...new Set([pane.x, ...pane.y].filter((name) => name !== 't'))];
  const rows = Array.from(t.keys()).filter((i) => t[i]! >= from && t[i]! <= to);
  const data = names.map((name) => {
    const column = name === 't' ? t : values(name).get();
    return Float64Array.from(rows, (i) => column[i] ?? NaN);
  });
  download(`${fileName(pane.title)}.csv`, [writeCsv(names, data)], 'text/csv');
}
