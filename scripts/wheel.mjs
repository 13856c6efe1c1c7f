// npm run wheel: the Python package `ripstik_lab` as a wheel in .cache/wheel, with the core that `npm run package` built inside.
import { cpSync, existsSync, mkdirSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { pip, venv } from './python.mjs';
import { Plain, cache, main, readJson, root, run } from './setup.mjs';

/** What lies beside the sources while the wheel is built: from where, and where to. */
const BESIDE = [
  ['python/pyproject.toml', 'pyproject.toml'],
  ['docs/python.md', 'README.md'],
  ['LICENSE', 'LICENSE'],
  ['.cache/package/LICENCES.txt', 'LICENCES.txt'],
  ['.cache/package/dist', 'ripstik_lab/core'],
];

main(async () => {
  const packed = join(cache, 'package/package.json');
  if (!existsSync(packed)) throw new Plain('The core is not built: npm run package.');
  const { version, type } = readJson(packed);
  if (version !== readJson(join(root, 'package.json')).version)
    throw new Plain('The built core is of another version: npm run package.');

  const stage = join(cache, 'wheel-sources');
  const wheels = join(cache, 'wheel');
  for (const folder of [stage, wheels]) rmSync(folder, { recursive: true, force: true });
  cpSync(join(root, 'python/ripstik_lab'), join(stage, 'ripstik_lab'), {
    recursive: true,
    filter: (path) => !/__pycache__|[\\/]core$/.test(path),
  });
  for (const [from, to] of BESIDE) cpSync(join(root, from), join(stage, to), { recursive: true });
  const page = [join(root, 'scripts/stage-page.mjs'), join(stage, 'ripstik_lab/stage.html.gz')];
  const { code, output } = await run(process.execPath, ['--import', 'tsx', ...page]);
  if (code !== 0) throw new Plain(`The stage for notebooks is not built:\n${output.trim()}`);
  writeFileSync(join(stage, 'VERSION'), `${version}\n`);
  // By this Node takes the core's files as modules.
  writeFileSync(join(stage, 'ripstik_lab/core/package.json'), `${JSON.stringify({ type })}\n`);

  mkdirSync(wheels, { recursive: true });
  const python = await venv(join(cache, 'wheel-venv'));
  await pip(python, ['wheel', '--no-deps', '-w', wheels, stage]);
  console.log(join(wheels, readdirSync(wheels)[0]));
  return 0;
});
