import { isMainThread } from 'node:worker_threads';
import { StartError } from '../core/mechanics/consistentStart.ts';
import { cases, learnSystem, learnSystemIn, loadSystem, systemMetas as metas } from '../core/systems/registry.ts';
import { controlReport } from '../core/control/design/report.ts';
import { computerReport } from '../core/control/sampled/computerReport.ts';
import { decodeLink, descriptionInLink, encodeLink, LinkError, LONGEST_LINK } from '../core/scenario/link.ts';
import { settled, written } from '../core/scenario/own.ts';
import { parseScenario } from '../core/scenario/schema.ts';
import { ScenarioError, type Scenario, type ScenarioFile } from '../core/scenario/types.ts';
import type { System } from '../core/model/system.ts';
import { bench } from './bench/bench.ts';
import { curves } from './curves.ts';
import { exportAs } from './export.ts';
import { gaitReport, type GaitOptions } from './gait.ts';
import { cannotWrite } from './output.ts';
import { point } from './point.ts';
import { read, type ReadOptions } from './read.ts';
import { simulate } from './simulate.ts';
import { test } from './test.ts';
import { sweep } from './sweep.ts';
import { workOnSweep } from './sweepWorker.ts';
import { UsageError, readText } from './usage.ts';

const USAGE = `Usage:
  npm run --silent ripstik -- simulate SCENARIO.json --out RUN.csv   run a scenario (without --out: CSV on standard output)
                                                                     with --verify: compute it again by another method and tell
                                                                     as JSON how many digits are right until when
  npm run --silent ripstik -- point SCENARIO.json                    state, accelerations and multipliers at t = 0, as JSON
  npm run --silent ripstik -- linearize SCENARIO.json                A, B, modes, gain and closed loop about a steady motion, as JSON
  npm run --silent ripstik -- curves SCENARIO.json [--out CURVES.csv] growth, largest gain and delay margin of its lqr, designed
       [--from 0] [--to 10] [--count 41] [--over NAME]               anew over the speed, or a parameter or state (SI), as JSON
  npm run --silent ripstik -- test SCENARIO.json                     manoeuvres with pass or fail: exit 0 if all passed, 1 if not
       [--tests TESTS.json] [--report OUT.json] [--junit OUT.xml]    (without --tests: those that come with the system)
  npm run --silent ripstik -- read FILE [--out RUN.csv]              any table of numbers: what is understood, as JSON; its rows as CSV
       [--units alpha=deg,…] [--map theta=yaw,…] [--time COLUMN] [--step SECONDS] [--system ID] [--run N] [--body NAME] [--scalar first|last] [--rates savitzky-golay]
  npm run --silent ripstik -- gait SYSTEM [--speed 1] [--search]     the amplitude with which feet that pump hold a speed, or the cheapest
       [--frequency HZ] [--phase DEG] [--bias DEG] [--twist DEG]     gait that does, what a metre costs, and its scenario, as JSON
       [--harmonics 2,3] [--parameters wheelDrag=0.5,…]
  npm run --silent ripstik -- sweep STUDY.json --out RESULTS.parquet many runs, one row each, on every core; .csv writes text
       [--shard I/N] [--resume] [--workers N]                        a part of the runs; going on after an interruption
  npm run --silent ripstik -- export SCENARIO.json --as mjcf|sympy|c the system for MuJoCo, as a SymPy script, or as C with a test
       [--out FILE]                                                  (without --out: on standard output)
  npm run --silent ripstik -- cases [ID]                             the built-in cases, or one as a scenario, as JSON
  npm run --silent ripstik -- link SCENARIO.json                     the scenario as the part of the page's address after #
  npm run --silent ripstik -- bench                                  speed of this machine: accelerations, steps by method, as JSON
SCENARIO.json may be - for standard input, a description NAME.system.txt, or a link of the page in quotes. Exit status: 0, 1 for tests that failed, 2 for a bad call or scenario, 3 when a run stopped early.`;

/** The installed package has a command of its own. */
const calledAs = (usage: string): string =>
  process.argv[1]?.endsWith('.ts') ? usage : usage.replaceAll('npm run --silent ripstik --', 'npx ripstik-lab');

/** Mail programs and chats escape `#` and `=`. */
const isLink = (text: string): boolean => /^\s*\S*?(?:#|%23)v(?:=|%3D)\d/i.test(text.slice(0, LONGEST_LINK));

/** What a link of the page holds, as a scenario's file. */
async function scenarioOfLink(link: string): Promise<string> {
  try {
    const text = link.trim().replace(/^.*?(?:#|%23)/s, '#');
    const description = descriptionInLink(text);
    if (description !== null) await learnSystem(description);
    return JSON.stringify(written(decodeLink(text, { systems: metas, cases }).scenario, metas));
  } catch (error) {
    if (error instanceof LinkError) throw new UsageError(`the link cannot be read: ${error.message}`);
    throw error;
  }
}

/** A scenario as a link, without the page's address. */
function linkOf(scenario: ScenarioFile): string {
  try {
    return encodeLink({ caseId: null, scenario: settled(scenario) }, { systems: metas, cases });
  } catch (error) {
    if (error instanceof LinkError) throw new UsageError(error.message);
    throw error;
  }
}

/** A scenario, its JSON as it was written, and its system. */
async function readScenario(name: string | undefined): Promise<{ scenario: Scenario; file: unknown; system: System }> {
  if (!name) throw new UsageError('which scenario? Name a JSON file');
  let text = isLink(name) ? name : readText(name);
  if (isLink(text)) text = await scenarioOfLink(text);
  // A description by itself: everything at its default.
  if (/\.system\.txt$/i.test(name))
    text = JSON.stringify({ version: 1, system: { description: text.replace(/^\ufeff/, '') } });
  await learnSystemIn(text);
  const scenario = parseScenario(text, metas);
  return { scenario, file: JSON.parse(text.replace(/^\ufeff/, '')), system: await loadSystem(scenario.system)! };
}

function listCases(id: string | undefined): void {
  if (id === undefined) return print(cases);
  const found = cases.find((c) => c.id === id);
  if (!found) throw new UsageError(`no case "${id}"; there are ${cases.map((c) => c.id).join(', ')}`);
  print(found.scenario);
}

function print(value: unknown): void {
  process.stdout.write(`${JSON.stringify(value, null, 2)}\n`);
}

function takeOption(rest: string[], name: string): string | undefined {
  const at = rest.indexOf(name);
  if (at < 0) return undefined;
  const [, value] = rest.splice(at, 2);
  if (!value) throw new UsageError(`${name} needs a value`);
  return value;
}

/** Whether a word that takes no value is there. */
function takeFlag(rest: string[], name: string): boolean {
  const at = rest.indexOf(name);
  if (at >= 0) rest.splice(at, 1);
  return at >= 0;
}

function readOptions(rest: string[]): ReadOptions {
  const names = ['units', 'step', 'map', 'time', 'system', 'run', 'body', 'scalar', 'rates'] as const;
  return Object.fromEntries(names.map((name) => [name, takeOption(rest, `--${name}`)]));
}

/** Systems with feet that pump. */
const riders = Object.values(metas)
  .filter(({ gait }) => gait !== undefined)
  .map(({ id }) => id);

function gaitOptions(rest: string[]): GaitOptions {
  const option = (name: string): string | undefined => takeOption(rest, `--${name}`);
  return {
    speed: option('speed'),
    frequency: option('frequency'),
    phase: option('phase'),
    bias: option('bias'),
    twist: option('twist'),
    parameters: option('parameters'),
    harmonics: option('harmonics'),
    search: takeFlag(rest, '--search'),
  };
}

async function main(args: readonly string[]): Promise<number> {
  const [command, ...rest] = args;
  const out = takeOption(rest, '--out');
  const verify = takeFlag(rest, '--verify');
  const testing =
    command === 'test'
      ? { tests: takeOption(rest, '--tests'), report: takeOption(rest, '--report'), junit: takeOption(rest, '--junit') }
      : null;
  const format = command === 'export' ? takeOption(rest, '--as') : undefined;
  const pumping = command === 'gait' ? gaitOptions(rest) : null;
  const curving =
    command === 'curves'
      ? {
          over: takeOption(rest, '--over'),
          from: takeOption(rest, '--from'),
          to: takeOption(rest, '--to'),
          count: takeOption(rest, '--count'),
        }
      : null;
  const reading = command === 'read' ? readOptions(rest) : {};
  const sweeping =
    command === 'sweep'
      ? {
          shard: takeOption(rest, '--shard'),
          workers: takeOption(rest, '--workers'),
          resume: takeFlag(rest, '--resume'),
        }
      : null;
  const unknown = rest.find((a) => a.startsWith('--')) ?? rest[1];
  if (verify && command !== 'simulate') throw new UsageError('--verify is for simulate');
  if (unknown) throw new UsageError(`"${unknown}" is not understood; see --help`);
  switch (command) {
    case 'simulate': {
      const { scenario, file, system } = await readScenario(rest[0]);
      return simulate(scenario, system, { name: rest[0]!, out, written: file, verify });
    }
    case 'point': {
      const { scenario, system } = await readScenario(rest[0]);
      print(point(scenario, system));
      return 0;
    }
    case 'link': {
      const { file } = await readScenario(rest[0]);
      process.stdout.write(`#${linkOf(file as ScenarioFile)}\n`);
      return 0;
    }
    case 'linearize': {
      const { scenario, system } = await readScenario(rest[0]);
      print({ ...controlReport(scenario, system), ...computerReport(scenario, system) });
      return 0;
    }
    case 'curves': {
      const { scenario, system } = await readScenario(rest[0]);
      print(curves(scenario, system, rest[0]!, { out, ...curving! }));
      return 0;
    }
    case 'test': {
      const { file, system } = await readScenario(rest[0]);
      return test(file as ScenarioFile, system, testing!);
    }
    case 'read':
      print(await read(rest[0], metas, { out, ...reading }));
      return 0;
    case 'gait': {
      const system = rest[0] === undefined ? undefined : await loadSystem(rest[0]);
      if (!system) throw new UsageError(`which system? Right would be ${riders.join(', ')}`);
      print(gaitReport(system, pumping!));
      return 0;
    }
    case 'export': {
      const { scenario, system } = await readScenario(rest[0]);
      return exportAs(scenario, system, { name: rest[0]!, format, out });
    }
    case 'sweep':
      return sweep(rest[0], { out, ...sweeping! });
    case 'cases':
      listCases(rest[0]);
      return 0;
    case 'bench':
      if (rest[0]) throw new UsageError(`bench takes no "${rest[0]}"`);
      print(bench());
      return 0;
    case undefined:
    case 'help':
      process.stdout.write(`${calledAs(USAGE)}\n`);
      return command === undefined ? 2 : 0;
    default:
      throw new UsageError(
        `no command "${command}"; there are simulate, point, linearize, curves, test, read, gait, sweep, export, cases, link and bench`,
      );
  }
}

/** What a person can mend is one line and status 2; anything else is our fault and shows its trace. */
async function run(): Promise<number> {
  const args = process.argv.slice(2);
  if (args[0] === '--help' || args[0] === '-h') return await main(['help']);
  try {
    return await main(args);
  } catch (error) {
    if (!(error instanceof ScenarioError || error instanceof StartError || error instanceof UsageError)) throw error;
    process.stderr.write(`ripstik: ${error.message.replace(/\s*\n\s*/g, ' ')}\n`);
    return 2;
  }
}

if (isMainThread) {
  process.stdout.on('error', (error) => {
    process.stderr.write(`ripstik: ${cannotWrite('standard output', error).message}\n`);
    process.exit(2);
  });
  process.exitCode = await run();
} else await workOnSweep();
