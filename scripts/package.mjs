// npm run package [-- FOLDER]: the npm package `ripstik-lab` from the core and the command line, ready for `npm pack`.
import { chmodSync, cpSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { rolldown } from 'rolldown';
import { Plain, cache, main, readJson, root, runPackage } from './setup.mjs';

/** Fields of the repository's manifest that are the package's too. */
const SHARED = ['name', 'version', 'license', 'type', 'engines'];

main(async ([folder = join(cache, 'package')]) => {
  const types = await runPackage('typescript/bin/tsc', ['-b'], { show: true });
  if (types.code !== 0) throw new Plain('The types have faults.');
  rmSync(folder, { recursive: true, force: true });

  const input = { index: join(root, 'src/package/index.ts'), cli: join(root, 'src/cli/main.ts') };
  // What it needs of others is inside, so that installing it fetches nothing; Node's own modules are the command line's alone.
  const bundle = await rolldown({ input, platform: 'browser', external: /^node:/, logLevel: 'warn' });
  const { output } = await bundle.write({
    dir: join(folder, 'dist'),
    format: 'esm',
    banner: ({ name, isEntry }) => (isEntry && name === 'cli' ? '#!/usr/bin/env node' : ''),
  });
  await bundle.close();
  chmodSync(join(folder, 'dist/cli.js'), 0o755);

  for (const [from, part] of [
    ['core', 'core'],
    ['node', 'package'],
  ])
    cpSync(join(cache, `types/${from}/src/${part}`), join(folder, `types/${part}`), {
      recursive: true,
      filter: (path) => !path.endsWith('.map'),
    });

  const own = readJson(join(root, 'package.json'));
  const manifest = {
    ...Object.fromEntries(SHARED.map((key) => [key, own[key]])),
    description:
      'Mechanics and control of the caster board (RipStik): simulation, linearization, sweeps; library and command.',
    exports: { '.': { types: './types/package/index.d.ts', default: './dist/index.js' } },
    bin: { 'ripstik-lab': 'dist/cli.js' },
    sideEffects: ['./dist/cli.js'],
    files: ['dist', 'types', 'LICENCES.txt'],
  };
  writeFileSync(join(folder, 'package.json'), `${JSON.stringify(manifest, null, 2)}\n`);
  for (const [from, to] of [
    ['LICENSE', 'LICENSE'],
    ['docs/package.md', 'README.md'],
  ])
    cpSync(join(root, from), join(folder, to));
  writeFileSync(join(folder, 'LICENCES.txt'), licencesOf(output));
  console.log(`${folder}: npm pack there, or npm publish`);
  return 0;
});

/** The licence texts of the packages whose code is inside. */
function licencesOf(output) {
  const modules = output.flatMap((chunk) => chunk.moduleIds ?? []);
  const names = new Set(modules.map((id) => /.*node_modules\/((?:@[^/]+\/)?[^/]+)\//.exec(id)?.[1]).filter(Boolean));
  return [...names].sort().map(licenceOf).join('\n\n');
}

function licenceOf(name) {
  const folder = join(root, 'node_modules', name);
  const { version, license } = readJson(join(folder, 'package.json'));
  const text = ['LICENSE', 'LICENSE.md', 'LICENSE.txt', 'license', 'LICENCE'].map((file) => {
    try {
      return readFileSync(join(folder, file), 'utf8').trim();
    } catch {
      return '';
    }
  });
  return `${name} ${version}: ${license}\n\n${text.find(Boolean) ?? ''}`;
}
