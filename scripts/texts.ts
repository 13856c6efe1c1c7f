// npm run texts [word …]: every text of the page, one a line, with the file and key it stands under; with words, only those
// lines that contain one of them. For reading all of it in one sitting, as somebody from elsewhere would.
import { readdirSync } from 'node:fs';
import { dirname, join, relative } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { cases, systemIds, systemMetas } from '../src/core/systems/registry.ts';

const root = join(dirname(fileURLToPath(import.meta.url)), '..');
const wanted = process.argv.slice(2).map((word) => word.toLowerCase());

const say = (place: string, text: string): void => {
  const line = `${place}  ${text.replace(/\s+/g, ' ')}`;
  if (text.trim() && (wanted.length === 0 || wanted.some((word) => line.toLowerCase().includes(word))))
    console.log(line);
};

/** What a function of words says for stand-ins; some do arithmetic with them, some look things up. */
function said(make: (...all: unknown[]) => unknown): unknown {
  for (const stand of [(i: number): unknown => `⟨${i + 1}⟩`, (): unknown => 3]) {
    try {
      const made = make(...Array.from({ length: make.length }, (_, i) => stand(i)));
      if (typeof made === 'string' && !made.includes('NaN')) return made;
      if (typeof made === 'object') return made;
    } catch (_) {
      // The next kind of stand-in.
    }
  }
  return '(made from what the program knows then)';
}

function walk(place: string, value: unknown): void {
  if (typeof value === 'string') say(place, value);
  else if (typeof value === 'function') walk(place, said(value as (...all: unknown[]) => unknown));
  else if (typeof value === 'object' && value !== null)
    for (const [key, inner] of Object.entries(value)) walk(`${place}.${key}`, inner);
}

const files = readdirSync(join(root, 'src'), { recursive: true, encoding: 'utf8' })
  .filter((file) => /(^|[\\/])(words|firstWords)\.ts$/.test(file))
  .sort();
for (const file of files) {
  const path = join(root, 'src', file);
  walk(relative(root, path), await import(pathToFileURL(path).href));
}
for (const { id, title, look, plots = [] } of cases)
  walk(`case ${id}`, { title, look, plots: plots.map((plot) => plot.title) });
for (const id of systemIds)
  for (const list of ['coordinates', 'parameters', 'inputs'] as const)
    for (const { name, label } of systemMetas[id]![list]) say(`system ${id}.${list}.${name}`, label);
