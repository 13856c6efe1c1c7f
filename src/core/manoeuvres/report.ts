import type { CheckedTest } from './testFile.ts';
import type { Measured } from './run.ts';

/** What came of a test. */
export interface Outcome {
  name: string;
  measure: string;
  /** [least, most]; null: none. */
  bound: [number | null, number | null];
  passed: boolean;
  /** Of a single run; of a spread the value that is worst off. Null where there is none. */
  value: number | null;
  /** In words. */
  message: string;
  /** Of a spread: how many runs passed, and the numbers of all. */
  spread?: { passed: number; count: number; values: (number | null)[] };
  /** Of computing. */
  seconds: number;
}

export interface TestReport {
  version: 1;
  system: string;
  passed: number;
  failed: number;
  seconds: number;
  tests: Outcome[];
  /** What is to be said of the controller itself. */
  notes: string[];
}

const numberOrNull = (x: number): number | null => (Number.isFinite(x) ? x : null);
const short = (x: number): string => String(Number(x.toPrecision(4))).replace('-', '\u2212');

/**
 * @param test checked
 * @param runs as many as the test has; an error's words in the place of a run that could not begin
 * @param seconds that the test took
 */
export function outcomeOf(test: CheckedTest, runs: readonly (Measured | string)[], seconds: number): Outcome {
  const within = (run: Measured | string): boolean =>
    typeof run !== 'string' && run.value >= test.low && run.value <= test.high;
  const passedRuns = runs.filter(within).length;
  const passed = passedRuns >= Math.ceil((test.spread?.share ?? 1) * runs.length - 1e-9);
  // How far outside its bounds; a run without a number is worst.
  const miss = (run: Measured | string): number => {
    if (typeof run === 'string' || Number.isNaN(run.value)) return Infinity;
    return Math.max(test.low - run.value, run.value - test.high);
  };
  const worst = [...runs].sort((a, b) => miss(b) - miss(a))[0]!;
  const value = typeof worst === 'string' ? null : numberOrNull(worst.value);
  return {
    name: test.name,
    measure: test.measure,
    bound: [numberOrNull(test.low), numberOrNull(test.high)],
    passed,
    value,
    message: wordsOf(test, worst, runs.length, passedRuns),
    ...(test.spread
      ? {
          spread: {
            passed: passedRuns,
            count: runs.length,
            values: runs.map((run) => (typeof run === 'string' ? null : numberOrNull(run.value))),
          },
        }
      : {}),
    seconds,
  };
}

/** Why a run that went on to its end has no number. */
function withoutNumber({ parsed, measure, after }: CheckedTest): string {
  if ('fact' in parsed) return `this system has no ${measure}: nothing of it goes along the ground`;
  if (parsed.kind === 'settle') return `${measure}: not settled by the end of the run, within a fiftieth of its change`;
  if (parsed.kind === 'rise') return `${measure}: it does not rise`;
  return after === undefined ? `the run has no ${measure}` : `the run has no ${measure} after ${short(after)} s`;
}

function wordsOf(test: CheckedTest, worst: Measured | string, count: number, passed: number): string {
  const many = count > 1 ? `${passed} of ${count} runs passed; the worst: ` : '';
  if (typeof worst === 'string') return many + worst;
  const { value, end } = worst;
  if (Number.isNaN(value))
    return many + (end.reason === 'end' ? withoutNumber(test) : `the run stopped early: ${end.message}`);
  const told = (x: number): string => (test.degrees ? `${short((x * 180) / Math.PI)}°` : short(x));
  const bounds =
    test.low === -Infinity
      ? `at most ${told(test.high)}`
      : test.high === Infinity
        ? `at least ${told(test.low)}`
        : `${told(test.low)} to ${told(test.high)}`;
  return `${many}${test.measure} = ${told(value)}; must be ${bounds}`;
}

/**
 * The report of all tests of a file.
 *
 * @param system its id
 * @param tests what came of each
 * @param notes on the controller itself
 */
export function reportOf(system: string, tests: readonly Outcome[], notes: readonly string[] = []): TestReport {
  const passed = tests.filter((t) => t.passed).length;
  return {
    version: 1,
    system,
    passed,
    failed: tests.length - passed,
    seconds: tests.reduce((sum, t) => sum + t.seconds, 0),
    tests: [...tests],
    notes: [...notes],
  };
}

const escaped = (text: string): string =>
  text.replace(
    /[<>&"'\u0000-\u0008\u000b\u000c\u000e-\u001f]/g,
    (c) => ({ '<': '&lt;', '>': '&gt;', '&': '&amp;', '"': '&quot;', "'": '&apos;' })[c] ?? '\ufffd',
  );

/** JUnit's XML, as build servers read it. */
export function junitOf({ system, tests, failed, seconds, notes }: TestReport): string {
  const cases = tests.map((t) => {
    const open = `    <testcase classname="${escaped(system)}" name="${escaped(t.name)}" time="${t.seconds.toFixed(3)}"`;
    if (t.passed) return `${open}>\n      <system-out>${escaped(t.message)}</system-out>\n    </testcase>`;
    return `${open}>\n      <failure message="${escaped(t.message)}"/>\n    </testcase>`;
  });
  const counts = `tests="${tests.length}" failures="${failed}" errors="0" time="${seconds.toFixed(3)}"`;
  return [
    '<?xml version="1.0" encoding="UTF-8"?>',
    `<testsuites ${counts}>`,
    `  <testsuite name="${escaped(system)}" ${counts}>`,
    ...cases,
    ...(notes.length > 0 ? [`    <system-out>${escaped(notes.join('\n'))}</system-out>`] : []),
    '  </testsuite>',
    '</testsuites>',
    '',
  ].join('\n');
}
