// What the built page weighs: the JavaScript that its first view loads, gzipped, and that no system's equations are in
// it twice. The build notes which module went into which file (`chunks.ts`).
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { basename, join, sep } from 'node:path';
import { gzipSync } from 'node:zlib';
import { Plain, main, root } from './setup.mjs';

/** A page on a slow connection should draw before a person gives up; the bound is the project's own. */
const LIMIT_KB = 400;
const dist = join(root, 'dist');
const list = join(root, '.cache/chunks.json');

/** What the first view asks for although it comes in files of its own: the scene, so that the panel need not wait for it, and what computes the first motion. */
const AT_ONCE = [
  'src/scene/scene.ts',
  'src/compute/worker.ts',
  'src/compute/services/run.ts',
  'src/core/systems/ripstik/equations.generated.ts',
];

/** A system's equations of motion: all that is generated but its poses, which the page draws with. */
const EQUATIONS = /^src\/core\/systems\/([\w-]+)\/(?:.*\/)?(?!poses\b)[\w-]+\.generated\.ts$/;

/**
 * Equations that the page itself holds, or that are in more than one file.
 *
 * @param {Record<string, import('./chunks.ts').Chunk>} chunks
 * @returns {{ systems: Set<string>, faults: string[] }} the systems whose equations were found, and what is wrong
 */
export function repeatedEquations(chunks) {
  const holders = new Map();
  for (const [file, { by, modules }] of Object.entries(chunks))
    for (const [module, bytes] of Object.entries(modules))
      if (bytes > 0 && EQUATIONS.test(module)) holders.set(module, [...(holders.get(module) ?? []), { file, by }]);
  const faults = [...holders].flatMap(([module, files]) => {
    const page = files.filter(({ by }) => by === 'page').map(({ file }) => `${module} is in the page itself: ${file}`);
    const names = files.map(({ file }) => file).join(', ');
    return files.length > 1 ? [...page, `${module} is in ${files.length} files: ${names}`] : page;
  });
  return { systems: new Set([...holders.keys()].map((module) => EQUATIONS.exec(module)[1])), faults };
}

/** The files that are loaded with the first view: what index.html names, what is asked for at once, what these import. */
function firstView(chunks) {
  const html = readFileSync(join(dist, 'index.html'), 'utf8');
  const queue = [...html.matchAll(/<(?:script|link)\b[^>]*\b(?:src|href)="\.?\/?([^"]+\.js)"/g)].map(
    (match) => match[1],
  );
  if (queue.length === 0) throw new Plain('dist/index.html names no script.');
  for (const module of AT_ONCE) {
    const holder = Object.keys(chunks).find((file) => module in chunks[file].modules);
    if (!holder) throw new Plain(`no file of dist holds ${module}.`);
    queue.push(holder);
  }
  const files = new Set();
  for (let file = queue.pop(); file; file = queue.pop()) {
    if (files.has(file)) continue;
    files.add(file);
    queue.push(...(chunks[file]?.imports ?? []));
  }
  return files;
}

function readChunks(scripts) {
  if (!existsSync(list)) throw new Plain(`${list} is missing: build the page.`);
  const chunks = JSON.parse(readFileSync(list, 'utf8'));
  const unknown = scripts.filter((name) => name.startsWith('assets/') && !(name in chunks));
  if (unknown.length > 0) throw new Plain(`${list} is of another build than dist (${unknown[0]}): build the page.`);
  return chunks;
}

/** Run as a script, not when a test imports it. */
if (process.argv[1] === import.meta.filename)
  main(async () => {
    const scripts = readdirSync(dist, { recursive: true })
      .map((name) => name.replaceAll(sep, '/'))
      .filter((name) => name.endsWith('.js'))
      .sort();
    const chunks = readChunks(scripts);
    const first = firstView(chunks);
    let [sum, all] = [0, 0];
    for (const name of scripts) {
      const size = gzipSync(readFileSync(join(dist, name)), { level: 9 }).length / 1000;
      all += size;
      if (first.has(name)) sum += size;
      console.log(`${size.toFixed(1).padStart(7)} kB  ${basename(name)}${first.has(name) ? '' : '  (later)'}`);
    }
    const { systems, faults } = repeatedEquations(chunks);
    for (const fault of faults) console.log(fault);
    console.log(
      `${all.toFixed(1).padStart(7)} kB  all scripts, gzip; the equations of ${systems.size} systems, once each`,
    );
    console.log(`${sum.toFixed(1).padStart(7)} kB  first view, gzip (limit ${LIMIT_KB} kB)`);
    return sum < LIMIT_KB && faults.length === 0 && systems.size > 0 ? 0 : 1;
  });
