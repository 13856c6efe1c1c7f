// The one direction of imports: `core` knows nobody, views do not know each other, only `main` knows everyone; nobody in a circle.
import { readFileSync, readdirSync } from 'node:fs';
import { dirname, join, relative, resolve, sep } from 'node:path';
import { describe, expect, test } from 'vitest';

type Table = Readonly<Record<string, readonly string[]>>;

/** Which folder of `src` may import which. */
const PARTS: Table = {
  core: [],
  csv: ['core'],
  compute: ['core', 'csv'],
  offline: [],
  scene: ['core'],
  charts: ['core'],
  cli: ['core', 'csv'],
  package: ['core'],
  app: ['core', 'csv', 'compute'],
  ui: ['core', 'app'],
  features: ['core', 'csv', 'charts', 'app', 'ui'],
  stage: ['core', 'scene', 'app'],
  main: ['core', 'csv', 'compute', 'stage', 'app', 'ui', 'features'],
};
/** Which folder of `src/core` may import which. */
const CORE: Table = {
  elementary: [],
  linalg: [],
  model: [],
  geometry: ['model'],
  integrators: ['elementary', 'linalg'],
  scenario: ['elementary', 'model', 'integrators'],
  mechanics: ['elementary', 'linalg', 'model', 'integrators'],
  cases: ['linalg', 'model', 'integrators', 'scenario'],
  description: ['elementary', 'linalg', 'model', 'engine', 'scenario', 'geometry'],
  systems: ['elementary', 'model', 'geometry', 'cases', 'scenario', 'description'],
  engine: ['elementary', 'model', 'integrators', 'mechanics'],
  simulation: ['elementary', 'linalg', 'model', 'integrators', 'mechanics', 'engine', 'scenario'],
  motion: ['linalg', 'model', 'cases', 'simulation'],
  gait: ['model', 'scenario', 'simulation', 'motion'],
  manoeuvres: ['model', 'mechanics', 'scenario', 'simulation', 'motion'],
  sweep: ['model', 'mechanics', 'scenario', 'simulation', 'motion'],
  control: ['elementary', 'linalg', 'model', 'mechanics', 'scenario', 'motion'],
  lessons: ['model', 'mechanics', 'scenario', 'motion', 'sweep', 'control'],
  exchange: ['linalg', 'model', 'engine', 'description', 'mechanics', 'scenario', 'simulation'],
};
/** Packages that one folder alone imports. */
const ONLY: Readonly<Record<string, string>> = {
  three: 'scene',
  katex: 'ui',
  mediabunny: 'features',
};

const src = resolve('src');
/** `from '…'`, `import '…'`, `import('…')`, `new URL('…', import.meta.url)`. */
const IMPORT = /(?:\bfrom\s*|\bimport\s*\(?\s*|\bnew URL\(\s*)['"]([^'"]+)['"]/g;

/** What each file names in its imports. */
const imports: ReadonlyMap<string, readonly string[]> = new Map(
  readdirSync(src, { recursive: true, encoding: 'utf8' })
    .filter((name) => /\.tsx?$/.test(name) && !/\.(test|spec)\.tsx?$/.test(name))
    .map((name) => [
      name,
      [...readFileSync(join(src, name), 'utf8').matchAll(IMPORT)].map(([, specifier]) => specifier!),
    ]),
);

const targetOf = (name: string, specifier: string): string => relative(src, resolve(src, dirname(name), specifier));

/** The folder of `root` that a file lies in, or its own name for an entry file; null outside. */
function partOf(name: string, root: string): string | null {
  if (root && !name.startsWith(root + sep)) return null;
  return name
    .slice(root ? root.length + 1 : 0)
    .split(sep)[0]!
    .replace(/\.tsx?$/, '');
}

/** Imports that the table of the folders in `root` does not allow. */
function forbidden(root: string, table: Table): string[] {
  return [...imports].flatMap(([name, specifiers]) => {
    const part = partOf(name, root);
    if (part === null) return [];
    if (!(part in table)) return [`${name}: '${part}' is not in the table`];
    return specifiers
      .filter((specifier) => specifier.startsWith('.'))
      .filter((specifier) => {
        const target = partOf(targetOf(name, specifier), root);
        return target !== null && target !== '..' && target !== part && !table[part]!.includes(target);
      })
      .map((specifier) => `${name}: ${specifier}`);
  });
}

/** A path through the graph that comes back to where it began, or null. */
function circle(graph: ReadonlyMap<string, readonly string[]>): string[] | null {
  const done = new Set<string>();
  const path: string[] = [];
  const visit = (node: string): string[] | null => {
    const seen = path.indexOf(node);
    if (seen >= 0) return [...path.slice(seen), node];
    if (done.has(node)) return null;
    path.push(node);
    for (const next of graph.get(node) ?? []) {
      const found = visit(next);
      if (found) return found;
    }
    path.pop();
    done.add(node);
    return null;
  };
  for (const node of graph.keys()) {
    const found = visit(node);
    if (found) return found;
  }
  return null;
}

const files = new Map(
  [...imports].map(([name, specifiers]) => [
    name,
    specifiers.filter((specifier) => specifier.startsWith('.')).map((specifier) => targetOf(name, specifier)),
  ]),
);

describe('imports point one way', () => {
  test('there are files', () => expect(files.size).toBeGreaterThan(100));

  test('between the folders of src', () => expect(forbidden('', PARTS)).toEqual([]));

  test('between the folders of core', () => expect(forbidden('core', CORE)).toEqual([]));

  test('a package that is one folder’s is imported there alone', () => {
    const elsewhere = [...imports].flatMap(([name, specifiers]) =>
      specifiers
        .filter((specifier) => {
          const owner = ONLY[specifier.split('/')[0]!];
          return owner && owner !== partOf(name, '');
        })
        .map((specifier) => `${name}: ${specifier}`),
    );
    expect(elsewhere).toEqual([]);
  });

  test.each([
    ['src', PARTS],
    ['core', CORE],
  ])('the table of %s allows no circle', (_, table) => expect(circle(new Map(Object.entries(table)))).toBeNull());

  test('no file reaches itself', () => {
    expect(circle(files)).toBeNull();
  });

  test('a feature imports no other, and the kit neither shell nor stage', () => {
    const crossing = [...files].flatMap(([name, targets]) => {
      const [part, folder] = name.split(sep);
      return targets
        .filter((target) => {
          const [other, inner] = target.split(sep);
          if (part === 'features' && name.split(sep).length > 2) return other === 'features' && inner !== folder;
          return part === 'ui' && folder === 'kit' && other === 'ui' && (inner === 'shell' || inner === 'stage');
        })
        .map((target) => `${name}: ${target}`);
    });
    expect(crossing).toEqual([]);
  });

  test('a circle would be seen', () => {
    expect(
      circle(
        new Map([
          ['a', ['b']],
          ['b', ['c']],
          ['c', ['b']],
        ]),
      ),
    ).toEqual(['b', 'c', 'b']);
  });
});
