import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, test } from 'vitest';
import { accelerations } from '../../src/cli/bench/accelerations.ts';
import { here } from '../../src/cli/bench/apart.ts';
import { Checksum, QUICK, quantile } from '../../src/cli/bench/measure.ts';
import { formulations } from '../../src/core/mechanics/formulations/formulations.ts';
import { methods } from '../../src/core/integrators/methods.ts';
import { measureAll, type Measured } from '../../src/cli/bench/measureAll.ts';
import { fillPage, picturesOf, tables, type Results } from '../../src/cli/bench/report.ts';
import {
  BRIEF,
  costAt,
  csvOf,
  workPrecision,
  type Problem,
  type WorkPoint,
} from '../../src/cli/bench/workPrecision.ts';

const ids = methods.map((m) => m.id);
const docs = (name: string): string => readFileSync(new URL(`../../docs/${name}`, import.meta.url), 'utf8');

describe('the bench measures everything', () => {
  let measured: Measured;
  beforeAll(async () => {
    measured = await measureAll(true, () => {});
  });

  test('accelerations: every formulation, all the same mechanics', () => {
    const { acceleration, microsecondsPerConstrainedAcceleration } = measured.results;
    expect(microsecondsPerConstrainedAcceleration).toBe(acceleration.acceleration.median);
    expect(Object.keys(acceleration.formulations)).toEqual(formulations.map((f) => f.id));
    for (const times of [acceleration.acceleration, ...Object.values(acceleration.formulations)]) {
      expect(times.least).toBeLessThanOrEqual(times.median);
      expect(times.samples).toBe(QUICK.samples);
      expect(times.count).toBeGreaterThan(0);
    }
    expect(acceleration.states).toBeGreaterThanOrEqual(256);
    expect(acceleration.disagreement).toBeLessThan(1e-8);
  });

  test('checksums say what was computed: the same again for the same, another for another', () => {
    const again = accelerations(QUICK);
    expect(again.checksum).toBe(measured.results.acceleration.checksum);
    const work = workPrecision('coasting', BRIEF, here);
    expect(work.checksum).toBe(measured.work.coasting.checksum);
    expect(work.checksum).not.toBe(measured.work.falling.checksum);
    const [one, other] = [new Checksum(), new Checksum()];
    one.add(1);
    other.add(1 + Number.EPSILON);
    expect(one.text).not.toBe(other.text);
  });

  test('steps: every method on both boards', () => {
    const { stepping, stepsPerSecond } = measured.results;
    for (const board of [stepping.hanging, stepping.coasting]) {
      expect(Object.keys(board)).toEqual(ids);
      for (const report of Object.values(board)) expect(report.steps).toBeGreaterThan(10);
    }
    for (const id of ids) expect(stepsPerSecond[id]).toBe(stepping.coasting[id]!.stepsPerSecond);
  });

  test('MuJoCo computes the same mechanics', () => {
    expect(measured.results.rival.disagreement).toBeLessThan(1e-9);
    expect(measured.results.rival.ratio).toBeGreaterThan(0);
  });

  test.each(['coasting', 'falling'] as const)(
    'work and precision: every method on the %s board gets better with more work',
    (problem) => {
      const { points, floor } = measured.work[problem];
      expect(new Set(points.map((p) => p.method))).toEqual(new Set(ids));
      expect(floor).toBeLessThan(1e-5);
      for (const id of ids) {
        const own = points.filter((p) => p.method === id && (p.stages ?? 3) === 3);
        // Half a thousand Euler steps don't survive the falling board's first second.
        expect(own.length, id).toBe(problem === 'falling' && id === 'euler' ? 1 : 2);
        if (own.length === 1) continue;
        expect(own[1]!.error, id).toBeLessThan(own[0]!.error);
        expect(own[1]!.evaluations, id).toBeGreaterThan(own[0]!.evaluations);
      }
      expect(csvOf(measured.work[problem]).trim().split('\n')).toHaveLength(points.length + 1);
      for (const svg of Object.values(picturesOf(problem, measured.work[problem]))) {
        for (const id of new Set(points.filter((p) => p.error < 1).map((p) => p.method)))
          expect(svg).toContain(`>${id}</text>`);
        expect(svg).not.toMatch(/NaN|Infinity|undefined/);
      }
    },
  );

  test('the race: whoever of the report is there, and the default', () => {
    const { entries, duration } = measured.results.race;
    expect(entries.map((e) => e.id)).toEqual(expect.arrayContaining(['qr', 'collocation', 'blt', 'dopri5']));
    for (const entry of entries) {
      expect(entry.reached).toBe(duration);
      expect(entry.energyDrift).toBeLessThan(0.02);
      expect(entry.residual).toBeLessThan(1e-12);
    }
  });

  test('every table has its place on the page', () => {
    const filled = fillPage(docs('performance.md'), tables(measured.results));
    expect(filled).toContain(measured.results.acceleration.checksum);
    expect(filled).not.toMatch(/NaN|Infinity|undefined/);
    expect(() => fillPage('', { machine: '' })).toThrow('no place for machine');
  });
});

describe('the page', () => {
  test('its numbers are those of the stored measurement', () => {
    const page = docs('performance.md');
    expect(fillPage(page, tables(JSON.parse(docs('bench/results.json')) as Results))).toBe(page);
  });

  test.each(['coasting', 'falling'] as const)('its diagrams are those of the stored points: %s', (problem: Problem) => {
    const [head, ...rows] = docs(`bench/${problem}.csv`)
      .trim()
      .split('\n')
      .map((line) => line.split(','));
    const points = rows.map(
      (row) => Object.fromEntries(head!.map((name, c) => [name, valueOf(name, row[c]!)])) as unknown as WorkPoint,
    );
    const { floor } = (JSON.parse(docs('bench/results.json')) as Results).precision[problem];
    for (const [name, svg] of Object.entries(picturesOf(problem, { points, floor, checksum: '' })))
      expect(svg).toBe(docs(`bench/${name}`));
  });
});

function valueOf(name: string, text: string): string | number | null {
  return name === 'method' ? text : text === '' ? null : Number(text);
}

test('quantiles, and a cost between two points of a curve', () => {
  expect([0, 0.25, 0.5, 1].map((share) => quantile([4, 1, 3, 2, 5], share))).toEqual([1, 2, 3, 5]);
  const points = [
    { error: 1e-2, evaluations: 10 },
    { error: 1e-4, evaluations: 1000 },
  ] as WorkPoint[];
  expect(costAt(points, 1e-3, 'evaluations')).toBeCloseTo(100, 9);
  expect(costAt(points, 1e-5, 'evaluations')).toBeNull();
});
