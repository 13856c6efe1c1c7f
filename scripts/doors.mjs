// npm run doors: the same scenarios through the page, the command line, the npm package and Python, compared to the bit; a study
// through the last three. Builds what it compares. It is no part of `npm test`, which needs no Python.
import { spawnSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { findBrowser } from './browser.mjs';
import { noPython, pip, venv } from './python.mjs';
import { serve } from './serve-dist.mjs';
import { Plain, cache, main, run } from './setup.mjs';

/* global window -- functions given to the page run there */

/** One of each kind of work: a regulator, a bicycle's free motion, stiff feet, events, an expression of time. */
const SCENARIOS = {
  regulated: {
    system: 'ripstik',
    initial: { X_dot: 1, alpha: '10 deg' },
    control: { type: 'lqr', inputs: ['tau_fc', 'tau_bc'], at: { X_dot: 1 } },
    duration: 2,
  },
  falling: { system: 'ripstik', initial: { X_dot: 1.3, alpha: '4 deg' }, duration: 2 },
  pumped: {
    system: 'ripstik',
    initial: { X_dot: 0.5 },
    inputs: { tau_fp: '0.4*sin(2*pi*1.5*t)', tau_bp: '-0.4*sin(2*pi*1.5*t)' },
    duration: 1,
  },
  bicycle: { system: 'bicycle', initial: { speed: 5, roll: 0.05 }, duration: 3 },
  wheel: { system: 'rolling-wheel', initial: { theta: 0.1 }, inputs: { tau_phi: '0.1*cos(3*t)' }, duration: 3 },
  implicit: { system: 'cart-pendulum', initial: { theta: '40 deg' }, method: { name: 'gauss' }, duration: 3 },
};
const STUDY = {
  version: 1,
  scenario: { version: 1, ...SCENARIOS.falling },
  vary: { 'initial.alpha': { uniform: ['-20 deg', '20 deg'] }, 'parameters.casterTrail': { list: [0.03, 0.05] } },
  sample: { kind: 'sobol', count: 40, seed: 7 },
  measures: ['final.X', 'max.alpha', 'drift'],
};

/** Columns by name as text that tells every bit: numbers as JavaScript writes them shortest, signs of zero kept. */
const text = (columns) =>
  Object.entries(columns)
    .map(([name, values]) => `${name}: ${Array.from(values, (v) => (Object.is(v, -0) ? '-0' : String(v))).join(' ')}`)
    .join('\n');
const digest = (columns) => createHash('sha256').update(text(columns)).digest('hex').slice(0, 16);

/** With --built what is there already is compared. */
main(async ([option]) => {
  if (option !== undefined && option !== '--built') throw new Plain(`"${option}" is not understood; there is --built.`);
  const missing = await noPython();
  if (missing) throw new Plain(`Not compared: ${missing}.`);
  // The wheel brings the package.
  for (const step of option === '--built' ? [] : ['wheel', 'build']) {
    const { code, output } = await run('npm', ['run', '--silent', step], { shell: process.platform === 'win32' });
    if (code !== 0) throw new Plain(`npm run ${step} failed; it says:\n${output.trim()}`);
  }
  const folder = mkdtempSync(join(tmpdir(), 'doors-'));
  try {
    const files = Object.fromEntries(
      Object.entries({ ...SCENARIOS, study: STUDY }).map(([name, scenario]) => {
        const path = join(folder, `${name}.json`);
        writeFileSync(path, JSON.stringify({ version: 1, ...scenario }));
        return [name, path];
      }),
    );
    const doors = {
      'command line': commandLine(files),
      npm: await library(files),
      Python: await python(files),
      page: await page(),
    };
    return report(doors);
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
});

const cli = join(cache, 'package/dist/cli.js');

function commandLine(files) {
  const say = (...args) => {
    const { stdout, stderr } = spawnSync(process.execPath, [cli, ...args], { encoding: 'utf8', maxBuffer: 1e9 });
    // A run that stops early has its table and a status of its own.
    if (stdout === '' && args[0] === 'simulate') throw new Plain(`${args.join(' ')} failed; it says:\n${stderr}`);
    return stdout;
  };
  const results = {};
  for (const [name, file] of Object.entries(files)) {
    if (name === 'study') {
      const out = file.replace('.json', '.csv');
      say('sweep', file, '--out', out);
      results[name] = tableOf(readFileSync(out, 'utf8'));
    } else results[name] = tableOf(say('simulate', file));
  }
  return results;
}

/** Of the command's CSV: columns of numbers, of words where a cell is none; an empty cell is NaN. */
function tableOf(csv) {
  const [header, ...rows] = csv
    .split('\n')
    .filter((line) => line !== '' && !line.startsWith('#'))
    .map((line) => line.split(','));
  const value = (cell) => (cell === '' ? NaN : Number.isNaN(Number(cell)) ? cell : Number(cell));
  return Object.fromEntries(header.map((name, c) => [name, rows.map((row) => value(row[c]))]));
}

async function library(files) {
  const { simulate, sweep } = await import(pathToFileURL(join(cache, 'package/dist/index.js')).href);
  const results = {};
  for (const [name, file] of Object.entries(files)) {
    const given = JSON.parse(readFileSync(file, 'utf8'));
    if (name === 'study') {
      const rows = [];
      for await (const row of sweep(given)) rows.push(row);
      rows.sort((a, b) => a.index - b.index);
      results[name] = {
        index: rows.map(({ index }) => index),
        ...Object.fromEntries(Object.keys(STUDY.vary).map((path, k) => [path, rows.map(({ values }) => values[k])])),
        ...Object.fromEntries(STUDY.measures.map((measure, k) => [measure, rows.map(({ measures }) => measures[k])])),
        reason: rows.map(({ reason }) => reason),
        time: rows.map(({ time }) => time),
      };
    } else {
      const done = await simulate(given);
      results[name] = Object.fromEntries(done.names.map((column) => [column, done.column(column)]));
    }
  }
  return results;
}

/** In an environment of its own, the wheel inside. */
async function python(files) {
  const at = await venv(join(cache, 'doors-venv'));
  const wheels = join(cache, 'wheel');
  await pip(at, ['install', '--no-index', join(wheels, readdirSync(wheels)[0])]);
  const program = `
import json, sys
from ripstik_lab import simulate, sweep
for name, path in json.load(sys.stdin).items():
    table = sweep(path) if name == "study" else simulate(path)
    plain = {c: [v if isinstance(v, str) else float(v).hex() for v in table[c]] for c in table.names}
    print(json.dumps([name, plain]))
`;
  const { stdout, stderr, status } = spawnSync(at, ['-c', program], {
    input: JSON.stringify(files),
    encoding: 'utf8',
    maxBuffer: 1e9,
    env: { ...process.env, RIPSTIK_NODE: process.execPath },
  });
  if (status !== 0) throw new Plain(`Python failed; it says:\n${stderr}`);
  const number = (value) => (typeof value === 'string' && /^-?(0x|nan|inf)/.test(value) ? fromHex(value) : value);
  return Object.fromEntries(
    stdout
      .trim()
      .split('\n')
      .map((line) => JSON.parse(line))
      .map(([name, columns]) => [
        name,
        Object.fromEntries(Object.entries(columns).map(([column, values]) => [column, values.map(number)])),
      ]),
  );
}

/** A double as Python's `float.hex` writes it: exact. */
function fromHex(written) {
  if (written === 'nan') return NaN;
  const [, sign, whole, fraction = '', power] = /^(-?)0x([01])(?:\.([0-9a-f]+))?p([+-]\d+)$/.exec(written);
  // Thirteen digits at most: an exact integer, and a power of two that leaves it exact.
  const digits = parseInt(whole + fraction.padEnd(13, '0'), 16);
  const exponent = Number(power) - 52;
  const size = exponent < -1022 ? digits * 2 ** -1022 * 2 ** (exponent + 1022) : digits * 2 ** exponent;
  return sign === '-' ? -size : size;
}

/** The built page in a browser: what is on its stage after the scenario was opened. */
async function page() {
  const { chromium } = await import('@playwright/test');
  const { server, port } = await serve({ port: 4300 });
  const browser = await chromium.launch({ executablePath: (await findBrowser()) || undefined, args: ['--no-sandbox'] });
  try {
    const view = await browser.newPage({ reducedMotion: 'reduce' });
    await view.goto(`http://127.0.0.1:${port}/`);
    await view.waitForFunction(() => window.ripstikApp?.state.run.value?.kind === 'ended', null, { timeout: 120_000 });
    const results = {};
    for (const [name, scenario] of Object.entries(SCENARIOS)) {
      await view.evaluate(
        ([title, file]) => window.ripstikApp.actions.loadScenario(file, title),
        [name, { version: 1, ...scenario }],
      );
      await view.waitForFunction(
        (title) => {
          const { motion, run } = window.ripstikApp.state;
          return motion.value?.title === title && run.value?.kind === 'ended';
        },
        name,
        { timeout: 120_000 },
      );
      results[name] = Object.fromEntries(
        await view.evaluate(() => {
          const { trajectory } = window.ripstikApp.state.motion.value;
          return trajectory.columns.map((column) => [column, Array.from(trajectory.column(column))]);
        }),
      );
    }
    return results;
  } finally {
    await browser.close();
    server.close();
  }
}

/** The columns of the command line through every door; the page has more of them, and no study. */
function report(doors) {
  let wrong = 0;
  const expected = doors['command line'];
  for (const name of Object.keys(expected)) {
    const columns = Object.keys(expected[name]);
    const found = Object.entries(doors)
      .filter(([, results]) => results[name])
      .map(([door, results]) => {
        const lacking = columns.filter((column) => !results[name][column]);
        if (lacking.length > 0) return [door, `lacks ${lacking[0]}`];
        return [door, digest(Object.fromEntries(columns.map((column) => [column, results[name][column]])))];
      });
    const same = new Set(found.map(([, of]) => of)).size === 1;
    if (!same) wrong++;
    const rows = expected[name][columns[0]].length;
    console.log(
      `${same ? 'same' : 'DIFFERENT'}  ${name}: ${rows} rows of ${columns.length} columns  ${found.map(([door, of]) => `${door} ${of}`).join('  ')}`,
    );
    if (!same)
      for (const [door, results] of Object.entries(doors))
        if (results[name]) where(door, columns, results[name], expected[name]);
  }
  return wrong === 0 ? 0 : 1;
}

/** The first number that differs. */
function where(door, columns, results, expected) {
  for (const column of columns)
    for (let row = 0; row < expected[column].length; row++)
      if (!Object.is(results[column]?.[row], expected[column][row])) {
        console.log(
          `    ${door}: ${column}, row ${row}: ${results[column]?.[row]}, by the command line ${expected[column][row]}`,
        );
        return;
      }
}
