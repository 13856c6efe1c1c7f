/** Writes public/models/<body>.mdl and .mat for the default board; `--check` compares instead. */
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { loadDrawing } from '../src/core/systems/registry.ts';
import { ripstikMeta } from '../src/core/systems/ripstik/meta.ts';

const folder = new URL('../public/models/', import.meta.url);
const { pairs } = await loadDrawing(ripstikMeta, {});

const files = Object.entries(pairs).flatMap(([name, { mdl, mat }]) => [
  { url: new URL(`${name}.mdl`, folder), text: mdl },
  { url: new URL(`${name}.mat`, folder), text: mat },
]);

function isSame(url: URL, text: string): boolean {
  try {
    return readFileSync(url, 'utf8') === text;
  } catch {
    return false;
  }
}

if (process.argv.includes('--check')) {
  const stale = files.filter(({ url, text }) => !isSame(url, text));
  for (const { url } of stale)
    console.error(`${fileURLToPath(url)} is not what the generator writes: run npm run models`);
  process.exitCode = stale.length > 0 ? 1 : 0;
} else {
  mkdirSync(folder, { recursive: true });
  for (const { url, text } of files) writeFileSync(url, text);
}
