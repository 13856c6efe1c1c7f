// The npm package as a stranger has it: packed, installed into an empty project without a registry, its README's example and
// its command used, its numbers compared with the repository's command line, its types read; bundled, and run in a browser.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { rolldown } from 'rolldown';
import { findBrowser } from './browser.mjs';
import { serve } from './serve-dist.mjs';
import { Plain, cache, main, root } from './setup.mjs';

const NPM = process.platform === 'win32' ? 'npm.cmd' : 'npm';
const SCENARIO = { version: 1, system: 'ripstik', initial: { X_dot: 1, alpha: '10 deg' }, duration: 0.15 };
const SAME = `import { simulate } from 'ripstik-lab';
const run = await simulate(${JSON.stringify(SCENARIO)});
console.log(run.names.join());
for (let row = 0; row < run.columns[0].length; row++) console.log(run.columns.map((c) => c[row]).join());
`;
/** Every digit of the last row, for Node and for a browser. */
const LAST = `import { simulate } from 'ripstik-lab';
const run = await simulate(${JSON.stringify(SCENARIO)});
const last = run.columns.map((c) => c.at(-1)).join();
globalThis.document ? (document.title = last) : console.log(last);
`;
const TYPED = `import { simulate, type Run } from 'ripstik-lab';
const run: Run = await simulate({ version: 1, system: 'ripstik' });
export const last: number | undefined = run.column('alpha').at(-1);
// @ts-expect-error a system is no number
void simulate({ version: 1, system: 3 });
`;

main(async () => {
  const packed = join(cache, 'package');
  const project = mkdtempSync(join(tmpdir(), 'package-'));
  const run = (program, args, cwd = project) =>
    execFileSync(program, args, { cwd, encoding: 'utf8', stdio: ['ignore', 'pipe', 'inherit'] });
  const node = (...args) => run(process.execPath, args);
  run(NPM, ['pack', '--silent', '--pack-destination', project], packed);
  const archive = readdirSync(project).find((name) => name.endsWith('.tgz'));
  writeFileSync(join(project, 'package.json'), '{ "type": "module" }\n');
  run(NPM, ['install', '--silent', '--offline', '--no-audit', '--no-fund', `./${archive}`]);

  const example = /```js\n([^]*?)```/.exec(readFileSync(join(root, 'docs/package.md'), 'utf8'))[1];
  const files = {
    'example.mjs': example,
    'same.mjs': SAME,
    's.json': JSON.stringify(SCENARIO),
    'last.mjs': LAST,
    'typed.ts': TYPED,
  };
  for (const [name, text] of Object.entries(files)) writeFileSync(join(project, name), text);
  const [first, second] = node('example.mjs').trim().split('\n');
  if (!/^end wasm /.test(first) || second !== '20 20 2 2') throw new Plain(`The example prints\n${first}\n${second}`);

  const library = numbersOf(node('same.mjs'));
  const command = numbersOf(node('node_modules/ripstik-lab/dist/cli.js', 'simulate', 's.json'));
  const sources = numbersOf(
    run(process.execPath, ['--import', 'tsx', 'src/cli/main.ts', 'simulate', join(project, 's.json')], root),
  );
  if (library !== command || library !== sources)
    throw new Plain('Library, command and repository differ in their numbers.');
  node(
    join(root, 'node_modules/typescript/bin/tsc'),
    ...'typed.ts --noEmit --strict --target es2022 --module nodenext --moduleResolution nodenext --skipLibCheck'.split(
      ' ',
    ),
  );
  await inBrowser(project, node('last.mjs').trim());
  console.log('The package installs, its example runs, its numbers are the command line’s to the bit, its types hold.');
  return 0;
});

/** What a bundler makes of the package: how large it is, and that a browser computes the same bits with it. */
async function inBrowser(project, expected) {
  const sizes = {};
  for (const [name, code] of Object.entries({
    'one error class': "import { ScenarioError } from 'ripstik-lab'; globalThis.x = ScenarioError;",
    simulate: LAST,
    everything: "import * as all from 'ripstik-lab'; globalThis.x = { ...all };",
  })) {
    const entry = join(project, 'entry.mjs');
    writeFileSync(entry, code);
    const bundle = await rolldown({ input: entry, cwd: project, platform: 'browser', logLevel: 'warn' });
    const { output } = await bundle.write({ dir: join(project, 'bundled', name), format: 'esm', minify: true });
    await bundle.close();
    const first = new Set();
    const take = (file) => {
      if (first.has(file)) return;
      first.add(file);
      output.find(({ fileName }) => fileName === file)?.imports.forEach(take);
    };
    take(output.find(({ isEntry }) => isEntry).fileName);
    sizes[name] = output
      .filter(({ fileName }) => first.has(fileName))
      .reduce((sum, { code }) => sum + gzipSync(code).length, 0);
  }
  if (!(sizes['one error class'] < sizes.simulate / 10))
    throw new Plain(`A bundler leaves nothing out: ${JSON.stringify(sizes)}`);
  const folder = join(project, 'bundled/simulate');
  writeFileSync(join(folder, 'index.html'), '<!doctype html><script type="module" src="entry.js"></script>');
  const { chromium } = await import('@playwright/test');
  const { server, port } = await serve({ port: 0, folder });
  const browser = await chromium.launch({ executablePath: (await findBrowser()) || undefined, args: ['--no-sandbox'] });
  try {
    const page = await browser.newPage();
    await page.goto(`http://127.0.0.1:${port}/`);
    await page.waitForFunction(() => globalThis.document.title !== '', null, { timeout: 120_000 });
    const found = await page.title();
    if (found !== expected) throw new Plain(`In a browser the package computes\n${found}\nand not\n${expected}`);
  } finally {
    await browser.close();
    server.close();
  }
  const kB = (bytes) => `${(bytes / 1000).toFixed(1)} kB`;
  console.log(
    `Bundled and gzipped, before anything is loaded later: ${Object.entries(sizes)
      .map(([name, bytes]) => `${name} ${kB(bytes)}`)
      .join(', ')}.`,
  );
  console.log('A browser computes the same bits with it.');
}

/** A table's numbers, whatever the digits that they are written with. */
function numbersOf(table) {
  const lines = table.split('\n').filter((line) => line !== '' && !line.startsWith('#'));
  const rows = lines.slice(1).map((line) => Array.from(line.split(','), Number));
  if (rows.length < 10 || rows.flat().some(Number.isNaN)) throw new Plain('A table has no numbers.');
  return lines[0] + JSON.stringify(rows);
}
