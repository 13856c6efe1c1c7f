// The one direction of imports: `core` knows nobody, views do not know each other, only `main` knows everyone.
import { readFileSync, readdirSync } from 'node:fs';
import { dirname, join, relative, resolve, sep } from 'node:path';
import { expect, test } from 'vitest';

const MAY_IMPORT: Record<string, readonly string[]> = {
  core: [],
  csv: ['core'],
  compute: ['core', 'csv'],
  offline: [],
  scene: ['core'],
  charts: ['core'],
  cli: ['core', 'csv'],
  app: ['core', 'csv', 'compute'],
  ui: ['core', 'app'],
  features: ['core', 'csv', 'charts', 'app', 'ui'],
  stage: ['core', 'scene', 'app'],
  main: ['core', 'csv', 'compute', 'stage', 'app', 'ui', 'features'],
};
/** Packages that one folder alone imports. */
const ONLY: Record<string, string> = { three: 'scene', uplot: 'charts', katex: 'features', mediabunny: 'features' };

const src = resolve('src');
const files = readdirSync(src, { recursive: true, encoding: 'utf8' }).filter(
  (name) => /\.tsx?$/.test(name) && !/\.(test|spec)\.tsx?$/.test(name),
);
/** `from '…'`, `import '…'`, `import('…')`, `new URL('…', import.meta.url)`. */
const IMPORT = /(?:\bfrom\s*|\bimport\s*\(?\s*|\bnew URL\(\s*)['"]([^'"]+)['"]/g;

/** The part of the house a file belongs to: its folder, or `main` for the entry. */
const partOf = (path: string) =>
  relative(src, path)
    .split(sep)[0]!
    .replace(/\.tsx?$/, '');

function faults(name: string): string[] {
  const path = join(src, name);
  const part = partOf(path);
  if (!(part in MAY_IMPORT)) return [`${name}: '${part}' is not in the table`];
  return [...readFileSync(path, 'utf8').matchAll(IMPORT)].flatMap(([, specifier]) => {
    if (!specifier!.startsWith('.')) {
      const owner = ONLY[specifier!.split('/')[0]!];
      return owner && owner !== part ? [`${name}: only ${owner} imports ${specifier}`] : [];
    }
    const target = partOf(resolve(dirname(path), specifier!));
    return target === part || target === '..' || MAY_IMPORT[part]!.includes(target) ? [] : [`${name}: ${specifier}`];
  });
}

test('imports point one way', () => {
  expect(files.length).toBeGreaterThan(10);
  expect(files.flatMap(faults)).toEqual([]);
});
