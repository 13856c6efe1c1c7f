import { execFileSync, spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, describe, expect, test } from 'vitest';
import { controlReport, type ControlReport } from '../../../src/core/control/design/report.ts';
import { computerReport } from '../../../src/core/control/sampled/computerReport.ts';
import { systems } from '../../../src/core/systems/all.ts';
import { scenarioOf } from '../../helpers.ts';

const reportOf = (raw: Record<string, unknown>): ControlReport => {
  const scenario = scenarioOf({ version: 1, system: 'ripstik', ...raw });
  return controlReport(scenario, systems[scenario.system]!);
};
const balanced = { control: { type: 'lqr', inputs: ['tau_fc', 'tau_bc'], at: { X_dot: 1 } } };

describe('the report', () => {
  test('of a design has every part, with its shape', () => {
    const r = reportOf(balanced);
    expect(r.states).toHaveLength(20);
    expect(r.states[12]).toBe('Z_dot');
    expect([r.A.length, r.A[0]!.length, r.B.length, r.B[0]!.length]).toEqual([20, 20, 20, 2]);
    expect([r.K!.length, r.K![0]!.length]).toEqual([2, 20]);
    expect([r.eigenvalues.length, r.closedLoopEigenvalues!.length, r.uncontrollable.length]).toEqual([14, 14, 4]);
    expect(r.careResidual).toBeLessThan(1e-12);
    expect(r.orders.difference).toBeLessThan(1e-10);
    expect(r.closedLoop!.every((d) => d.damping! > 0 && d.timeConstant! > 0)).toBe(true);
    expect(JSON.parse(JSON.stringify(r))).toEqual(r);
  });

  test('without a controller takes the top-level point and every named input', () => {
    const r = reportOf({ at: { X_dot: 2 } });
    expect(r.point.v[0]).toBe(2);
    expect(r.inputs).toEqual(['tau_fp', 'tau_bp', 'tau_twist', 'tau_fc', 'tau_bc']);
    expect([r.K, r.closedLoopEigenvalues, r.careResidual]).toEqual([null, null, null]);
  });
});

describe('what a computer needs', () => {
  const of = (control: object | null, system = 'ripstik') =>
    computerReport(scenarioOf({ version: 1, system, ...(control ? { control } : {}) }), systems[system]!);

  test('is in the margins, as JSON has them', () => {
    const report = of(balanced.control);
    expect(Math.abs(report.margins!.sampleTime! / 0.001749 - 1)).toBeLessThan(2e-3);
    expect(Math.abs(report.margins!.delay! / 0.001365 - 1)).toBeLessThan(2e-3);
    expect(report.margins!.gain['tau_fc']![1]).toBe(null);
    expect(report.sampled).toBe(null);
    expect(JSON.parse(JSON.stringify(report))).toEqual(report);
  });

  test.each([
    [0.0017, 0, true],
    [0.0018, 0, false],
    [0.0001, 0.0013, true],
    [0.0001, 0.0014, false],
  ])('a sample time of %d s with a delay of %d s: stable %s', (sample, delay, stable) => {
    const { sampled } = of({ ...balanced.control, sample, delay });
    expect(sampled!.spectralRadius < 1).toBe(stable);
    expect(sampled!.riccatiResidual).toBe(null);
  });

  test('a sampled design is stable where the continuous one is not', () => {
    const { sampled } = of({ ...balanced.control, sample: 0.005, delay: 0.005, design: 'sampled' });
    expect(sampled!.spectralRadius).toBeLessThan(1);
    expect(sampled!.riccatiResidual).toBeLessThan(1e-8);
    expect(sampled!.moduli[0]).toBe(sampled!.spectralRadius);
    expect([sampled!.A.length, sampled!.B[0]!.length, sampled!.K.length]).toEqual([sampled!.moduli.length, 2, 2]);
  });

  test('is nothing without a regulator, and finite for every system that has one', () => {
    expect(of(null)).toEqual({ margins: null, sampled: null, estimator: null, controller: null });
    const pendulum = of({ type: 'lqr', inputs: ['tau_phi'] }, 'wheel-pendulum');
    expect(pendulum.margins!.sampleTime).toBeGreaterThan(0);
    expect(pendulum.margins!.delay).toBeGreaterThan(0);
  });
});

describe('the command line', () => {
  const folder = mkdtempSync(join(tmpdir(), 'linearize-'));
  afterAll(() => rmSync(folder, { recursive: true }));
  const call = (raw: unknown) => {
    const file = join(folder, 'scenario.json');
    writeFileSync(file, JSON.stringify(raw));
    return [process.execPath, ['--import', 'tsx', 'src/cli/main.ts', 'linearize', file]] as const;
  };

  test('linearize prints the report as JSON', () => {
    const [node, args] = call({ version: 1, system: 'ripstik', ...balanced });
    const printed = JSON.parse(execFileSync(node, args, { encoding: 'utf8' })) as ControlReport;
    const scenario = scenarioOf({ version: 1, system: 'ripstik', ...balanced });
    expect(printed).toEqual({ ...reportOf(balanced), ...computerReport(scenario, systems['ripstik']!) });
  });

  test.each([
    ['a point that is no steady motion', { at: { alpha_fp: 0.1 } }],
    ['an unstable mode that no input reaches', { control: { type: 'lqr', inputs: ['f_X'] } }],
    ['an unknown state', { control: { type: 'lqr', inputs: ['tau_fc'], Q: { roll: 1 } } }],
  ])('%s: status 2 and one line', (_, extra) => {
    const [node, args] = call({ version: 1, system: 'ripstik', ...extra });
    const { status, stderr, stdout } = spawnSync(node, args, { encoding: 'utf8' });
    expect({ status, stdout, lines: stderr.trim().split('\n').length }).toEqual({ status: 2, stdout: '', lines: 1 });
    expect(stderr).toMatch(/^ripstik: (at|control)/);
  });
});
