// A Vite plugin: writes down which module went into which built file, and which system's equations went astray, for
// `scripts/size.mjs`.
import { mkdirSync, writeFileSync } from 'node:fs';
import { dirname, relative, sep } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { Plugin } from 'vite';

const ROOT = fileURLToPath(new URL('..', import.meta.url));
const LIST = fileURLToPath(new URL('../.cache/chunks.json', import.meta.url));

/** A built script: what it imports at once and is styled by, and the bytes of each of its modules, by path from the root. */
export interface Chunk {
  /** The page or the worker begins with it; the others come along or are loaded later. */
  entry: boolean;
  imports: readonly string[];
  styles: readonly string[];
  modules: Readonly<Record<string, number>>;
}

/** A system's equations of motion: all that is generated but its poses, which the page draws with. */
const EQUATIONS = /^src\/core\/systems\/([\w-]+)\/(?:.*\/)?(?!poses\b)[\w-]+\.generated\.ts$/;

/**
 * Where the equations went: right is one file each, loaded when a run asks for it.
 *
 * @returns the systems whose equations were found, and what is wrong
 */
export function equationsIn(chunks: Readonly<Record<string, Chunk>>): { systems: string[]; faults: string[] } {
  const files = new Map<string, string[]>();
  const faults: string[] = [];
  const atOnce = loadedAtOnce(chunks);
  for (const [file, { modules }] of Object.entries(chunks))
    for (const [module, bytes] of Object.entries(modules)) {
      if (bytes === 0 || !EQUATIONS.test(module)) continue;
      files.set(module, [...(files.get(module) ?? []), file]);
      if (atOnce.has(file)) faults.push(`${module} is loaded with the page or the worker: ${file}`);
    }
  for (const [module, holders] of files)
    if (holders.length > 1) faults.push(`${module} is in ${holders.length} files: ${holders.join(', ')}`);
  return { systems: [...new Set([...files.keys()].map((module) => EQUATIONS.exec(module)![1]!))], faults };
}

/** The entries and what they import, and that in turn. */
function loadedAtOnce(chunks: Readonly<Record<string, Chunk>>): ReadonlySet<string> {
  const files = new Set<string>();
  const queue = Object.keys(chunks).filter((file) => chunks[file]!.entry);
  for (let file = queue.pop(); file !== undefined; file = queue.pop()) {
    if (files.has(file)) continue;
    files.add(file);
    queue.push(...(chunks[file]?.imports ?? []));
  }
  return files;
}

export function chunkList(): Plugin {
  return {
    name: 'chunk-list',
    apply: 'build',
    generateBundle(_, bundle) {
      const chunks: Record<string, Chunk> = {};
      for (const file of Object.values(bundle)) {
        if (file.type !== 'chunk') continue;
        const modules: Record<string, number> = {};
        for (const [id, { renderedLength }] of Object.entries(file.modules))
          modules[relative(ROOT, id).replaceAll(sep, '/')] = renderedLength;
        const styles = [...(file.viteMetadata?.importedCss ?? [])];
        chunks[file.fileName] = { entry: file.isEntry, imports: file.imports, styles, modules };
      }
      mkdirSync(dirname(LIST), { recursive: true });
      writeFileSync(LIST, JSON.stringify({ chunks, equations: equationsIn(chunks) }));
    },
  };
}
