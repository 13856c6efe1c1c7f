// npm run soak [-- minutes [seed]]: one page, used without a pause for so long (60), every act from a seed; npm run big: large files and a long run.
// What was measured goes into docs/robustness.md.
import { existsSync, mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:net';
import { join } from 'node:path';
import { findBrowser } from './browser.mjs';
import { build, built, cache, install, main, readJson, root, runPackage } from './setup.mjs';

const freePort = () =>
  new Promise((done, fail) => {
    const probe = createServer().once('error', fail);
    probe.listen(0, '127.0.0.1', () => {
      const { port } = probe.address();
      probe.close(() => done(port));
    });
  });

/** Puts a table between its marks. */
function write(name, lines) {
  const page = join(root, 'docs/robustness.md');
  const text = readFileSync(page, 'utf8');
  const [from, to] = [`<!-- ${name} -->`, `<!-- end of ${name} -->`];
  if (!text.includes(from) || !text.includes(to)) throw new Error(`docs/robustness.md has no place for the ${name}`);
  writeFileSync(page, `${text.slice(0, text.indexOf(from) + from.length)}\n${lines.join('\n')}\n${text.slice(text.indexOf(to))}`);
  console.log(lines.join('\n'));
}

function bigTable(folder) {
  const rows = readdirSync(folder).sort().map((name) => readJson(join(folder, name)));
  const keys = ['what', 'became', 'tasks', 'seeks', 'memory'];
  return ['| what | what became of it | tasks over 50 ms | from a seek to its picture | memory |', '|---|---|---|---|---|', ...rows.map((row) => `| ${keys.map((key) => row[key]).join(' | ')} |`), '', '`npm run big`'];
}

main(async (args) => {
  const big = args[0] === 'big';
  const [minutes = '60', seed = String(Date.now() % 1e6)] = big ? [] : args;
  await install();
  if (!built() && !(await build())) return 1;
  const folder = join(cache, big ? 'big' : 'soak');
  if (!big || args.length === 1) rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  const env = { RIPSTIK_BROWSER: await findBrowser(), RIPSTIK_TEST_PORT: String(await freePort()), SOAK_MINUTES: minutes, SOAK_SEED: seed };
  const { code } = await runPackage('@playwright/test/cli.js', ['test', '--config', 'tests/soak/playwright.config.ts', big ? 'big.spec' : 'long.spec', ...(big ? args.slice(1) : [])], { show: true, env });
  if (code !== 0) return code;
  if (big) write('sizes', bigTable(folder));
  else if (existsSync(join(folder, 'table.md'))) write('soak', readFileSync(join(folder, 'table.md'), 'utf8').trimEnd().split('\n'));
  return 0;
});
