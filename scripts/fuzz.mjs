// npm run fuzz [-- length [seed [file ...]]]: the suites of tests/fuzz, or those of these files alone, `length` times (20) longer than in the
// tests of every day, from another seed; what they tried goes into docs/robustness.md, where the rows of other suites stay.
import { readdirSync, readFileSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { cache, readJson, root, runPackage, writeTable } from './setup.mjs';

const [length = '20', seed = String(Date.now() % 1e6), ...files] = process.argv.slice(2);
const folder = join(cache, 'fuzz');
rmSync(folder, { recursive: true, force: true });
const { code } = await runPackage(
  'vitest/vitest.mjs',
  ['run', ...(files.length > 0 ? files.map((file) => `tests/fuzz/${file}.test.ts`) : ['tests/fuzz'])],
  {
    show: true,
    env: { FUZZ: length, FUZZ_SEED: seed },
  },
);
if (code !== 0) process.exit(code);

const number = (n) => n.toLocaleString('en');
const told = new Map(
  readdirSync(folder).map((name) => {
    const { suite, tried, simulated, counts } = readJson(join(folder, name));
    const parts = Object.entries(counts)
      .sort(([, a], [, b]) => b - a)
      .map(([what, n]) => `${what} ${number(n)}`);
    const hours = simulated ? `; ${(simulated / 3600).toFixed(simulated < 36000 ? 2 : 1)} hours simulated` : '';
    return [suite, `| ${suite} | ${number(tried)} | ${parts.join(', ')}${hours} | nothing | ${length} ${seed} |`];
  }),
);
const table = readFileSync(join(root, 'docs/robustness.md'), 'utf8').split('<!-- end of inputs -->')[0];
const before = [...table.split('<!-- inputs -->')[1].matchAll(/^\| ([^|]+) \| [\d,]+ \|.*$/gm)].map(([row, suite]) => [
  suite,
  row,
]);
const rows = [...new Map([...before, ...told])].sort(([a], [b]) => (a < b ? -1 : 1)).map(([, row]) => row);
writeTable('inputs', [
  '| inputs | tried | what became of them | crashed, hung or lost | length, seed |',
  '|---|--:|---|---|---|',
  ...rows,
  '',
  '`npm run fuzz -- LENGTH SEED`, with the name of a file of `tests/fuzz` behind it for its suites alone',
]);
