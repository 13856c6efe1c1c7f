import { spawnSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { Simulation } from '../../core/simulation/simulation.ts';
import { systems } from '../../core/systems/all.ts';
import { boardXml } from './mujoco.ts';
import { dynamicsOf, scenarioOf } from './states.ts';
import { fileOf, TOLERANCES } from './sweep.ts';

/** Python packages of each rival; MuJoCo's is the native build, which loops by itself. */
const PACKAGES = {
  scipy: ['scipy', 'numba'],
  casadi: ['casadi'],
  diffrax: ['diffrax', 'jax'],
  mujoco: ['mujoco'],
} as const;
/** Runs that the slower ones make, and the ones whose ends are compared with the truth. */
const FEW = 32;
/** Of whoever does not answer, ms. */
const PATIENCE = 600_000;

const place = (name: string): string => fileURLToPath(new URL(name, import.meta.url));
/** Kept between runs, outside the repository's history. */
const ENVIRONMENT = place('../../../.cache/rivals');

/** A rival's processor time (ms, one core), or why there is none. */
export type RivalEntry =
  { name: string; label: string; milliseconds: number; error: number | null } | { name: string; skipped: string };

/** Python's tools at the sweep of `sweep.ts`, where they can be had. @param say hears what is skipped */
export function rivals(runs: number, say: (what: string) => void): RivalEntry[] {
  const python = environment();
  if (typeof python !== 'string') return skipAll(python.skipped, say);
  const request = JSON.stringify(requestOf(runs));
  return (Object.keys(PACKAGES) as (keyof typeof PACKAGES)[]).map((name) => {
    const entry = asked(python, name, request);
    if ('skipped' in entry) say(`${name} is skipped: ${entry.skipped}`);
    return entry;
  });
}

function skipAll(skipped: string, say: (what: string) => void): RivalEntry[] {
  say(`the rivals in Python are skipped: ${skipped}`);
  return Object.keys(PACKAGES).map((name) => ({ name, skipped }));
}

/** The environment's Python, made at the first call. */
function environment(): string | { skipped: string } {
  const python = `${ENVIRONMENT}/bin/python3`;
  if (!existsSync(python)) {
    const { status } = spawnSync('python3', ['-m', 'venv', ENVIRONMENT], { stdio: 'ignore' });
    if (status !== 0) return { skipped: 'there is no Python 3 that makes a virtual environment' };
  }
  return python;
}

function asked(python: string, name: keyof typeof PACKAGES, request: string): RivalEntry {
  const installed = PACKAGES[name].every(
    (pack) => spawnSync(python, ['-c', `import ${pack}`], { stdio: 'ignore' }).status === 0,
  );
  if (!installed) {
    const { status } = spawnSync(python, ['-m', 'pip', 'install', '--quiet', ...PACKAGES[name]], { stdio: 'ignore' });
    if (status !== 0) return { name, skipped: `pip cannot install ${PACKAGES[name].join(' and ')}` };
  }
  const { status, stdout, stderr } = spawnSync(python, [place('rivals.py'), name], {
    input: request,
    encoding: 'utf8',
    timeout: PATIENCE,
    maxBuffer: 1 << 26,
  });
  if (status !== 0) return { name, skipped: stderr.trim().split('\n').at(-1) || 'it did not answer in time' };
  return JSON.parse(stdout.trim().split('\n').at(-1)!) as RivalEntry;
}

/** Equations, starts and the true ends of the sweep, and the bodies in MuJoCo's language. */
function requestOf(runs: number) {
  const scenarios = Array.from({ length: runs }, (_, run) => scenarioOf(fileOf(run, runs, 'wasm')));
  const system = systems[scenarios[0]!.system]!;
  const { direct } = dynamicsOf(scenarios[0]!);
  const starts = scenarios.map((scenario) => {
    const { q, v } = new Simulation(scenario, system, { extras: [] });
    return [...q, ...v];
  });
  return {
    tape: direct!.direct.tape!,
    set: scenarios[0]!.constraints,
    constants: [...direct!.constants],
    starts,
    ends: first(scenarios).map((scenario) => truthOf(scenario)),
    few: FEW,
    until: scenarios[0]!.duration,
    ...TOLERANCES,
    models: (['hinges', 'free'] as const).map((root) => boardXml(scenarios[0]!.parameters, root)),
  };
}

/** Those whose ends are compared: the slower rivals compute no others. */
const first = <T>(all: readonly T[]): readonly T[] => all.slice(0, FEW);

/** The end of a run as well as it can be had: q and v. */
export function truthOf(scenario: ReturnType<typeof scenarioOf>): number[] {
  const method = { ...scenario.method, name: 'dop853', rtol: 1e-13, atol: 1e-15 };
  return endOf({ ...scenario, method });
}

/** The last row's q and v. */
function endOf(scenario: ReturnType<typeof scenarioOf>): number[] {
  const system = systems[scenario.system]!;
  const simulation = new Simulation({ ...scenario, outputStep: scenario.duration }, system, { extras: [] });
  simulation.advance(() => false);
  const { columns, rows } = simulation.takeChunk();
  return columns.slice(1).map((column) => column[rows - 1]!);
}

/** Median over the first runs of the largest error of their ends: what the rivals' are beside. */
export function ownError(runs: number): number {
  const errors = first(Array.from({ length: runs }, (_, run) => scenarioOf(fileOf(run, runs, 'wasm')))).map(
    (scenario) => {
      const truth = truthOf(scenario);
      return Math.max(...endOf(scenario).map((x, i) => Math.abs(x - truth[i]!)));
    },
  );
  return errors.sort((a, b) => a - b)[errors.length >> 1]!;
}
