import { readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';

const read = (file: string): string => readFileSync(new URL(`../../${file}`, import.meta.url), 'utf8');
const manifest = JSON.parse(read('package.json')) as Record<'dependencies' | 'devDependencies', Record<string, string>>;
interface Lock {
  packages: Record<
    string,
    { version?: string; integrity?: string; resolved?: string; license?: string; link?: boolean }
  >;
}
const lock = JSON.parse(read('package-lock.json')) as Lock;
const siteLock = JSON.parse(read('site/package-lock.json')) as Lock;

/** Rows of the page's tables: name, version, licence, reason. */
const page = read('docs/dependencies.md')
  .split('\n')
  .filter((line) => /^\| \S+ \| \d/.test(line))
  .map((line) => line.split('|').map((cell) => cell.trim()));

describe('dependencies', () => {
  test('are pinned exactly, and have each a line with its version, licence and reason', () => {
    const all = { ...manifest.dependencies, ...manifest.devDependencies };
    expect(Object.fromEntries(page.map(([, name, version]) => [name, version]))).toEqual(all);
    for (const [, name, version, licence, ...rest] of page) {
      const entry = lock.packages[`node_modules/${name}`]!;
      expect(version, name).toMatch(/^\d+\.\d+\.\d+(-[\w.]+)?$/);
      expect([entry.version, entry.license], name).toEqual([version, licence]);
      expect(rest.at(-2)!.length, `why ${name}`).toBeGreaterThan(10);
    }
  });

  test('of the site are pinned too, and named with their version', () => {
    const { devDependencies } = JSON.parse(read('site/package.json')) as typeof manifest;
    expect(Object.keys(devDependencies)).toEqual(['vitepress']);
    expect(read('docs/dependencies.md')).toContain(`VitePress ${devDependencies['vitepress']} (MIT)`);
  });

  test.each([lock, siteLock])('have a digest each, and no address', (of) => {
    const packages = Object.entries(of.packages).filter(([place]) => place !== '');
    expect(packages.length).toBeGreaterThan(20);
    for (const [place, entry] of packages) {
      expect(entry.integrity, place).toMatch(/^sha512-/);
      expect(entry.resolved, place).toBeUndefined();
    }
  });
});
