// A Vite plugin: writes down which module went into which built file, for `scripts/size.mjs`.
import { mkdirSync, writeFileSync } from 'node:fs';
import { dirname, relative, sep } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { Plugin } from 'vite';

const ROOT = fileURLToPath(new URL('..', import.meta.url));
const LIST = fileURLToPath(new URL('../.cache/chunks.json', import.meta.url));

/** A built script: who runs it, what it imports at once, and the bytes of each of its modules, by path from the root. */
export interface Chunk {
  by: 'page' | 'worker';
  imports: readonly string[];
  modules: Readonly<Record<string, number>>;
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
        const sizes = Object.entries(file.modules).map(([id, { renderedLength }]) => [
          relative(ROOT, id).replaceAll(sep, '/'),
          renderedLength,
        ]);
        chunks[file.fileName] = { by, imports: file.imports, modules: Object.fromEntries(sizes) as Chunk['modules'] };
      }
    },
    writeBundle() {
      if (by === 'worker') return;
      mkdirSync(dirname(LIST), { recursive: true });
      writeFileSync(LIST, JSON.stringify(chunks));
    },
  });
  return { page: plugin('page'), worker: plugin('worker') };
}
