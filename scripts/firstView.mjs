// Which files of the built page its first view loads.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { Plain, root } from './setup.mjs';

const dist = join(root, 'dist');

/** What the first view asks for although it comes in files of its own: the scene, so that the panel need not wait for it, what computes the first motion and draws it, and what comes soon after: the lower part of the panel, the service worker, the runs kept from before. */
const AT_ONCE = [
  'src/scene/scene.ts',
  'src/compute/worker.ts',
  'src/compute/services/run.ts',
  'src/core/systems/ripstik/equations.generated.ts',
  'src/core/geometry/drawings.ts',
  'src/core/systems/ripstik/drawing.ts',
  'src/core/systems/ripstik-rider/drawing.ts',
  'src/app/offline.ts',
  'src/app/persistence/keptRuns.ts',
  'src/features/experiment/lowerSections.tsx',
];

/**
 * The files that are loaded with the first view: index.html, what it names, what is asked for at once, what these import.
 *
 * @param {Readonly<Record<string, { imports: readonly string[], styles: readonly string[], modules: object }>>} chunks
 * @returns {Set<string>} paths in `dist`
 */
export function firstView(chunks) {
  const html = readFileSync(join(dist, 'index.html'), 'utf8');
  const named = [...html.matchAll(/<(?:script|link)\b[^>]*\b(?:src|href)="\.?\/?([^"]+\.(?:js|css|svg))"/g)].map(
    (match) => match[1],
  );
  const queue = named.filter((file) => file.endsWith('.js'));
  if (queue.length === 0) throw new Plain('dist/index.html names no script.');
  for (const module of AT_ONCE) {
    const holder = Object.keys(chunks).find((file) => module in chunks[file].modules);
    if (!holder) throw new Plain(`no file of dist holds ${module}.`);
    queue.push(holder);
  }
  return new Set(['index.html', ...named.filter((file) => !file.endsWith('.js')), ...withImports(chunks, queue)]);
}

/**
 * Files with what they import at once and are styled by, and that in turn.
 *
 * @param {Readonly<Record<string, { imports: readonly string[], styles: readonly string[] }>>} chunks
 * @param {readonly string[]} from paths in `dist`
 * @returns {Set<string>} paths in `dist`
 */
export function withImports(chunks, from) {
  const files = new Set();
  const queue = [...from];
  for (let file = queue.pop(); file; file = queue.pop()) {
    if (files.has(file)) continue;
    files.add(file);
    queue.push(...(chunks[file]?.imports ?? []));
    for (const style of chunks[file]?.styles ?? []) files.add(style);
  }
  return files;
}
