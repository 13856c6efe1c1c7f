// The exported C is compiled as a person would compile it, and says itself how far it is from what the program computes.
import { spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, expect, test } from 'vitest';
import { templates } from '../../../src/core/description/templates.ts';
import { systemIds } from '../../../src/core/systems/registry.ts';
import { exported, typed } from './exports.ts';

const compiler = spawnSync('cc', ['--version']).status === 0;
const folder = mkdtempSync(join(tmpdir(), 'exchange-'));
afterAll(() => rmSync(folder, { recursive: true, force: true }));

/** Compiles with every warning an error, runs, and gives what is printed. */
function compiled(text: string): { status: number | null; output: string } {
  const [file, program] = [join(folder, 'system.c'), join(folder, 'system')];
  writeFileSync(file, text);
  const flags = ['-std=c99', '-O0', '-Wall', '-Wextra', '-Werror', '-Wno-unused-variable'];
  const cc = spawnSync('cc', [...flags, '-DTEST', file, '-lm', '-o', program], { encoding: 'utf8' });
  if (cc.status !== 0) return { status: cc.status, output: cc.stderr };
  const { status, stdout } = spawnSync(program, { encoding: 'utf8' });
  return { status, output: stdout };
}

const difference = (output: string): number => Number(/relative difference (\S+)/.exec(output)?.[1] ?? NaN);

test.skipIf(!compiler).each(systemIds)('%s', async (system) => {
  const { text } = await exported({ system }, 'c');
  const { status, output } = compiled(text);
  expect(status, output).toBe(0);
  expect(difference(output), output).toBeLessThan(1e-12);
});

test.skipIf(!compiler).each(templates.map(({ id }) => id).filter((id) => !systemIds.includes(id)))(
  'typed: %s',
  async (id) => {
    const { status, output } = compiled((await exported(await typed(id), 'c')).text);
    expect(status, output).toBe(0);
    expect(difference(output), output).toBeLessThan(1e-12);
  },
);

test.skipIf(!compiler).each([
  ['held coordinates', { system: 'ripstik', hold: ['alpha_fp', 'theta_bc'], initial: { X_dot: 1, alpha_fp: 0.2 } }],
  ['losses', { system: 'ripstik', parameterSet: 'authors', parameters: { wheelDrag: 0.5, torsionStiffness: 3 } }],
  [
    'time',
    {
      system: {
        description: `coordinate x, y [m]\nbody b mass 2 at (x, y, 0)\ndrive y = sin(3 t)\nvelocity x' = 0.2 y`,
      },
    },
  ],
  [
    'functions',
    {
      system: {
        description: `coordinate x, y [m]\nkinetic 1/2 x'^2 + 1/2 y'^2\npotential abs(x) + tanh(y) + cbrt(x) + log2(1 + x^2) + (x < y ? x^2 : y^2)\nforce floor(5 x) + atan2(x, y) on x`,
      },
    },
  ],
])('with %s', async (_, raw) => {
  const { status, output } = compiled((await exported(raw, 'c')).text);
  expect(status, output).toBe(0);
  expect(difference(output), output).toBeLessThan(1e-12);
});

test.skipIf(!compiler)('a wrong number is found by the test that comes with it', async () => {
  const { text } = await exported({ system: 'chaplygin-sleigh' }, 'c');
  const wrong = text.replace(/(_parameters\[PARAMETERS \+ 1\] = \{)[\d.]+/, '$17.25');
  expect(wrong).not.toBe(text);
  expect(compiled(wrong).status).toBe(1);
});
