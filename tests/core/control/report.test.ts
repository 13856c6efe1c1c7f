import { execFileSync, spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, describe, expect, test } from 'vitest';
import { controlReport, type ControlReport } from '../../../src/core/control/design/report.ts';
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
    expect(printed).toEqual(reportOf(balanced));
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
