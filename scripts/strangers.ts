// npm run strangers [-- ID …]: descriptions as strangers type them, taken through everything; prints figures, and what is wrong.
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { isDeepStrictEqual } from 'node:util';
import { strangers } from '../tests/core/description/strangers.ts';
import { walk, type Walked } from '../tests/core/description/walk.ts';

const asked = process.argv.slice(2);
const ids = Object.keys(strangers).filter((id) => asked.length === 0 || asked.includes(id));
const short = (x: number | string): string => (typeof x === 'number' ? x.toPrecision(2) : x);
let wrong = 0;

/** What the command line says of the same experiment, where it fails. */
function commandLine({ id, scenario, report }: Walked, text: string): string[] {
  const folder = mkdtempSync(join(tmpdir(), 'stranger-'));
  const file = join(folder, `${id}.json`);
  writeFileSync(file, JSON.stringify({ ...scenario, system: { description: text } }));
  const at = strangers[id]!.plan.at;
  const still = join(folder, 'at.json');
  if (at) writeFileSync(still, JSON.stringify({ version: 1, system: { description: text }, at }));
  const call = (...args: string[]): { status: number | null; stdout: string; stderr: string } =>
    spawnSync(process.execPath, ['--import', 'tsx', 'src/cli/main.ts', ...args], { encoding: 'utf8' });
  const wrong: string[] = [];
  const say = (what: string, stderr: string): void => void wrong.push(`${what}: ${stderr.trim()}`);
  const ran = call('simulate', file, '--out', join(folder, 'run.csv'));
  if (ran.status !== (strangers[id]!.plan.ends ? 3 : 0)) say('simulate', ran.stderr);
  const read = call('read', join(folder, 'run.csv'));
  if (!read.stdout.includes('"own-')) say('read', read.stderr || 'another system was understood');
  const point = call('point', file);
  if (point.status !== 0) say('point', point.stderr);
  const link = call('link', file);
  if (link.status !== 0 || call('point', link.stdout.trim()).stdout !== point.stdout) say('link', link.stderr);
  if (at) {
    const linear = call('linearize', still);
    const same =
      report && linear.status === 0 && isDeepStrictEqual(JSON.parse(linear.stdout).eigenvalues, report.eigenvalues);
    if (!same) say('linearize', linear.stderr || 'other eigenvalues');
  }
  rmSync(folder, { recursive: true });
  return wrong;
}

for (const id of ids) {
  const text = readFileSync(new URL(`../tests/core/description/strangers/${id}.system.txt`, import.meta.url), 'utf8');
  const from = performance.now();
  const { plan, known } = strangers[id]!;
  const walked = await walk(id, text, plan);
  try {
    await known?.(walked);
  } catch (error) {
    walked.wrong.push(`known answer: ${(error as Error).message}`);
  }
  const figures = Object.entries(walked.told).map(([name, value]) => `${name} ${short(value)}`);
  console.log(`${id} (${((performance.now() - from) / 1000).toFixed(1)} s): ${figures.join(', ')}`);
  walked.wrong.push(...commandLine(walked, text));
  for (const line of walked.wrong) console.log(`    ${line}`);
  wrong += walked.wrong.length;
}
console.log(wrong === 0 ? `${ids.length} descriptions, nothing wrong` : `${wrong} things are wrong`);
process.exitCode = wrong === 0 ? 0 : 1;
