// Python for the scripts that need one: `PYTHON`, or python3.
import { join } from 'node:path';
import { Plain, run } from './setup.mjs';

const program = process.env.PYTHON ?? 'python3';

/** Why there is no Python to work with, in a sentence; null where there is one. */
export async function noPython() {
  const { code } = await run(program, ['-c', 'import sys, venv, ensurepip; sys.exit(sys.version_info < (3, 9))']);
  return code === 0 ? null : `there is no Python 3.9 or newer with venv and pip here (${program})`;
}

/** A virtual environment, made anew. @returns its Python @throws Plain */
export async function venv(folder) {
  const missing = await noPython();
  if (missing) throw new Plain(`Not done: ${missing}.`);
  const { code, output } = await run(program, ['-m', 'venv', '--clear', folder]);
  if (code !== 0) throw new Plain(`The virtual environment is not made; Python says:\n${output.trim()}`);
  return join(folder, process.platform === 'win32' ? 'Scripts/python.exe' : 'bin/python');
}

/** Runs pip. @throws Plain */
export async function pip(python, args) {
  const { code, output } = await run(python, ['-m', 'pip', '--quiet', '--disable-pip-version-check', ...args]);
  if (code !== 0) throw new Plain(`pip failed; it says:\n${output.trim()}`);
}
