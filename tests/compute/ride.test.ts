// A ride that is steered while the worker computes it, and its commands as a scenario in the command line: the same rows.
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { expect, test } from 'vitest';
import { RunClient, type RunHandlers } from '../../src/compute/client/runClient.ts';
import type { RideCommand, RideControl, ScenarioFile } from '../../src/core/scenario/types.ts';
import { scenarioOf } from '../helpers.ts';
import { starts, turn } from './nearWorker.ts';

const file: ScenarioFile = {
  version: 1,
  system: 'ripstik-rider',
  parameters: { wheelDrag: 0.5 },
  initial: { beta: '1 deg' },
  control: { type: 'ride', commands: [[0.1, 'start', 1]] },
  method: { rtol: 1e-6, atol: 1e-8 },
  duration: 1.5,
};
/** Told when the ride has come so far, s. */
const script: RideCommand[] = [
  [0.2, 'twist', 0.35],
  [0.5, 'pump', 0.7],
  [0.9, 'straight', 1],
  [1.1, 'help', 0.9],
];

test('what is steered in the worker is repeated by the command line to the last bit', async () => {
  const client = new RunClient(starts());
  const columns = new Map<string, number[]>();
  const told: RideCommand[] = [];
  let names: string[] = [];
  const end = await new Promise<string>((resolve, reject) => {
    let next = 0;
    const handlers: RunHandlers = {
      started: (all) => (names = all).forEach((name) => columns.set(name, [])),
      rows(data, rows, time) {
        names.forEach((name, i) => columns.get(name)!.push(...data[i]!.subarray(0, rows)));
        for (; next < script.length && script[next]![0] <= time; next++)
          client.steer({ command: [script[next]![1], script[next]![2], 0] });
        void turn().then(() => client.steer({ ready: true }));
      },
      told: (command) => void told.push(command),
      ended: ({ reason }) => resolve(reason),
      refused: (path, message) => reject(new Error(`${path}: ${message}`)),
    };
    client.start(scenarioOf(structuredClone(file)), handlers, { ride: { resume: 0, pace: 10 } });
  });
  client.close();
  expect(end).toBe('end');
  expect(told.map(([, name]) => name)).toEqual(script.map(([, name]) => name));

  const folder = mkdtempSync(join(tmpdir(), 'ride-'));
  const control = file.control as RideControl;
  const whole = { ...file, control: { ...control, commands: [...control.commands!, ...told] } };
  writeFileSync(join(folder, 'ride.json'), JSON.stringify(whole));
  const args = [
    '--import',
    'tsx',
    'src/cli/main.ts',
    'simulate',
    join(folder, 'ride.json'),
    '--out',
    join(folder, 'ride.csv'),
  ];
  const { status, stderr } = spawnSync(process.execPath, args, { encoding: 'utf8' });
  expect(status, stderr).toBe(0);
  const [head, ...lines] = readFileSync(join(folder, 'ride.csv'), 'utf8')
    .split('\n')
    .filter((line) => line && !line.startsWith('#'));
  const rows = lines.map((line) => line.split(',').map(Number));
  expect(rows.length).toBe(columns.get('t')!.length);
  const shared = head!.split(',').flatMap((name, i) => (columns.has(name) ? [[name, i] as const] : []));
  expect(shared.length).toBeGreaterThan(22);
  for (const [name, i] of shared) expect(columns.get(name), name).toEqual(rows.map((row) => row[i]));
}, 60_000);
