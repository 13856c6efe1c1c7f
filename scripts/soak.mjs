// npm run soak [-- minutes [seed]]: one page, used without a pause for so long (60), every act from a seed; npm run big: large files and a long run.
// What was measured goes into docs/robustness.md.
import { existsSync, mkdirSync, readFileSync, readdirSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { findBrowser } from './browser.mjs';
import { build, built, cache, freePort, install, main, readJson, runPackage, writeTable } from './setup.mjs';

function bigTable(folder) {
  const rows = readdirSync(folder)
    .sort()
    .map((name) => readJson(join(folder, name)));
  const keys = ['what', 'became', 'tasks', 'seeks', 'memory'];
  return [
    '| what | what became of it | tasks over 50 ms | from a seek to its picture | memory |',
    '|---|---|---|---|---|',
    ...rows.map((row) => `| ${keys.map((key) => row[key]).join(' | ')} |`),
    '',
    '`npm run big`',
  ];
}

main(async (args) => {
  const big = args[0] === 'big';
  const [minutes = '60', seed = String(Date.now() % 1e6)] = big ? [] : args;
  await install();
  if (!built() && !(await build())) return 1;
  const folder = join(cache, big ? 'big' : 'soak');
  if (!big || args.length === 1) rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  const env = {
    RIPSTIK_BROWSER: await findBrowser(),
    RIPSTIK_TEST_PORT: String(await freePort()),
    SOAK_MINUTES: minutes,
    SOAK_SEED: seed,
  };
  const { code } = await runPackage(
    '@playwright/test/cli.js',
    [
      'test',
      '--config',
      'tools/soak/playwright.config.ts',
      big ? 'big.spec' : 'long.spec',
      ...(big ? args.slice(1) : []),
    ],
    { show: true, env },
  );
  if (code !== 0) return code;
  if (big) writeTable('sizes', bigTable(folder));
  else if (existsSync(join(folder, 'table.md')))
    writeTable('soak', readFileSync(join(folder, 'table.md'), 'utf8').trimEnd().split('\n'));
  return 0;
});
