import { spawnSync } from 'node:child_process';
import { expect, test } from 'vitest';

test('a run written to a slow pipe arrives whole: a write that takes only part of it goes on', () => {
  const scenario = { version: 1, system: 'rolling-wheel', initial: { phi_dot: 3, theta_dot: 1 }, duration: 30 };
  const command = `'${process.execPath}' --import tsx src/cli/main.ts simulate - | (sleep 1; wc -l)`;
  const { stdout } = spawnSync('sh', ['-c', command], { input: JSON.stringify(scenario), encoding: 'utf8' });
  expect(Number(stdout)).toBe(1 + 3001);
}, 60_000);
