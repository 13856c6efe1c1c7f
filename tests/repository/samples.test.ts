// The recorded motions in public/data: they read as motions, and a fresh run of what they name gives the same numbers.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, test } from 'vitest';
import { recordSample, samples } from '../../scripts/write-samples.ts';
import { samples as offered } from '../../src/app/files/samples.ts';
import { parseScenario } from '../../src/core/scenario/schema.ts';
import { readCsv, type CsvResult } from '../../src/csv/csv.ts';
import { metas } from '../helpers.ts';

/** Files hold ten decimals, and another machine's sine may differ in the last bit. */
const AGREE = 1e-9;
/** The falling board is chaotic: a last bit at the start is 1e-9 after 1.6 s and the whole motion after 5 (docs/ripstik.md). */
const UNTIL: Readonly<Record<string, number>> = { 'falling-report.csv': 1.2 };
const LARGEST = 250_000;
const SHAPES: Readonly<Record<string, { rows: number; columns: number; end: number }>> = {
  'ridden.csv': { rows: 601, columns: 25, end: 10 },
  'falling-report.csv': { rows: 349, columns: 11, end: 5.8 },
  'headerless.csv': { rows: 241, columns: 11, end: 4 },
};

const text = (file: string): string => readFileSync(join('public/data', file), 'utf8');

function motionIn(file: string): Extract<CsvResult, { kind: 'motion' }> {
  const bare = samples.find((s) => s.file === file)?.bare;
  const result = readCsv(text(file), { systems: metas, ...(bare ? { timeStep: 1 / 60 } : {}) });
  if (result.kind !== 'motion') throw new Error(`${file} reads as ${JSON.stringify(result)}`);
  return result;
}

test('every sample that the page offers is there, and no other is written', () => {
  expect(offered.map((s) => s.url).sort()).toEqual(samples.map((s) => `data/${s.file}`).sort());
});

describe.each(samples)('$file', (sample) => {
  const motion = motionIn(sample.file);

  test('reads as a motion of the board without a row lost', () => {
    const { rows, columns, end } = SHAPES[sample.file]!;
    expect(motion).toMatchObject({ systemId: 'ripstik', rows, skippedRows: 0, issues: [] });
    expect(motion.columns).toHaveLength(columns);
    expect(motion.columns[0]).toBe('t');
    expect(motion.data[0]!.at(-1)).toBeCloseTo(end, 9);
    expect(text(sample.file).length).toBeLessThan(LARGEST);
  });

  test('a fresh run gives the same numbers', () => {
    const fresh = recordSample(sample);
    const rows = motion.data[0]!.filter((t) => t <= (UNTIL[sample.file] ?? Infinity)).length;
    expect(fresh.data[0]).toHaveLength(motion.rows);
    fresh.columns.forEach((name, c) => {
      const read = motion.data[motion.columns.indexOf(name)]!;
      const differences = fresh.data[c]!.subarray(0, rows).map((value, row) => Math.abs(value - read[row]!));
      expect(Math.max(...differences), name).toBeLessThan(AGREE);
    });
  });

  test('names the scenario it was made with, or nothing at all', () => {
    if (sample.bare) {
      expect(readCsv(text(sample.file), { systems: metas })).toMatchObject({ kind: 'needs-time-step', columns: 10 });
      expect(motion.scenario).toBeNull();
      return;
    }
    expect(motion.scenario).toEqual(sample.scenario);
    const scenario = parseScenario(JSON.stringify(motion.scenario), metas);
    expect(scenario.constraints).toBe(sample.scenario.constraints ?? 'rolling');
  });
});

test('the degrees of the falling board are read as radians', () => {
  const motion = motionIn('falling-report.csv');
  expect(text('falling-report.csv')).toContain('alpha [deg]');
  expect(motion.data[motion.columns.indexOf('alpha')]![0]).toBeCloseTo(Math.PI / 18, 12);
});
