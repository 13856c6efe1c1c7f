// The command lines of README.md, docs/exchange.md and docs/sweeps.md as they are written, through the built program (npm run package) in an empty
// folder; docs/sweeps.md's Slurm array as the scheduler would start it. Says what fails.
import { spawn, spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, statSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { parquetReadObjects } from 'hyparquet';
import { Plain, cache, main, root } from './setup.mjs';

const PROGRAM = `"${process.execPath}" "${join(cache, 'package/dist/cli.js')}"`;
/** So many parts stand for the array of the page. */
const TASKS = 3;

/** The first fenced block of a document in a language, from where a text stands. */
function blockOf(file, language, after = '') {
  const text = readFileSync(join(root, file), 'utf8');
  const found = new RegExp(`\`\`\`${language}\n([^]*?)\`\`\``).exec(text.slice(text.indexOf(after)));
  if (!found) throw new Plain(`${file} has no block of ${language || 'commands'}.`);
  return found[1];
}

const asBuilt = (line) => line.replaceAll('npm run --silent ripstik --', PROGRAM);

function start(line, folder) {
  return new Promise((done) => {
    const child = spawn(asBuilt(line), { cwd: folder, shell: true, stdio: ['ignore', 'pipe', 'pipe'] });
    let said = '';
    for (const stream of [child.stdout, child.stderr]) stream.on('data', (text) => (said += text));
    child.on('close', (code) => done({ line, code, said }));
  });
}

function judge({ line, code, said }) {
  if (code !== 0)
    throw new Plain(`This line of the documents ends with status ${code}:\n  ${line}\n${said.slice(-1000)}`);
}

/** What is no comment, and needs nothing that is not there. */
const linesOf = (block) =>
  block
    .split('\n')
    .map((line) => line.replace(/\s+#.*$/, ''))
    // SymPy derives for some ten seconds; `derivation/test_exchange.py` runs these scripts.
    .map((line) => line.replace(/ && python3 .*$/, ''))
    .map((line) => (spawnSync('cc', ['--version']).status === 0 ? line : line.replace(/ && cc .*$/, '')))
    .filter((line) => line !== '');

main(async () => {
  const folder = mkdtempSync(join(tmpdir(), 'commands-'));
  writeFileSync(join(folder, 'study.json'), blockOf('docs/sweeps.md', 'json'));
  const written = [
    ...linesOf(blockOf('README.md', '', '## Command line')),
    ...linesOf(blockOf('docs/exchange.md', 'sh')),
  ];
  // The first two write what the others read; these go side by side, two at a time.
  for (const line of written.slice(0, 2)) judge(await start(line, folder));
  const rest = written.slice(2);
  await Promise.all(
    [0, 1].map(async () => {
      for (let line = rest.shift(); line !== undefined; line = rest.shift()) judge(await start(line, folder));
    }),
  );
  const rows = process.platform === 'win32' ? null : await array(folder);
  console.log(
    `${written.length} command lines run as they are written${rows ? `; a Slurm array of ${TASKS} gives the ${rows} rows of one process, to the bit` : ''}.`,
  );
  return 0;
});

/** Each task of the array with the variables that Slurm sets; the first is requeued when it has ended, and then does nothing. */
async function array(folder) {
  const script = blockOf('docs/sweeps.md', 'sh', '**Several machines.**');
  const task = (id) => {
    const slurm = { SLURM_ARRAY_TASK_ID: id, SLURM_ARRAY_TASK_COUNT: TASKS, SLURM_CPUS_PER_TASK: 2 };
    const env = { ...process.env, ...Object.fromEntries(Object.entries(slurm).map(([k, v]) => [k, String(v)])) };
    const { status, stderr } = spawnSync('bash', ['-c', asBuilt(script)], { cwd: folder, env, encoding: 'utf8' });
    judge({ line: `task ${id} of the array in docs/sweeps.md`, code: status, said: stderr });
  };
  for (let id = 1; id <= TASKS; id++) task(id);
  const before = statSync(join(folder, 'results-1.parquet')).mtimeMs;
  task(1);
  if (statSync(join(folder, 'results-1.parquet')).mtimeMs !== before)
    throw new Plain('A task that was done already wrote its part again.');
  const whole = await tableOf(join(folder, 'results.parquet'));
  const parts = (
    await Promise.all([...Array(TASKS)].map((_, k) => tableOf(join(folder, `results-${k + 1}.parquet`))))
  ).flat();
  parts.sort((a, b) => a.index - b.index);
  const bits = (rows) =>
    JSON.stringify(
      rows.map((row) => Object.entries(row).map(([name, x]) => [name, Object.is(x, -0) ? '-0' : String(x)])),
    );
  if (bits(parts) !== bits(whole)) throw new Plain('The parts of the array, joined, are not the table of one process.');
  return whole.length;
}

function tableOf(path) {
  const bytes = readFileSync(path);
  return parquetReadObjects({ file: bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength) });
}
