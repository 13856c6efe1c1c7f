import { spawnSync } from 'node:child_process';
import { expect, test } from 'vitest';

test('a run written to a slow pipe arrives whole: a write that takes only part of it goes on', () => {
  const scenario = { version: 1, system: 'rolling-wheel', initial: { phi_dot: 3, theta_dot: 1 }, duration: 30 };
  const command = `'${process.execPath}' --import tsx src/cli/main.ts simulate - | (sleep 1; wc -l)`;
  const { stdout } = spawnSync('sh', ['-c', command], { input: JSON.stringify(scenario), encoding: 'utf8' });
  expect(Number(stdout)).toBe(1 + 3001 + 2);
}, 60_000);

test('what a fixed step passes over is said on standard error and behind the table', () => {
  const scenario = {
    version: 1,
    system: 'rolling-wheel',
    inputs: { tau_phi: 'exp(-((t-0.5)/0.0003)^2)' },
    method: { name: 'rk4', step: 0.01 },
    duration: 1,
  };
  const { stdout, stderr, status } = spawnSync(
    process.execPath,
    ['--import', 'tsx', 'src/cli/main.ts', 'simulate', '-'],
    { input: JSON.stringify(scenario), encoding: 'utf8' },
  );
  expect(status).toBe(0);
  expect(stderr).toMatch(/^warning: tau_phi changes within a step at t = 0\.4\d+ s: a fixed step of 0\.01 s/m);
  const lines = stdout.trimEnd().split('\n');
  expect(lines[0]).toMatch(/^t,X,Y/);
  expect(lines.at(-3)).toBe(`# scenario: ${JSON.stringify(scenario)}`);
  expect(lines.at(-2)).toBe('# engine: typescript');
  expect(lines.at(-1)).toMatch(/^# warning: tau_phi/);
  expect(lines.length).toBe(1 + 101 + 3);
}, 60_000);
