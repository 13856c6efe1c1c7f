/** Writes the recorded motions in public/data from the built-in cases; `--check` compares the files instead. */
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { cases } from '../src/core/systems/registry.ts';
import { checkScenario } from '../src/core/scenario/schema.ts';
import type { ScenarioFile } from '../src/core/scenario/types.ts';
import '../src/core/simulation/everyMotion.ts';
import { Simulation } from '../src/core/simulation/simulation.ts';
import { systems } from '../src/core/systems/all.ts';
import { csvComments, csvHeader } from '../src/csv/csv.ts';

/** The report's player drew 60 rows a second. */
const STEP = 1 / 60;
/**
 * Digits behind the point: a tenth of a nanometre. Recordings need no more, files stay small, and rounding noise
 * (a held zero of 1e-18) is written as the zero it is. An export of the page or the command line is exact instead.
 */
const DECIMALS = 10;
const DEGREES = 180 / Math.PI;

export interface Sample {
  file: string;
  scenario: ScenarioFile;
  /** Columns as they are computed, SI and radians. */
  columns: readonly string[];
  /** Angles are written in degrees, with every unit in the header. */
  degrees?: true;
  /** Nothing but rows: no comments, no header, no time. */
  bare?: true;
}

export interface Recording {
  columns: readonly string[];
  data: readonly Float64Array[];
}

const { meta } = systems['ripstik']!;
const coordinates = meta.coordinates.map((c) => c.name);
const velocities = coordinates.map((name) => `${name}_dot`);
const multipliers = [1, 2, 3, 4].map((r) => `lambda_${r}`);

export const samples: readonly Sample[] = [
  {
    file: 'ridden.csv',
    scenario: { ...scenarioOf('ridden'), outputStep: STEP, columns: ['lambda'] },
    columns: ['t', ...coordinates, ...velocities, ...multipliers],
  },
  {
    file: 'falling-report.csv',
    scenario: { ...scenarioOf('falling-report'), outputStep: STEP },
    columns: ['t', ...coordinates],
    degrees: true,
  },
  {
    file: 'headerless.csv',
    scenario: { ...scenarioOf('hanging'), duration: 4, outputStep: STEP },
    columns: coordinates,
    bare: true,
  },
];

function scenarioOf(id: string): ScenarioFile {
  const found = cases.find((c) => c.id === id);
  if (!found) throw new Error(`there is no case "${id}" to record`);
  return found.scenario;
}

/** Runs a sample's scenario to its end; the columns it writes, SI and radians. */
export function recordSample(sample: Sample): Recording {
  const scenario = checkScenario(sample.scenario, { [meta.id]: meta });
  const simulation = new Simulation(scenario, systems[scenario.system]!);
  simulation.advance(() => false);
  if (simulation.end!.reason !== 'end') throw new Error(`${sample.file}: ${simulation.end!.message}`);
  const { columns } = simulation.takeChunk();
  return { columns: sample.columns, data: sample.columns.map((name) => columns[simulation.columns.indexOf(name)]!) };
}

export function textOf(sample: Sample): string {
  const { columns, data } = recordSample(sample);
  const scale = columns.map((name) => (sample.degrees && isAngle(name) ? DEGREES : 1));
  const rows = Array.from(data[0]!, (_, row) => data.map((column, c) => decimal(column[row]! * scale[c]!)).join(','));
  if (sample.bare) return `${rows.join('\n')}\n`;
  const header = sample.degrees ? columns.map((name) => `${name} [${unitOf(name)}]`) : columns;
  const behind = csvComments([`scenario: ${JSON.stringify(sample.scenario)}`]);
  return `${csvHeader(header)}${rows.join('\n')}\n${behind}`;
}

function isAngle(column: string): boolean {
  return meta.coordinates.some((c) => c.name === column && c.kind === 'angle');
}

function unitOf(column: string): string {
  if (column === 't') return 's';
  return isAngle(column) ? 'deg' : 'm';
}

/** The shortest text of a number rounded to `DECIMALS`, without a negative zero. */
function decimal(x: number): string {
  return String(Number(x.toFixed(DECIMALS)) + 0);
}

function main(check: boolean): void {
  const folder = new URL('../public/data/', import.meta.url);
  mkdirSync(folder, { recursive: true });
  for (const sample of samples) {
    const path = fileURLToPath(new URL(sample.file, folder));
    const text = textOf(sample);
    if (!check) {
      writeFileSync(path, text);
      console.log(`${sample.file}: ${(text.length / 1000).toFixed(0)} kB`);
    } else if (readFileSync(path, 'utf8') !== text) {
      console.error(`${sample.file} is not what this machine computes: run npm run samples and look at the difference`);
      process.exitCode = 1;
    }
  }
}

if (process.argv[1] && import.meta.url === pathToFileURL(process.argv[1]).href) main(process.argv.includes('--check'));
