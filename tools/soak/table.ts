/** What a soak has to tell, as a table for docs/robustness.md. */
import type { Reading } from './gauges.ts';

interface Told {
  counts: Readonly<Record<string, number>>;
  start: Reading;
  readings: readonly Reading[];
  /** Of the page's process, bytes; 0 where it is not known. */
  peak: number;
  minutes: number;
  seed: number;
}

const LINES: readonly [keyof Reading, string, (value: number) => string][] = [
  ['objects', 'script objects', (v) => `${(v / 1e6).toFixed(1)} MB`],
  ['code', 'compiled code', (v) => `${(v / 1e6).toFixed(1)} MB`],
  ['buffers', 'buffers', (v) => `${(v / 1e6).toFixed(1)} MB`],
  ['nodes', 'DOM nodes', String],
  ['listeners', 'listeners', String],
  ['workers', 'workers', String],
  ['geometries', 'geometries on the graphics card', String],
  ['textures', 'textures', String],
  ['programs', 'shader programs', String],
];

export function soakTable({ counts, start, readings, peak, minutes, seed }: Told): string {
  const all = Object.values(counts).reduce((a, b) => a + b, 0);
  const end = readings.at(-1)!;
  return [
    `${all.toLocaleString('en')} acts in ${minutes.toFixed(0)} minutes without a pause, seed ${seed}: ${Object.entries(
      counts,
    )
      .map(([name, n]) => `${name} ${n}`)
      .join(', ')}.`,
    `Errors, refused policies, foreign requests, stray words on the page: none. Lost: nothing.${peak > 0 ? ` The page's process held at most ${(peak / 1e6).toFixed(0)} MB.` : ''}`,
    '',
    '| at the base, after collecting | start | end | most in between |',
    '|---|--:|--:|--:|',
    ...LINES.map(
      ([key, name, write]) =>
        `| ${name} | ${write(start[key])} | ${write(end[key])} | ${write(Math.max(...readings.map((r) => r[key])))} |`,
    ),
    '',
    `\`npm run soak -- ${Math.round(minutes)} ${seed}\``,
    '',
  ].join('\n');
}
