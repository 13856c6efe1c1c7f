// npm run fuzz [-- length [seed]]: the suites of tests/fuzz, `length` times (20) longer than in the tests of every day, from another seed;
// what they tried goes into docs/robustness.md.
import { readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { cache, root, runPackage } from './setup.mjs';

const [length = '20', seed = String(Date.now() % 1e6)] = process.argv.slice(2);
const folder = join(cache, 'fuzz');
rmSync(folder, { recursive: true, force: true });
const { code } = await runPackage('vitest/vitest.mjs', ['run', 'tests/fuzz'], { show: true, env: { FUZZ: length, FUZZ_SEED: seed } });
if (code !== 0) process.exit(code);

const rows = readdirSync(folder).sort().flatMap((name) => {
  const { suite, counts } = JSON.parse(readFileSync(join(folder, name), 'utf8'));
  const total = counts.scenarios ?? Object.values(counts).reduce((a, b) => a + b, 0);
  const parts = Object.entries(counts).filter(([what]) => what !== 'scenarios').sort(([, a], [, b]) => b - a).map(([what, n]) => `${what} ${n.toLocaleString('en')}`);
  return `| ${suite} | ${total.toLocaleString('en')} | ${parts.join(', ')} | nothing |`;
});
const table = ['| inputs | tried | what became of them | crashed, hung or lost |', '|---|--:|---|---|', ...rows, '', `\`npm run fuzz -- ${length} ${seed}\``].join('\n');
const page = join(root, 'docs/robustness.md');
const [before, after] = readFileSync(page, 'utf8').split(/<!-- inputs -->[\s\S]*<!-- end -->/);
writeFileSync(page, `${before}<!-- inputs -->\n${table}\n<!-- end -->${after}`);
console.log(table);
