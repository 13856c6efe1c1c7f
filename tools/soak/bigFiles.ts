/** Large tables on disk, written piece by piece and taken away afterwards. */
import { closeSync, mkdtempSync, openSync, rmSync, writeSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { COORDINATES } from '../../tests/browser/helpers.ts';

export interface BigFile {
  path: string;
  rows: number;
  bytes: number;
  remove(): void;
}

/** A ride of the board with its rates, 21 columns, 1000 rows a second, at least so many bytes. */
export function bigTable(name: string, bytes: number): BigFile {
  const folder = mkdtempSync(join(tmpdir(), 'ripstik-'));
  const path = join(folder, name);
  const file = openSync(path, 'w');
  let [rows, written] = [
    0,
    writeSync(file, `${['t', ...COORDINATES, ...COORDINATES.map((c) => `${c}_dot`)].join(',')}\n`),
  ];
  try {
    while (written < bytes) {
      const lines: string[] = [];
      for (let k = 0; k < 4000; k++, rows++) lines.push(line(rows / 1000));
      written += writeSync(file, `${lines.join('\n')}\n`);
    }
  } finally {
    closeSync(file);
  }
  return { path, rows, bytes: written, remove: () => rmSync(folder, { recursive: true, force: true }) };
}

function line(t: number): string {
  const cells = [t.toFixed(3)];
  const wave = (k: number, rate: number): number => 0.3 * Math.sin((1 + 0.13 * k) * t + k + rate * 1.5708);
  for (const rate of [0, 1])
    COORDINATES.forEach((c, k) =>
      cells.push((c === 'X' ? (rate ? 1 : t) : c === 'Z' ? (rate ? 0 : 0.08) : wave(k, rate)).toFixed(9)),
    );
  return cells.join(',');
}
