// The npm package as a stranger has it: packed, installed into an empty project without a registry, its README's example and
// its command used, its numbers compared with the repository's command line, its types read.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { Plain, cache, main, root } from './setup.mjs';

const NPM = process.platform === 'win32' ? 'npm.cmd' : 'npm';
const SCENARIO = { version: 1, system: 'ripstik', initial: { X_dot: 1, alpha: '10 deg' }, duration: 0.15 };
const SAME = `import { simulate } from 'ripstik-lab';
const run = await simulate(${JSON.stringify(SCENARIO)});
console.log(run.names.join());
for (let row = 0; row < run.columns[0].length; row++) console.log(run.columns.map((c) => c[row]).join());
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
  const files = { 'example.mjs': example, 'same.mjs': SAME, 's.json': JSON.stringify(SCENARIO), 'typed.ts': TYPED };
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
  console.log('The package installs, its example runs, its numbers are the command line’s to the bit, its types hold.');
  return 0;
});

/** A table's numbers, whatever the digits that they are written with. */
function numbersOf(table) {
  const lines = table.split('\n').filter((line) => line !== '' && !line.startsWith('#'));
  const rows = lines.slice(1).map((line) => Array.from(line.split(','), Number));
  if (rows.length < 10 || rows.flat().some(Number.isNaN)) throw new Plain('A table has no numbers.');
  return lines[0] + JSON.stringify(rows);
}
