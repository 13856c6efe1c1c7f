// A Vite plugin: writes down which module went into which built file, and which system's equations went astray, for
// `scripts/size.mjs`.
import { mkdirSync, writeFileSync } from 'node:fs';
import { dirname, relative, sep } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { Plugin } from 'vite';

const ROOT = fileURLToPath(new URL('..', import.meta.url));
const LIST = fileURLToPath(new URL('../.cache/chunks.json', import.meta.url));

/** A built script: who runs it, what it imports at once and is styled by, and the bytes of each of its modules, by path from the root. */
export interface Chunk {
  by: 'page' | 'worker';
  imports: readonly string[];
  styles: readonly string[];
  modules: Readonly<Record<string, number>>;
}

/** A system's equations of motion: all that is generated but its poses, which the page draws with. */
const EQUATIONS = /^src\/core\/systems\/([\w-]+)\/(?:.*\/)?(?!poses\b)[\w-]+\.generated\.ts$/;

/**
 * Where the equations went: right is one file each, and not the page's.
 *
 * @returns the systems whose equations were found, and what is wrong
 */
export function equationsIn(chunks: Readonly<Record<string, Chunk>>): { systems: string[]; faults: string[] } {
  const files = new Map<string, string[]>();
  const faults: string[] = [];
  for (const [file, { by, modules }] of Object.entries(chunks))
    for (const [module, bytes] of Object.entries(modules)) {
      if (bytes === 0 || !EQUATIONS.test(module)) continue;
      files.set(module, [...(files.get(module) ?? []), file]);
      if (by === 'page') faults.push(`${module} is in the page itself: ${file}`);
    }
  for (const [module, holders] of files)
    if (holders.length > 1) faults.push(`${module} is in ${holders.length} files: ${holders.join(', ')}`);
  return { systems: [...new Set([...files.keys()].map((module) => EQUATIONS.exec(module)![1]!))], faults };
}

/** Workers are built apart, with plugins of their own, before the page is: both note theirs, the page's writes the list. */
export function chunkList(): { page: Plugin; worker: Plugin } {
  const chunks: Record<string, Chunk> = {};
  const plugin = (by: Chunk['by']): Plugin => ({
    name: `chunks-of-the-${by}`,
    apply: 'build',
    generateBundle(_, bundle) {
      for (const file of Object.values(bundle)) {
        if (file.type !== 'chunk') continue;
        const modules: Record<string, number> = {};
        for (const [id, { renderedLength }] of Object.entries(file.modules))
          modules[relative(ROOT, id).replaceAll(sep, '/')] = renderedLength;
        const styles = [...(file.viteMetadata?.importedCss ?? [])];
        chunks[file.fileName] = { by, imports: file.imports, styles, modules };
      }
    },
    writeBundle() {
      if (by === 'worker') return;
      mkdirSync(dirname(LIST), { recursive: true });
      writeFileSync(LIST, JSON.stringify({ chunks, equations: equationsIn(chunks) }));
    },
  });
  return { page: plugin('page'), worker: plugin('worker') };
}
