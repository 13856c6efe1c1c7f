// The JavaScript that the page's first view loads, gzipped: what index.html names, what that imports statically, and
// what the first view asks for at once although it comes in files of its own.
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { basename, dirname, join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { Plain, main, root } from './setup.mjs';

/** A page on a slow connection should draw before a person gives up; the bound is the project's own. */
const LIMIT_KB = 400;
const dist = join(root, 'dist');

/** The scene, so that the panel need not wait for it, and the worker that computes the first motion with its system. */
const AT_ONCE = /^(scene|run\.worker)-/;
/** What that worker loads for the first case. */
const FIRST_SYSTEM = /\bripstik-[\w-]+\.js/;

/** `import … from './x.js'`, `import './x.js'` and `export … from './x.js'`, also minified; not `import('./x.js')`. */
const STATIC = /(?:^|[;}\s])(?:import|export)\b[\w$*{},\s]*["'](\.[^"']+\.js)["']/g;

function firstView() {
  const html = readFileSync(join(dist, 'index.html'), 'utf8');
  const named = [...html.matchAll(/<(?:script|link)\b[^>]*\b(?:src|href)="([^"]+\.js)"/g)].map((match) => match[1]);
  const files = new Set();
  const atOnce = readdirSync(join(dist, 'assets')).filter((name) => AT_ONCE.test(name) && name.endsWith('.js'));
  if (atOnce.length < 2) throw new Plain('the scene or the run worker is missing from dist/assets.');
  const worker = atOnce.find((name) => name.startsWith('run.worker'));
  const system = FIRST_SYSTEM.exec(readFileSync(join(dist, 'assets', worker), 'utf8'));
  if (!system) throw new Plain(`${worker} names no file of the first system.`);
  atOnce.push(system[0]);
  const queue = [...named.map((path) => join(dist, path)), ...atOnce.map((name) => join(dist, 'assets', name))];
  for (let file = queue.pop(); file; file = queue.pop()) {
    if (files.has(file) || !existsSync(file)) continue;
    files.add(file);
    for (const [, path] of readFileSync(file, 'utf8').matchAll(STATIC)) queue.push(join(dirname(file), path));
  }
  return files;
}

main(async () => {
  const first = firstView();
  if (first.size === 0) throw new Plain('dist/index.html names no script.');
  const scripts = readdirSync(dist, { recursive: true }).filter((name) => name.endsWith('.js'));
  let sum = 0;
  for (const path of scripts.map((name) => join(dist, name)).sort()) {
    const size = gzipSync(readFileSync(path), { level: 9 }).length / 1000;
    if (first.has(path)) sum += size;
    console.log(`${size.toFixed(1).padStart(7)} kB  ${basename(path)}${first.has(path) ? '' : '  (later)'}`);
  }
  console.log(`${sum.toFixed(1).padStart(7)} kB  first view, gzip (limit ${LIMIT_KB} kB)`);
  return sum < LIMIT_KB ? 0 : 1;
});
