// What the commands share: the Node check, installing what is missing, building what is stale.
// Plain Node without a dependency, in syntax that old versions read, so that they can say what is wrong.
import { spawn } from 'node:child_process';
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readFileSync, readdirSync, statSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:net';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

export const root = dirname(dirname(fileURLToPath(import.meta.url)));
export const cache = join(root, '.cache');

/** A failure whose message is all that the person needs: shown without a stack. */
export class Plain extends Error {}

/** Runs a command's main function; its result, or 1 after a `Plain` failure, becomes the exit code. */
export function main(command) {
  requireNode();
  command(process.argv.slice(2)).then(
    (code) => {
      process.exitCode = code || 0;
    },
    (error) => {
      console.error(error instanceof Plain ? error.message : error);
      process.exitCode = 1;
    },
  );
}

/** Vite 8's floor: 20.19 or newer in line 20, 22.12 or newer above it. */
export function requireNode(version = process.versions.node) {
  const [major, minor] = version.split('.').map(Number);
  if ((major === 20 && minor >= 19) || (major === 22 && minor >= 12) || major > 22) return;
  const which = major > 20 ? ', or 22.12 or newer in line 22' : '';
  console.error(
    `RipStik Lab needs Node 20.19 or newer${which}; this is ${version}. Install a newer one and run the same command again.`,
  );
  process.exit(1);
}

/**
 * Runs a program to its end. `show` passes its output on (`'stderr'`: everything to standard error); otherwise the
 * output is kept. Standard input is closed, so nothing can ask a question.
 */
export function run(program, args, { show = false, env = {}, timeout = 0, shell = false, cwd = root } = {}) {
  return new Promise((done) => {
    const out = show === 'stderr' ? 2 : show ? 'inherit' : 'pipe';
    const child = spawn(program, args, {
      cwd,
      env: { ...process.env, ...env },
      stdio: ['ignore', out, show ? 'inherit' : 'pipe'],
      timeout,
      shell,
    });
    let output = '';
    for (const stream of [child.stdout, child.stderr]) if (stream) stream.on('data', (text) => (output += text));
    child.on('error', (error) => done({ code: 127, output: output + error.message }));
    child.on('close', (code, signal) => done({ code: signal ? 130 : code, output }));
  });
}

/** Runs a package's program (a path under node_modules) with this Node. */
export function runPackage(path, args, options) {
  return run(process.execPath, [join(root, 'node_modules', path), ...args], options);
}

/**
 * Whether node_modules holds what the lock file names, by npm's own record of its last complete installation.
 * An installation that was cut short leaves no such record; packages for other platforms may be absent.
 */
export function installed() {
  const record = join(root, 'node_modules', '.package-lock.json');
  if (!existsSync(record)) return false;
  const wanted = readJson(join(root, 'package-lock.json')).packages;
  const present = readJson(record).packages;
  const same = (a, b) => a && b && a.version === b.version && a.integrity === b.integrity;
  const optional = (entry) => entry.optional || entry.devOptional || entry.os || entry.cpu;
  return (
    Object.keys(present).every((path) => same(present[path], wanted[path])) &&
    Object.keys(wanted).every((path) => path === '' || present[path] || optional(wanted[path]))
  );
}

/** Installs the locked packages where they are missing or others. One line on `say` when there is something to do. */
export async function install(say = console.log) {
  if (installed()) return;
  say('Installing packages (once, about half a minute) …');
  // No package here needs its install script; the retries are npm's, with shorter waits.
  const quiet = ['--no-audit', '--no-fund', '--loglevel=error', '--no-progress'];
  const options = [
    '--ignore-scripts',
    '--include=dev',
    '--fetch-retry-mintimeout=1000',
    '--fetch-retry-maxtimeout=8000',
  ];
  const { code, output } = await npm(['ci', ...quiet, ...options]);
  if (code === 0) return;
  if (
    /ENOTFOUND|EAI_AGAIN|ECONNREFUSED|ECONNRESET|ENETUNREACH|EHOSTUNREACH|ETIMEDOUT|ERR_SOCKET|ENOTCACHED/.test(output)
  ) {
    throw new Plain(
      'Cannot install the packages: the package registry cannot be reached. Connect to the network and run the same command again.',
    );
  }
  throw new Plain(`Cannot install the packages; npm says:\n${output.trim()}`);
}

function npm(args) {
  const own = process.env.npm_execpath || '';
  // The npm that started us, as a script: no shell, no lookup. Otherwise the one on the path (a .cmd on Windows).
  if (/npm-cli\.[cm]?js$/.test(own)) return run(process.execPath, [own, ...args]);
  return run('npm', args, { shell: process.platform === 'win32' });
}

const buildRecord = join(cache, 'build.json');

/** Names, sizes and times of everything the page is built from. */
function buildInputs() {
  const lines = [];
  const add = (path) => {
    const full = join(root, path);
    if (!existsSync(full)) return;
    const entry = statSync(full);
    if (entry.isDirectory()) for (const name of readdirSync(full).sort()) add(`${path}/${name}`);
    else lines.push(`${path} ${entry.size} ${entry.mtimeMs}`);
  };
  ['index.html', 'package.json', 'package-lock.json', 'tsconfig.base.json', 'vite.config.ts', 'public', 'src'].forEach(
    add,
  );
  return createHash('sha256').update(lines.join('\n')).digest('hex');
}

export function built() {
  return (
    existsSync(join(root, 'dist', 'index.html')) &&
    existsSync(buildRecord) &&
    readJson(buildRecord).inputs === buildInputs()
  );
}

/** Builds dist; true on success. The record is of the inputs before, so that a file saved meanwhile counts as newer. */
export async function build({ show = false } = {}) {
  const inputs = buildInputs();
  mkdirSync(cache, { recursive: true });
  const { code, output } = await runPackage('vite/bin/vite.js', ['build', '--logLevel', 'warn'], { show });
  if (code === 0) writeFileSync(buildRecord, JSON.stringify({ inputs }));
  else if (!show) console.error(output.trim());
  return code === 0;
}

export function readJson(path) {
  return JSON.parse(readFileSync(path, 'utf8'));
}

/** A port that nothing listens on. */
export function freePort() {
  return new Promise((done, fail) => {
    const probe = createServer().once('error', fail);
    probe.listen(0, '127.0.0.1', () => {
      const { port } = probe.address();
      probe.close(() => done(port));
    });
  });
}

/** Puts a table into docs/robustness.md, between the marks of its name. */
export function writeTable(name, lines) {
  const page = join(root, 'docs/robustness.md');
  const text = readFileSync(page, 'utf8');
  const [from, to] = [`<!-- ${name} -->`, `<!-- end of ${name} -->`];
  if (!text.includes(from) || !text.includes(to)) throw new Error(`docs/robustness.md has no place for the ${name}`);
  writeFileSync(
    page,
    `${text.slice(0, text.indexOf(from) + from.length)}\n${lines.join('\n')}\n${text.slice(text.indexOf(to))}`,
  );
  console.log(lines.join('\n'));
}
