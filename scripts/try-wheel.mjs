// npm run try-wheel [-- --all]: the wheel as a stranger has it: built, installed into an empty environment without a registry,
// its tests run there. With --all what it can use (NumPy, pandas, python-control, Dask, anywidget) is installed too, and tested with it, a notebook among it.
// It is no part of `npm test`: Python is not needed for that. CI runs it.
import { readdirSync } from 'node:fs';
import { join } from 'node:path';
import { noPython, pip, venv } from './python.mjs';
import { tryNotebook } from './try-notebook.mjs';
import { Plain, cache, main, root, run } from './setup.mjs';

main(async ([option]) => {
  if (option !== undefined && option !== '--all') throw new Plain(`"${option}" is not understood; there is --all.`);
  const missing = await noPython();
  if (missing) {
    console.log(`The wheel is not tried: ${missing}.`);
    return 0;
  }
  const built = await run(process.execPath, [join(root, 'scripts/wheel.mjs')], { show: true });
  if (built.code !== 0) return built.code;
  const wheels = join(cache, 'wheel');
  const wheel = join(wheels, readdirSync(wheels)[0]);
  const python = await venv(join(cache, 'wheel-venv'));
  await pip(python, ['install', '--no-index', wheel]);
  if (option === '--all') await pip(python, ['install', `${wheel}[all]`, 'nbconvert', 'ipykernel']);
  const { code } = await run(python, ['-m', 'unittest', 'discover', '-v', '-s', 'python/tests'], { show: true });
  if (code === 0 && option === '--all') await tryNotebook(python);
  return code;
});
