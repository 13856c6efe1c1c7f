/** A plot as a picture or as numbers. */
import { download } from '../../app/files/download.ts';
import type { App } from '../../app/app.ts';
import { plotSheet } from '../../charts/svgPlot.ts';
import { token } from '../../charts/tokens.ts';
import { writeCsv } from '../../csv/csv.ts';
import { unitsOf, type Column } from '../../core/motion/columns.ts';
import { curvesOf, limits } from './drawing.ts';
import type { PaneProps } from './paneView.tsx';
import { stylesOf } from './style.ts';

const fileName = (title: string): string =>
  title
    .replace(/[^\w-]+/g, '-')
    .replace(/^-|-$/g, '')
    .toLowerCase() || 'plot';

/** As it stands, on the page's surface. */
export function savePng(host: HTMLElement, title: string): void {
  const sheets = [...host.querySelectorAll('canvas')];
  if (!sheets[0]) return;
  const canvas = Object.assign(document.createElement('canvas'), { width: sheets[0].width, height: sheets[0].height });
  const context = canvas.getContext('2d')!;
  context.fillStyle = token('--surface');
  context.fillRect(0, 0, canvas.width, canvas.height);
  for (const sheet of sheets) context.drawImage(sheet, 0, 0);
  canvas.toBlob((blob) => {
    if (blob) download(`${fileName(title)}.png`, [blob], 'image/png');
  });
}

/** Lines as lines, on white. */
export function saveSvg(props: PaneProps, app: App, infoOf: (name: string) => Column): void {
  const { pane } = props;
  const { degrees } = app.state.plots.peek();
  const styles = stylesOf(pane.y.map(infoOf));
  const { curves } = curvesOf(props, infoOf, degrees, styles, 1000);
  const labels = [...pane.y.filter((name) => !pane.hidden?.includes(name)), ...(pane.exact ? [pane.exact.label] : [])];
  const x = infoOf(pane.x);
  const svg = plotSheet([
    {
      title: pane.title,
      equal: pane.equal,
      xLabel: `${pane.x}${x.unit ? `, ${unitsOf([x], degrees)}` : ''}`,
      yLabel: unitsOf(pane.y.map(infoOf), degrees),
      lines: curves.map((c, i) => ({ label: labels[i] ?? '', x: c.x, y: c.y })),
    },
  ]);
  download(`${fileName(pane.title)}.svg`, [svg], 'image/svg+xml');
}

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
