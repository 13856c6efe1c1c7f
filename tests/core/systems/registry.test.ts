import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { dirname, relative, resolve } from 'node:path';
import { describe, expect, test } from 'vitest';
import {
  cases,
  loadDrawing,
  loadSystem,
  loadTypeset,
  systemIds,
  systemViews,
} from '../../../src/core/systems/registry.ts';

const root = resolve('src/core/systems');
const folders = readdirSync(root, { withFileTypes: true })
  .filter((entry) => entry.isDirectory())
  .map(({ name }) => name);

test('every folder is registered under its name, once', () => {
  expect(folders.length).toBeGreaterThan(8);
  expect([...systemIds].sort()).toEqual([...folders].sort());
});

describe.each(folders)('%s', (id) => {
  test.each([
    'meta.ts',
    'view.ts',
    'cases.ts',
    'drawing.ts',
    'index.ts',
    'equations.generated.ts',
    'jacobians.generated.ts',
    'poses.generated.ts',
    'typeset.generated.json',
  ])('has its %s', (file) => expect(existsSync(resolve(root, id, file))).toBe(true));

  test('is complete: names, a case, dynamics for every constraint set, formulas, a mesh for every body', async () => {
    const { meta, poses } = systemViews[id]!;
    expect(meta.id).toBe(id);
    expect(cases.some(({ scenario }) => scenario.system === id)).toBe(true);
    const system = (await loadSystem(id))!;
    const withRows = meta.constraintSets.filter((set) => set.rows !== undefined);
    expect(Object.keys(system.constraintSets)).toEqual(withRows.map((set) => set.id));
    for (const { contact } of withRows)
      for (const name of contact?.solveFor ?? []) expect(meta.coordinates.map((c) => c.name)).toContain(name);
    const out = new Float64Array(12 * meta.bodies.length).fill(NaN);
    const parameters = Float64Array.from(meta.parameters, (p) => p.default);
    poses(
      Float64Array.from(meta.coordinates, (c) => c.rest ?? 0),
      parameters,
      out,
    );
    expect(out.every(Number.isFinite)).toBe(true);
    expect((await loadTypeset(id))!.system).toBe(id);
    expect((await loadDrawing(meta, {})).bodies.filter(({ limb }) => !limb).map((body) => body.id)).toEqual(
      meta.bodies.map((body) => body.id),
    );
  });

  test('can be deleted with its line: nothing general names it', () => {
    const general = readdirSync(root, { withFileTypes: true }).filter((entry) => entry.isFile());
    const named = general.filter(({ name }) => readFileSync(resolve(root, name), 'utf8').includes(`./${id}/`));
    expect(named.map(({ name }) => name)).toEqual(['registry.ts']);
  });
});

test('a system that is not there is undefined, whatever its name', () => {
  for (const id of ['unicycle', 'constructor', '__proto__', '']) {
    expect(loadSystem(id)).toBeUndefined();
    expect(loadTypeset(id)).toBeUndefined();
  }
});

/** What a file brings with it at once: its static imports and theirs; types are erased. */
function bringsAlong(path: string, seen = new Set<string>()): Set<string> {
  if (seen.has(path)) return seen;
  seen.add(path);
  const text = readFileSync(path, 'utf8');
  for (const [, names, specifier] of text.matchAll(/^(?:import|export) (?!type )([^;'"]*?)from '(\.[^']+)';/gm))
    if (names) bringsAlong(resolve(dirname(path), specifier!), seen);
  return seen;
}

test('the registry brings names, poses and cases along, but no equations, formulas or meshes', () => {
  const along = [...bringsAlong(resolve(root, 'registry.ts'))].map((path) => relative(root, path));
  expect(along).toContain('ripstik/poses.generated.ts');
  expect(along).toContain('ripstik/cases.ts');
  expect(
    along.filter((path) =>
      /(equations|jacobians)\.generated|typeset\.generated|drawing\.ts$|solids|wavefront/.test(path),
    ),
  ).toEqual(['../geometry/drawing.ts']);
});

test('general code asks the meta and never for a system by name', () => {
  const named = new RegExp(`[!=]==\\s*['"\`](${systemIds.join('|')})['"\`]`);
  const general = readdirSync(resolve('src'), { recursive: true, encoding: 'utf8' }).filter(
    (name) => /\.tsx?$/.test(name) && !/\.(test|spec|generated)\./.test(name) && !name.startsWith('core/systems/'),
  );
  expect(general.length).toBeGreaterThan(100);
  expect(general.filter((name) => named.test(readFileSync(resolve('src', name), 'utf8')))).toEqual([]);
});
