import { describe, expect, test } from 'vitest';
import { cases } from '../../../src/core/systems/registry.ts';
import { withAxisValue, type SweepAxis } from '../../../src/core/scenario/sweepAxes.ts';
import { spaced, sweepPaths } from '../../../src/core/scenario/sweepPaths.ts';
import { extrasFor, RunMeasurer, type SweepMeasure } from '../../../src/core/motion/sweepMeasures.ts';
import type { ScenarioFile } from '../../../src/core/scenario/types.ts';
import { systems } from '../../../src/core/systems/all.ts';
import { metas, runOf, scenarioOf } from '../../helpers.ts';

const axis = (path: string): SweepAxis => ({ path, label: '', unit: '', angle: false, values: [] });

describe('axes', () => {
  test('reach both ends, evenly or by equal ratios', () => {
    expect(spaced(0, 1, 5, 'linear')).toEqual([0, 0.25, 0.5, 0.75, 1]);
    expect(spaced(1e-3, 1e3, 7, 'logarithmic')).toEqual([1e-3, 1e-2, 0.1, 1, 10, 100, 1e3]);
    expect(spaced(-1, -100, 3, 'logarithmic')).toEqual([-1, -10, -100]);
    expect(spaced(3, 1, 3, 'linear')).toEqual([3, 2, 1]);
  });

  test.each([
    [0, 1, 1],
    [0, 1, 2.5],
    [0, 1, 2001],
    [1, 1, 3],
    [NaN, 1, 3],
  ])('refuse %d to %d in %d', (from, to, count) => {
    expect(() => spaced(from, to, count, 'linear')).toThrow();
  });

  test('a logarithmic one does not reach zero', () => {
    expect(() => spaced(0, 1, 3, 'logarithmic')).toThrow();
    expect(() => spaced(-1, 1, 3, 'logarithmic')).toThrow();
  });

  test('set one number, or the same in two places, and nothing else', () => {
    const file: ScenarioFile = {
      version: 1,
      system: 'ripstik',
      initial: { X_dot: 1, psi: 0 },
      control: { type: 'lqr', inputs: ['tau_fc'], at: { X_dot: 1 } },
    };
    const before = structuredClone(file);
    expect(withAxisValue(file, axis('parameters.casterTrail'), { value: 0.1, label: '' })).toEqual({
      ...file,
      parameters: { casterTrail: 0.1 },
    });
    expect(withAxisValue(file, axis('duration'), { value: 3, label: '' })).toEqual({ ...file, duration: 3 });
    expect(withAxisValue(file, axis('initial.X_dot+control.at.X_dot'), { value: 2, label: '' })).toEqual({
      ...file,
      initial: { X_dot: 2, psi: 0 },
      control: { type: 'lqr', inputs: ['tau_fc'], at: { X_dot: 2 } },
    });
    expect(withAxisValue(file, axis('method'), { value: 0, label: '', method: { name: 'ida' } })).toEqual({
      ...file,
      method: { name: 'ida' },
    });
    expect(file).toEqual(before);
  });

  test.each(cases.map((c) => [c.id, c.scenario] as const))(
    'every number offered for %s is one that the scenario takes',
    (_id, file) => {
      const checked = scenarioOf(file);
      const paths = sweepPaths(metas[file.system]!, file, checked);
      expect(new Set(paths.map((p) => p.path)).size).toBe(paths.length);
      for (const { path, present } of paths) {
        expect(Number.isFinite(present), path).toBe(true);
        // The number that is there now leaves the scenario as it is; unnamed starts become named ones.
        const same = scenarioOf(withAxisValue(file, axis(path), { value: present, label: '' }));
        expect(same.parameters, path).toEqual(checked.parameters);
      }
    },
  );
});

function measure(
  file: ScenarioFile,
  measures: readonly SweepMeasure[],
  chunk = Infinity,
): { values: number[]; run: ReturnType<typeof runOf> } {
  const run = runOf(file);
  const names = [...run.columns.keys()];
  const q = Float64Array.from(metas[file.system]!.coordinates, (c) => run.columns.get(c.name)![0]!);
  const measurer = new RunMeasurer(systems[file.system]!, scenarioOf(file).parameters, names, measures, q);
  for (let from = 0; from < run.rows; from += chunk) {
    const to = Math.min(run.rows, from + chunk);
    measurer.take(
      names.map((n) => run.columns.get(n)!.subarray(from, to)),
      to - from,
    );
  }
  return { values: measurer.result(run.end, run.counts, 1.5), run };
}

describe('measures', () => {
  const circle: ScenarioFile = {
    version: 1,
    system: 'rolling-wheel',
    initial: { theta: 0.3, phi_dot: 3, theta_dot: 1 },
    duration: 2,
    outputStep: 0.001,
  };

  test('a wheel that turns in a circle: its extremes, its end and the way it went', () => {
    const { values, run } = measure(circle, [
      { kind: 'end', column: 'X' },
      { kind: 'max', column: 'Y' },
      { kind: 'min', column: 'Y' },
      { kind: 'distance' },
      { kind: 'time' },
      { kind: 'seconds' },
      { kind: 'steps' },
      { kind: 'work' },
      { kind: 'costOfTransport' },
      { kind: 'end', column: 'nothing' },
    ]);
    const [end, max, min, distance, time, seconds, steps, work, transport, nothing] = values;
    expect(end).toBeCloseTo(3 * (Math.sin(2.3) - Math.sin(0.3)), 6);
    expect(max).toBeCloseTo(3 * (Math.cos(0.3) - Math.cos(2.3)), 5);
    expect(min).toBe(0);
    expect(distance).toBeCloseTo(6, 5);
    expect([time, seconds, steps]).toEqual([2, 1.5, run.counts.steps]);
    expect([work, transport, nothing]).toEqual([0, 0, NaN]);
  });

  test('are the same whatever chunks the rows come in', () => {
    const all: SweepMeasure[] = [
      { kind: 'end', column: 'theta' },
      { kind: 'max', column: 'X' },
      { kind: 'min', column: 'X' },
      { kind: 'distance' },
    ];
    const whole = measure(circle, all).values;
    for (const chunk of [1, 7, 512]) expect(measure(circle, all, chunk).values).toEqual(whole);
  });

  test('a torque that speeds a wheel up does the work that its energy gains; braking is not given back', () => {
    const drive = (torque: string): ScenarioFile => ({
      version: 1,
      system: 'rolling-wheel',
      inputs: { tau_phi: torque },
      duration: 2,
      outputStep: 0.001,
    });
    const measures: SweepMeasure[] = [{ kind: 'work' }, { kind: 'costOfTransport' }, { kind: 'distance' }];
    const { values, run } = measure(drive('0.5'), measures);
    const energy = run.columns.get('energy')!;
    expect(values[0]).toBeCloseTo(energy[energy.length - 1]! - energy[0]!, 6);
    const { parameters } = scenarioOf(drive('0.5'));
    const g = parameters['gravity'] ?? 9.81;
    const mass = metas['rolling-wheel']!.parameters.find((p) => p.unit === 'kg')!.name;
    expect(values[1]).toBeCloseTo(values[0]! / (parameters[mass]! * g * values[2]!), 9);
    const braked = measure(drive('0.5*cos(pi*t/2)'), measures).values[0]!;
    const peak = Math.max(...measure(drive('0.5*cos(pi*t/2)'), measures).run.columns.get('energy')!);
    expect(braked).toBeCloseTo(peak, 4);
  });

  test('ask a run for the columns they need and no others', () => {
    expect(extrasFor([{ kind: 'end', column: 'X' }, { kind: 'drift' }])).toEqual([]);
    expect(extrasFor([{ kind: 'max', column: 'lambda_2' }, { kind: 'costOfTransport' }])).toEqual(['lambda', 'inputs']);
    expect(
      extrasFor([
        { kind: 'max', column: 'tau_fc' },
        { kind: 'end', column: 'energy' },
        { kind: 'end', column: 'residual' },
      ]),
    ).toEqual(['energy', 'residual', 'inputs']);
  });
});
