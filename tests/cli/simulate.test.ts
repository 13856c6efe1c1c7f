import { spawn, spawnSync } from 'node:child_process';
import {
  existsSync,
  linkSync,
  mkdirSync,
  mkdtempSync,
  readdirSync,
  readFileSync,
  symlinkSync,
  writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { expect, test } from 'vitest';

const WHEEL = { version: 1, system: 'rolling-wheel', inputs: { tau_phi: 0.1 }, duration: 1 };
const COMMAND = ['--import', 'tsx', 'src/cli/main.ts'];

function place(scenario: object = WHEEL): { folder: string; file: string } {
  const folder = mkdtempSync(join(tmpdir(), 'simulate-'));
  const file = join(folder, 's.json');
  writeFileSync(file, JSON.stringify(scenario));
  return { folder, file };
}

function simulate(...args: string[]) {
  return spawnSync(process.execPath, [...COMMAND, 'simulate', ...args], { encoding: 'utf8' });
}

test('the scenario is never written over, by its name or by a link', () => {
  const { folder, file } = place();
  symlinkSync(file, join(folder, 'soft.csv'));
  linkSync(file, join(folder, 'hard.csv'));
  for (const out of ['s.json', 'soft.csv', 'hard.csv', '../' + folder.split('/').at(-1)! + '/s.json']) {
    const { status, stderr, stdout } = simulate(file, '--out', join(folder, out));
    expect([status, stdout], out).toEqual([2, '']);
    expect(stderr, out).toMatch(/ripstik: --out .* is the scenario itself: name another file for the run\n$/);
  }
  expect(JSON.parse(readFileSync(file, 'utf8'))).toEqual(WHEEL);
  expect(readdirSync(folder).sort()).toEqual(['hard.csv', 's.json', 'soft.csv']);
}, 60_000);

test('a link to another file stays a link, and the file gets the run', () => {
  const { folder, file } = place();
  writeFileSync(join(folder, 'real.csv'), 'before');
  symlinkSync(join(folder, 'real.csv'), join(folder, 'link.csv'));
  expect(simulate(file, '--out', join(folder, 'link.csv')).status).toBe(0);
  expect(readFileSync(join(folder, 'real.csv'), 'utf8')).toMatch(/^t,X,Y/);
  expect(readdirSync(folder).sort()).toEqual(['link.csv', 'real.csv', 's.json']);
}, 60_000);

test('what cannot be written is one line, without a trace', () => {
  const { folder, file } = place();
  mkdirSync(join(folder, 'folder'));
  for (const [out, why] of [
    ['/dev/full', 'the disk is full'],
    [join(folder, 'none', 'run.csv'), 'there is no such folder'],
    [join(folder, 's.json', 'run.csv'), 'a part of its path is no folder'],
    [join(folder, 'folder'), 'it is a folder'],
  ] as const) {
    if (out === '/dev/full' && !existsSync(out)) continue;
    const { status, stderr } = simulate(file, '--out', out);
    expect(status, out).toBe(2);
    expect(stderr, out).toBe(`ripstik: ${out} can't be written: ${why}\n`);
  }
}, 60_000);

test('standard output that is full is one line too', () => {
  if (!existsSync('/dev/full')) return;
  const { file } = place();
  for (const command of ['simulate', 'point']) {
    const shell = `'${process.execPath}' ${COMMAND.join(' ')} ${command} '${file}' > /dev/full`;
    const { status, stderr } = spawnSync('sh', ['-c', shell], { encoding: 'utf8' });
    expect([status, stderr]).toEqual([2, "ripstik: standard output can't be written: the disk is full\n"]);
  }
}, 60_000);

test('an interrupted run leaves what stood there', async () => {
  const { folder, file } = place({
    ...WHEEL,
    duration: 1e5,
    outputStep: 1,
    method: { name: 'rk4', step: 1e-4 },
  });
  const out = join(folder, 'run.csv');
  writeFileSync(out, 'before');
  const child = spawn(process.execPath, [...COMMAND, 'simulate', file, '--out', out], { stdio: 'ignore' });
  const ended = new Promise((resolve) => child.on('exit', (_code, signal) => resolve(signal)));
  let over = false;
  void ended.then(() => (over = true));
  while (readdirSync(folder).length < 3 && !over) await new Promise((resolve) => setTimeout(resolve, 20));
  child.kill('SIGINT');
  expect(await ended).toBe('SIGINT');
  expect(readFileSync(out, 'utf8')).toBe('before');
  expect(readdirSync(folder).sort()).toEqual(['run.csv', 's.json']);
}, 60_000);

test('--verify tells on standard output how many digits hold, and behind the table in words', () => {
  const { folder, file } = place();
  const out = join(folder, 'run.csv');
  const { status, stdout } = simulate(file, '--out', out, '--verify');
  expect(status).toBe(0);
  const { digits, until, against } = JSON.parse(stdout) as {
    digits: [number, number][];
    until: Record<string, number>;
    against: { name: string };
  };
  expect(digits.length).toBe(101);
  expect(digits[0]).toEqual([0, 15]);
  expect(digits.at(-1)![0]).toBe(1);
  expect(until).toEqual({ 4: 1, 2: 1, 1: 1 });
  expect(against.name).toBe('dop853');
  expect(readFileSync(out, 'utf8').trimEnd().split('\n').at(-1)).toMatch(/^# trust: right to 4 digits until t = 1 s/);
}, 60_000);

test('--verify without a file leaves standard output to the table', () => {
  const { file } = place({ ...WHEEL, system: 'ripstik', inputs: {}, initial: { alpha: '10 deg' } });
  const { status, stdout, stderr } = simulate(file, '--verify');
  expect(status, stderr).toBe(3);
  expect(stdout).toMatch(/^t,X,Y,Z/);
  const json = stderr.split('\n').find((line) => line.startsWith('{'))!;
  const { digits, until } = JSON.parse(json) as { digits: [number, number][]; until: Record<string, number> };
  expect(until['4']).toBe(digits.at(-1)![0]);
  expect(stderr).toMatch(/stopped early: touchdown/);
}, 60_000);

test('--verify for another command is refused', () => {
  const { stderr, status } = spawnSync(process.execPath, [...COMMAND, 'cases', '--verify'], { encoding: 'utf8' });
  expect([status, stderr]).toEqual([2, 'ripstik: --verify is for simulate\n']);
}, 60_000);
