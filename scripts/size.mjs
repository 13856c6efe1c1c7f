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
  'src/core/geometry/drawings.ts',
  'src/core/systems/ripstik/drawing.ts',
];

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

function readList(scripts) {
  if (!existsSync(list)) throw new Plain(`${list} is missing: build the page.`);
  const { chunks, equations } = JSON.parse(readFileSync(list, 'utf8'));
  const unknown = scripts.filter((name) => name.startsWith('assets/') && !(name in chunks));
  if (unknown.length > 0) throw new Plain(`${list} is of another build than dist (${unknown[0]}): build the page.`);
  return { chunks, equations };
}

main(async () => {
  const scripts = readdirSync(dist, { recursive: true })
    .map((name) => name.replaceAll(sep, '/'))
    .filter((name) => name.endsWith('.js'))
    .sort();
  const { chunks, equations } = readList(scripts);
  const first = firstView(chunks);
  let [sum, all] = [0, 0];
  for (const name of scripts) {
    const size = gzipSync(readFileSync(join(dist, name)), { level: 9 }).length / 1000;
    all += size;
    if (first.has(name)) sum += size;
    console.log(`${size.toFixed(1).padStart(7)} kB  ${basename(name)}${first.has(name) ? '' : '  (later)'}`);
  }
  const { systems, faults } = equations;
  for (const fault of faults) console.log(fault);
  if (systems.length === 0) throw new Plain('no equations were found in dist: this check looks for the wrong names.');
  if (faults.length === 0)
    console.log(`${systems.length} systems, the equations of each in one file, none in the page`);
  console.log(`${all.toFixed(1).padStart(7)} kB  all scripts, gzip`);
  console.log(`${sum.toFixed(1).padStart(7)} kB  first view, gzip (limit ${LIMIT_KB} kB)`);
  return sum < LIMIT_KB && faults.length === 0 ? 0 : 1;
});
