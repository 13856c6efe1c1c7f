// npm test: installs what is missing, then types, lint, unit tests, build, tests in a real browser.
// Every stage that can run does; the exit code is 1 when any failed. The last line is `N passed, N failed`.
import { existsSync, mkdirSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { findBrowser } from './browser.mjs';
import { Plain, build, built, cache, freePort, install, main, readJson, root, run, runPackage } from './setup.mjs';

const SHOW = { show: true };
const STAGES = {
  types: async () => ({ ok: (await runPackage('typescript/bin/tsc', ['-b'], SHOW)).code === 0 }),
  format: async () => ({
    ok: (await runPackage('prettier/bin/prettier.cjs', ['--check', '.', '--log-level', 'warn'], SHOW)).code === 0,
  }),
  lint: async () => ({ ok: (await runPackage('eslint/bin/eslint.js', ['.', '--max-warnings=0'], SHOW)).code === 0 }),
  unit: unitStage,
  build: buildStage,
  browser: browserStage,
};
const USAGE = `npm test [-- stage …] [-- further arguments]
  stages: ${Object.keys(STAGES).join(' ')} (all of them without a name)
  With one stage named, further arguments go to its runner: npm test -- unit projection, npm test -- browser -g drop`;

/** Browser tests that may pass on a second try, by title, each with its reason. Any other that needs one has failed. */
const MAY_BE_RETRIED = {};

async function unitStage(further) {
  const report = join(cache, 'unit.json');
  rmSync(report, { force: true });
  const reporters = ['--reporter=default', '--reporter=json', `--outputFile.json=${report}`];
  const { code } = await runPackage('vitest/vitest.mjs', ['run', ...reporters, ...further], SHOW);
  const { numPassedTests = 0, numFailedTests = 0, numPendingTests = 0 } = existsSync(report) ? readJson(report) : {};
  return { ok: code === 0, passed: numPassedTests, failed: numFailedTests, skipped: numPendingTests };
}

async function buildStage() {
  if (!(await build(SHOW))) return { ok: false };
  const { code, output } = await run(process.execPath, [join(root, 'scripts/size.mjs')]);
  console.log(output.trimEnd());
  // One stands for all: what docs/adding-a-feature.md promises of every folder under src/features.
  const removal = await run(process.execPath, [join(root, 'scripts/without-feature.mjs'), 'compare'], SHOW);
  const packed = await run(process.execPath, [join(root, 'scripts/package.mjs')], SHOW);
  const tried = packed.code === 0 ? await run(process.execPath, [join(root, 'scripts/try-package.mjs')], SHOW) : packed;
  const commands =
    packed.code === 0 ? await run(process.execPath, [join(root, 'scripts/try-commands.mjs')], SHOW) : packed;
  return { ok: [code, removal.code, tried.code, commands.code].every((status) => status === 0) };
}

async function browserStage(further) {
  if (!existsSync(join(root, 'tests/browser'))) {
    console.log('There are no browser tests (tests/browser) yet.');
    return { ok: true };
  }
  if (!built() && !(await build())) {
    console.log('Not run: there is no built page.');
    return { ok: false };
  }
  const browser = await findBrowser();
  console.log(`Browser: ${browser || "Playwright's own"}`);
  const report = join(cache, 'browser.json');
  rmSync(report, { force: true });
  const env = { RIPSTIK_BROWSER: browser, RIPSTIK_TEST_PORT: String(await freePort()) };
  const { code } = await runPackage('@playwright/test/cli.js', ['test', ...further], { show: true, env });
  const { stats = {}, suites = [] } = existsSync(report) ? readJson(report) : {};
  const { expected = 0, flaky = 0, unexpected = 0, skipped = 0 } = stats;
  const retried = flakyIn(suites);
  const faults = retried.filter((title) => !(title in MAY_BE_RETRIED));
  for (const title of retried)
    console.log(`Passed on a retry only: ${title} (${MAY_BE_RETRIED[title] ?? 'a failure'})`);
  return {
    ok: code === 0 && faults.length === 0,
    passed: expected + flaky - faults.length,
    failed: unexpected + faults.length,
    skipped,
  };
}

/** Titles of the tests that failed and passed when they were tried again. */
function flakyIn(suites) {
  return suites.flatMap(({ specs = [], suites: inner = [] }) => [
    ...specs.filter(({ tests }) => tests.some(({ status }) => status === 'flaky')).map(({ title }) => title),
    ...flakyIn(inner),
  ]);
}

function selection(args) {
  const names = [];
  while (args.length && args[0] in STAGES) names.push(args.shift());
  if (args[0] === '--') args.shift();
  const runner = names.length === 1 && ['unit', 'browser'].includes(names[0]);
  if (args.length && !runner) throw new Plain(`'${args[0]}' is not understood here.\n${USAGE}`);
  return { names: names.length ? names : Object.keys(STAGES), further: args };
}

async function runStage(name, further) {
  console.log(`\n── ${name}`);
  const started = Date.now();
  let result;
  try {
    result = await STAGES[name](further);
  } catch (error) {
    console.log(error instanceof Plain ? error.message : error);
    result = { ok: false };
  }
  const { ok, passed = 0, failed = 0, skipped = 0 } = result;
  // A stage that failed without a failing test (types, a crash, no browser) counts as one failure in the sum.
  return {
    name,
    ok,
    passed,
    failed: ok ? failed : Math.max(failed, 1),
    skipped,
    seconds: (Date.now() - started) / 1000,
  };
}

main(async (args) => {
  if (args.includes('--help') || args.includes('-h')) {
    console.log(USAGE);
    return 0;
  }
  const { names, further } = selection(args);
  await install();
  mkdirSync(cache, { recursive: true });
  const results = [];
  for (const name of names) results.push(await runStage(name, further));

  console.log('\n── summary');
  for (const { name, ok, passed, failed, skipped, seconds } of results) {
    const tests = name === 'unit' || name === 'browser' ? `  ${passed} passed, ${failed} failed` : '';
    const further = skipped ? `, ${skipped} skipped` : '';
    console.log(`${name.padEnd(8)} ${ok ? 'ok    ' : 'FAILED'} ${seconds.toFixed(0).padStart(4)} s${tests}${further}`);
  }
  const sum = (key) => results.reduce((total, result) => total + result[key], 0);
  console.log(`\n${sum('passed')} passed, ${sum('failed')} failed`);
  return results.every((result) => result.ok) ? 0 : 1;
});
