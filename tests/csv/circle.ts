// One motion, as every file of the suite holds it: on a circle of 1 m at 0.8 rad/s, 101 rows, 20 ms apart.
import { expect } from 'vitest';
import type { CsvOptions, CsvResult } from '../../src/csv/csv.ts';
import { CsvByteReader } from '../../src/csv/reading/byteReader.ts';
import { metas } from '../helpers.ts';

export const N = 101;
export const f = (x: number): string => x.toFixed(6);
export const deg = (x: number): string => f((x * 180) / Math.PI);
export const states = Array.from(
  { length: N },
  (_, i) => [i / 50, Math.sin(i / 62.5), 1 - Math.cos(i / 62.5), i / 62.5] as const,
);
export const base = states.map((row) => row.map(f));
export const comma = (text: string): string => text.replaceAll('.', ',');
export const table = (head: string, rows: readonly (readonly string[])[], by = ','): string =>
  `${head}${rows.map((row) => row.join(by)).join('\n')}\n`;
export function expectCircle(motion: Extract<CsvResult, { kind: 'motion' }>): void {
  expect(motion).toMatchObject({ systemId: 'chaplygin-sleigh', rows: N, skippedRows: 0 });
  for (const [i, state] of states.entries())
    for (const [k, name] of ['t', 'x', 'y', 'theta'].entries()) {
      const read = motion.data[motion.columns.indexOf(name)]![i]!;
      expect(Math.abs(read - state[k]!), `${name} of row ${i}: ${read}`).toBeLessThan(5e-6);
    }
}

export function readBytes(bytes: Uint8Array, options: Partial<CsvOptions> = {}): CsvResult {
  const reader = new CsvByteReader({ systems: metas, data: true, unasked: true, ...options }, bytes.length);
  reader.push(bytes);
  return reader.finish();
}

export function motionOf(file: string | Uint8Array, options: Partial<CsvOptions> = {}) {
  const result = readBytes(typeof file === 'string' ? new TextEncoder().encode(file) : file, options);
  if (result.kind !== 'motion') throw new Error(JSON.stringify(result));
  return result;
}
