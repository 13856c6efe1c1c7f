// Prints the figures that the documents and notes quote: `npm run figures`. Nothing here asserts; the tests do.
import { readFileSync } from 'node:fs';
import Papa from 'papaparse';
import { point, type PointReport } from '../src/cli/point.ts';
import { cases } from '../src/core/systems/registry.ts';
import { feedbackOf } from '../src/core/control/design/feedback.ts';
import { checkScenario } from '../src/core/scenario/schema.ts';
import { judgeMotion } from '../src/core/simulation/judge.ts';
import '../src/core/simulation/everyMotion.ts';
import { Simulation } from '../src/core/simulation/simulation.ts';
import { systems } from '../src/core/systems/all.ts';
import { writeCsv } from '../src/csv/csv.ts';
import { CsvByteReader } from '../src/csv/reading/byteReader.ts';

const metas = Object.fromEntries(Object.entries(systems).map(([id, s]) => [id, s.meta]));
const ripstik = systems['ripstik']!;
const read = (name: string) =>
  JSON.parse(readFileSync(new URL(`../tests/reference/${name}`, import.meta.url), 'utf8')) as unknown[];
const caseNamed = (id: string) => cases.find((c) => c.id === id)!.scenario;

function run(raw: object) {
  const scenario = checkScenario(raw, metas);
  const system = systems[scenario.system]!;
  const simulation = new Simulation(scenario, system, {
    extras: ['energy', 'residual'],
    feedback: feedbackOf(scenario, system),
  });
  const from = performance.now();
  simulation.advance(() => false);
  const seconds = (performance.now() - from) / 1000;
  const { columns, rows } = simulation.takeChunk();
  const column = (name: string) => columns[simulation.columns.indexOf(name)];
  return { scenario, simulation, column, rows, seconds };
}

function relative(actual: readonly number[], expected: readonly number[]): number {
  const scale = Math.max(1e-300, ...expected.map(Math.abs));
  return Math.max(0, ...expected.map((x, i) => Math.abs(x - actual[i]!))) / scale;
}

function print(what: string, figure: string | number): void {
  console.log(`${what.padEnd(64)} ${typeof figure === 'number' ? figure.toExponential(2) : figure}`);
}

function points(): void {
  const keys = ['q', 'v', 'acceleration', 'multipliers', 'massMatrix', 'positions'] as const;
  const worst = Object.fromEntries([...keys, 'kinetic', 'potential'].map((key) => [key, 0])) as Record<string, number>;
  for (const expected of read('ripstik-points.json') as (PointReport & { scenario: object })[]) {
    const actual = point(checkScenario(expected.scenario, metas), ripstik);
    for (const key of keys) worst[key] = Math.max(worst[key]!, relative(actual[key].flat(), expected[key].flat()));
    for (const key of ['kinetic', 'potential'] as const)
      worst[key] = Math.max(worst[key]!, relative([actual[key]], [expected[key]]));
  }
  for (const [key, value] of Object.entries(worst)) print(`reference points: ${key}, relative`, value);
}

function runs(): void {
  for (const expected of read('ripstik-runs.json') as { scenario: object; columns: string[]; rows: number[][] }[]) {
    const { column, scenario } = run({ ...expected.scenario, method: { rtol: 1e-10 } });
    let worst = 0;
    expected.columns.forEach((name, c) =>
      expected.rows.forEach((row, k) => (worst = Math.max(worst, Math.abs(row[c]! - column(name)![k]!)))),
    );
    print(`reference run (${scenario.control ? 'ridden' : 'hanging'}), rtol 1e-10: largest difference`, worst);
  }
}

function conservation(): void {
  for (const id of ['hanging', 'falling-report']) {
    const { column, scenario, rows } = run({ ...caseNamed(id), duration: 10, method: { rtol: 1e-10 } });
    const energy = column('energy')!;
    let kinetic = 0;
    const out = new Float64Array(2);
    const p = Float64Array.from(ripstik.meta.parameters, (m) => scenario.parameters[m.name]!);
    const state = (suffix: string, k: number) =>
      Float64Array.from(ripstik.meta.coordinates, (c) => column(`${c.name}${suffix}`)![k]!);
    for (let k = 0; k < rows; k++) {
      ripstik.energy(state('', k), state('_dot', k), p, out);
      kinetic = Math.max(kinetic, out[0]!);
    }
    print(
      `${id}, 10 s at rtol 1e-10: energy, of the largest kinetic`,
      Math.max(...energy.map((e) => Math.abs(e - energy[0]!))) / kinetic,
    );
    const judged = judgeMotion(ripstik, scenario.parameters, scenario.constraints, column)!;
    print(`${id}: largest |Omega v| (m/s) and height (m) of a row`, judged.residual);
  }
}

function ends(): void {
  for (const { id, scenario } of cases) {
    const { simulation, seconds } = run(scenario);
    const { steps, evaluations } = simulation.counts;
    print(
      `case ${id}`,
      `${simulation.end!.reason} at ${simulation.end!.time.toFixed(4)} s, ${steps} steps, ${evaluations} evaluations, ${seconds.toFixed(2)} s`,
    );
  }
  const swing = run(caseNamed('falling-report'));
  const front = [...swing.column('alpha_fp')!.subarray(0, 121)];
  print(
    'falling-report, first 1.2 s: front plate swings to, and is then at',
    `${Math.max(...front).toFixed(2)} rad, ${front[120]!.toFixed(2)} rad`,
  );
}

/** Processor time of reading 21 columns into typed arrays, ours and papaparse's own numbers, in turns; the median of five. */
function csv(): void {
  const names = ['t', ...ripstik.meta.coordinates.flatMap((c) => [c.name, `${c.name}_dot`])];
  const data = names.map((_, c) =>
    Float64Array.from({ length: 40_000 }, (_, r) => (c === 0 ? r / 1000 : Math.sin(r * (c + Math.SQRT2)))),
  );
  const bytes = new TextEncoder().encode(writeCsv(names, data));
  const timed = (work: () => void): number => {
    const from = process.cpuUsage();
    work();
    const { user, system } = process.cpuUsage(from);
    return (user + system) / 1e6;
  };
  const ours: number[] = [];
  const papa: number[] = [];
  for (let k = 0; k < 6; k++) {
    ours.push(
      timed(() => {
        const reader = new CsvByteReader({ systems: metas }, bytes.length);
        for (let at = 0; at < bytes.length; at += 1 << 18) reader.push(bytes.subarray(at, at + (1 << 18)));
        reader.finish();
      }),
    );
    papa.push(timed(() => void Papa.parse(new TextDecoder().decode(bytes), { dynamicTyping: true })));
  }
  const median = (list: number[]): number => list.slice(1).sort((a, b) => a - b)[2]!;
  print(
    `CSV of ${(bytes.length / 1e6).toFixed(0)} MB, 21 columns: ours, papaparse with dynamicTyping`,
    `${median(ours).toFixed(2)} s, ${median(papa).toFixed(2)} s, ratio ${(median(ours) / median(papa)).toFixed(2)}`,
  );
}

csv();
points();
runs();
conservation();
ends();
