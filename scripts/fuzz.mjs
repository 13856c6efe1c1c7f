// npm run fuzz [-- length [seed]]: the suites of tests/fuzz, `length` times (20) longer than in the tests of every day, from another seed;
// what they tried goes into docs/robustness.md.
import { readdirSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { cache, readJson, runPackage, writeTable } from './setup.mjs';

const [length = '20', seed = String(Date.now() % 1e6)] = process.argv.slice(2);
const folder = join(cache, 'fuzz');
rmSync(folder, { recursive: true, force: true });
const { code } = await runPackage('vitest/vitest.mjs', ['run', 'tests/fuzz'], {
  show: true,
  env: { FUZZ: length, FUZZ_SEED: seed },
});
if (code !== 0) process.exit(code);

const number = (n) => n.toLocaleString('en');
const rows = readdirSync(folder)
  .sort()
  .map((name) => {
    const { suite, tried, simulated, counts } = readJson(join(folder, name));
    const parts = Object.entries(counts)
      .sort(([, a], [, b]) => b - a)
      .map(([what, n]) => `${what} ${number(n)}`);
    return `| ${suite} | ${number(tried)} | ${parts.join(', ')}${simulated ? `; ${(simulated / 3600).toFixed(1)} hours simulated` : ''} | nothing |`;
  });
writeTable('inputs', [
  '| inputs | tried | what became of them | crashed, hung or lost |',
  '|---|--:|---|---|',
  ...rows,
  '',
  `\`npm run fuzz -- ${length} ${seed}\``,
]);
