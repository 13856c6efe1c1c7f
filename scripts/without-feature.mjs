// node scripts/without-feature.mjs ID …: proves that each of these features can be removed. In a copy of the sources its
// folder and its line in src/features/registry.ts are deleted; the copy must pass the type check and the build, and
// what was built must hold nothing that only this feature had. Exit 1 and the reason when it does not.
import {
  cpSync,
  existsSync,
  mkdtempSync,
  readFileSync,
  readdirSync,
  rmSync,
  symlinkSync,
  writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { Plain, main, root, run } from './setup.mjs';

/** What the type check and the build read. */
const NEEDED = ['src', 'docs', 'public', 'scripts'];

/** Names that a test finds elements by: they are in the built page as they stand here. */
const MARK = /(?:data-testid|testId)="([\w-]+)"/g;

function filesBelow(folder, pattern) {
  return readdirSync(folder, { recursive: true, encoding: 'utf8' })
    .filter((name) => pattern.test(name))
    .map((name) => join(folder, name));
}

function marksIn(files) {
  return new Set(files.flatMap((file) => [...readFileSync(file, 'utf8').matchAll(MARK)].map(([, mark]) => mark)));
}

async function check(what, program, args, cwd) {
  const { code, output } = await run(process.execPath, [join(root, 'node_modules', program), ...args], { cwd });
  if (code !== 0) throw new Plain(`${what} fails:\n${output.trim()}`);
}

async function without(id) {
  const copy = mkdtempSync(join(tmpdir(), 'ripstik-without-'));
  try {
    for (const name of NEEDED) cpSync(join(root, name), join(copy, name), { recursive: true });
    // The page, its settings, its licence: every file beside them.
    for (const entry of readdirSync(root, { withFileTypes: true }))
      if (entry.isFile() && !entry.name.startsWith('.')) cpSync(join(root, entry.name), join(copy, entry.name));
    // What an earlier check found out stays true of the files that are the same.
    for (const name of ['types', 'core.tsbuildinfo', 'page.tsbuildinfo'])
      if (existsSync(join(root, '.cache', name)))
        cpSync(join(root, '.cache', name), join(copy, '.cache', name), { recursive: true });
    symlinkSync(join(root, 'node_modules'), join(copy, 'node_modules'), 'junction');

    const folder = join(copy, 'src/features', id);
    const registry = join(copy, 'src/features/registry.ts');
    const lines = readFileSync(registry, 'utf8').split('\n');
    const left = lines.filter((line) => !line.includes(`'./${id}/`));
    if (!existsSync(folder) || left.length !== lines.length - 1) throw new Plain('it has not one folder and one line');
    const own = marksIn(filesBelow(folder, /\.tsx?$/));
    rmSync(folder, { recursive: true });
    writeFileSync(registry, left.join('\n'));

    await check('the type check', 'typescript/bin/tsc', ['-b', 'tsconfig.page.json'], copy);
    await check('the build', 'vite/bin/vite.js', ['build', '--logLevel', 'warn'], copy);
    const others = marksIn(filesBelow(join(copy, 'src'), /\.tsx?$/));
    const built = filesBelow(join(copy, 'dist'), /\.(js|css|html)$/).map((file) => readFileSync(file, 'utf8'));
    const traces = [...own].filter((mark) => {
      const used = new RegExp(`(?:data-testid["'\`]?|testId):["'\`]${mark}["'\`]`);
      return !others.has(mark) && built.some((text) => used.test(text));
    });
    if (traces.length) throw new Plain(`the built page still has ${traces.join(', ')}`);
    console.log(`${id}: removed, with ${own.size} names; types and build pass, nothing of it is left`);
  } finally {
    rmSync(copy, { recursive: true, force: true });
  }
}

main(async (ids) => {
  if (ids.length === 0) throw new Plain('Which feature? node scripts/without-feature.mjs ID …');
  for (const id of ids) {
    try {
      await without(id);
    } catch (error) {
      throw error instanceof Plain ? new Plain(`${id}: ${error.message}`) : error;
    }
  }
  return 0;
});
