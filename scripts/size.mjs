// What the built page weighs: all that its first view loads and the JavaScript of it, gzipped, and that no system's
// equations are in it twice. The build notes which module went into which file (`chunks.ts`);
// `tests/browser/firstView.spec.ts` holds what is counted here to what a browser loads.
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { basename, join, sep } from 'node:path';
import { gzipSync } from 'node:zlib';
import { firstView } from './firstView.mjs';
import { Plain, main, root } from './setup.mjs';

/** A page on a slow connection should draw before a person gives up; the bounds are the project's own. */
const LIMIT_KB = { all: 341, scripts: 332 };
const dist = join(root, 'dist');
const list = join(root, '.cache/chunks.json');

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
  const weigh = (name) => gzipSync(readFileSync(join(dist, name)), { level: 9 }).length / 1000;
  const total = (names) => names.reduce((sum, name) => sum + weigh(name), 0);
  const loaded = [...first];
  const sum = { all: total(loaded), scripts: total(loaded.filter((name) => name.endsWith('.js'))) };
  for (const name of [...new Set([...scripts, ...loaded])].sort())
    console.log(`${weigh(name).toFixed(1).padStart(7)} kB  ${basename(name)}${first.has(name) ? '' : '  (later)'}`);
  const { systems, faults } = equations;
  for (const fault of faults) console.log(fault);
  if (systems.length === 0) throw new Plain('no equations were found in dist: this check looks for the wrong names.');
  if (faults.length === 0)
    console.log(`${systems.length} systems, the equations of each in one file, none in the page`);
  const line = (kB, what) => console.log(`${kB.toFixed(1).padStart(7)} kB  ${what}`);
  line(total(scripts), 'all scripts, gzip');
  line(sum.scripts, `scripts of the first view, gzip (limit ${LIMIT_KB.scripts} kB)`);
  line(sum.all, `all of the first view, gzip (limit ${LIMIT_KB.all} kB)`);
  return sum.all < LIMIT_KB.all && sum.scripts < LIMIT_KB.scripts && faults.length === 0 ? 0 : 1;
});
