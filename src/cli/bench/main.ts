import { readFileSync, writeFileSync } from 'node:fs';
import { measureAll, type Measured } from './measureAll.ts';
import { fillPage, picturesOf, tables } from './report.ts';
import { csvOf, type Problem } from './workPrecision.ts';

/** Prints how fast this machine computes; `--write` also renews `docs/performance.md` and `docs/bench/`. */
const USAGE = `npm run bench -- [--json] [--quick] [--write]
  --json    print everything as JSON instead of tables
  --quick   a few samples of everything: shows that it works, measures nothing
  --write   write docs/performance.md, docs/bench/*.csv, *.svg and results.json`;

function write({ results, work }: Measured): void {
  const docs = (name: string): URL => new URL(`../../../docs/${name}`, import.meta.url);
  for (const problem of Object.keys(work) as Problem[]) {
    writeFileSync(docs(`bench/${problem}.csv`), csvOf(work[problem]));
    for (const [name, svg] of Object.entries(picturesOf(problem, work[problem])))
      writeFileSync(docs(`bench/${name}`), svg);
  }
  writeFileSync(docs('bench/results.json'), `${JSON.stringify(results, null, 1)}\n`);
  const page = docs('performance.md');
  writeFileSync(page, fillPage(readFileSync(page, 'utf8'), tables(results)));
}

async function main(args: readonly string[]): Promise<number> {
  const unknown = args.find((a) => !['--json', '--quick', '--write'].includes(a));
  if (unknown !== undefined) {
    console.error(unknown === '--help' ? USAGE : `"${unknown}" is not understood.\n${USAGE}`);
    return unknown === '--help' ? 0 : 2;
  }
  const measured = await measureAll(args.includes('--quick'), (what) => console.error(`… ${what}`));
  if (args.includes('--write')) write(measured);
  if (args.includes('--json')) console.log(JSON.stringify(measured, null, 1));
  else for (const [name, text] of Object.entries(tables(measured.results))) console.log(`\n── ${name}\n\n${text}`);
  return 0;
}

main(process.argv.slice(2)).then(
  (code) => (process.exitCode = code),
  (error: unknown) => {
    console.error(error);
    process.exitCode = 1;
  },
);
