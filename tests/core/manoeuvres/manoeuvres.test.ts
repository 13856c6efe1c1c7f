// Tests of a vehicle as data: measures of known curves, what a file may say, runs of a spread, reports.
import { describe, expect, test } from 'vitest';
import { deriveSystem, readSystem } from '../../../src/core/description/index.ts';
import { checkScenario } from '../../../src/core/scenario/schema.ts';
import { measureOf, reduced, valuesOf, type Kind } from '../../../src/core/manoeuvres/measure.ts';
import { junitOf, outcomeOf, reportOf } from '../../../src/core/manoeuvres/report.ts';
import { measureRun, runsOf } from '../../../src/core/manoeuvres/run.ts';
import { shippedTests } from '../../../src/core/manoeuvres/shipped.ts';
import { checkTests, parseTests, patched } from '../../../src/core/manoeuvres/testFile.ts';
import { systems } from '../../../src/core/systems/all.ts';
import { metas, scenarioOf } from '../../helpers.ts';

const t = Float64Array.from({ length: 2001 }, (_, i) => i / 100);
/** Second order, damping 0.3, 2 rad/s, from 1 to 3. */
const [zeta, omega] = [0.3, 2];
const response = t.map((x) => {
  const damped = omega * Math.sqrt(1 - zeta * zeta);
  const decay = Math.exp(-zeta * omega * x);
  return 3 - 2 * decay * (Math.cos(damped * x) + ((zeta * omega) / damped) * Math.sin(damped * x));
});

test.each<[Kind, number, number]>([
  ['final', 3, 1e-3],
  ['overshoot', Math.exp((-Math.PI * zeta) / Math.sqrt(1 - zeta * zeta)), 2e-3],
  ['max', 3 + 2 * Math.exp((-Math.PI * zeta) / Math.sqrt(1 - zeta * zeta)), 1e-3],
  ['min', 1, 1e-12],
  // Found by hand of the closed form: 10 % at 0.2535 s, 90 % at 0.914 s; the last time 2 % off at 5.6 s.
  ['rise', 0.66, 0.02],
])('%s of a step response', (kind, value, tolerance) => {
  expect(Math.abs(reduced(kind, t, response) - value)).toBeLessThan(tolerance);
});

test('settle: within a fiftieth from then on, and not before', () => {
  const time = reduced('settle', t, response);
  const off = (x: number, i: number): boolean => t[i]! >= time && Math.abs(x - 3) > 0.0401;
  expect(response.some(off)).toBe(false);
  expect(Math.abs(response[Math.round(time * 100) - 1]! - 3)).toBeGreaterThan(0.0399);
  expect(reduced('settle', t, t)).toBeNaN();
});

test('measures read', () => {
  expect(measureOf('max.alpha_fp')).toEqual({ kind: 'max', expression: 'alpha_fp' });
  expect(measureOf('mean(abs(a) + (b))')).toEqual({ kind: 'mean', expression: 'abs(a) + (b)' });
  expect(measureOf('energyPerMetre')).toEqual({ fact: 'energyPerMetre' });
  expect(() => measureOf('most(alpha)')).toThrow(/no measure; right would be max/);
  const columns = { a: Float64Array.of(1, 2), ab: Float64Array.of(3, 5) };
  expect([...valuesOf('ab - 2*a', ['a', 'ab'], (n) => columns[n as 'a'], 2)]).toEqual([1, 1]);
  expect(() => valuesOf('c', ['a', 'ab'], (n) => columns[n as 'a'], 2)).toThrow(
    /unknown name "c".*columns of the run: a, ab/,
  );
});

const one = (more: object) => ({ version: 1, tests: [{ name: 'x', measure: 'time', bound: [0, 1], ...more }] });

test.each([
  [{ version: 2, tests: [] }, 'version'],
  [{ version: 1, tests: [] }, 'tests'],
  [one({ measure: 'most(x)' }), 'tests[0].measure'],
  [one({ bound: [1, 0] }), 'tests[0].bound'],
  [one({ bound: [null, null] }), 'tests[0].bound'],
  [one({ bound: ['20 grad', 1] }), 'tests[0].bound[0]'],
  [one({ extra: 1 }), 'tests[0].extra'],
  [one({ spread: { vary: { a: { gamma: 1 } }, count: 2 } }), 'tests[0].spread.vary.a.gamma'],
  [one({ spread: { vary: {}, count: 2 } }), 'tests[0].spread.vary'],
])('%j is refused at %s', (file, path) => {
  expect(() => checkTests(file)).toThrow(expect.objectContaining({ path }) as Error);
});

test('a text that is no JSON is told by line and column', () => {
  expect(() => parseTests('{"version": 1,\n "tests": [}')).toThrow(/line 2, column 12/);
});

test('a patch goes into objects, replaces the rest, and leaves out what is null', () => {
  const file = { version: 1, system: 'ripstik', initial: { X_dot: 1, alpha: 0.1 }, hold: ['X'] } as const;
  expect(patched({ ...file, hold: ['X'] }, { initial: { alpha: null, Y: 2 }, hold: ['Y'] })).toEqual({
    version: 1,
    system: 'ripstik',
    initial: { X_dot: 1, Y: 2 },
    hold: ['Y'],
  });
});

describe('a spread', () => {
  const [checked] = checkTests(
    one({
      measure: 'final.X',
      bound: [1.9, null],
      spread: {
        vary: { 'initial.X_dot': { uniform: [1, 3] }, 'parameters.M': { normal: [1, 0.1] } },
        count: 50,
        seed: 3,
      },
    }),
  );
  const runs = runsOf(checked!, { version: 1, system: 'rolling-wheel' });

  test('draws the same again, within its bounds', () => {
    expect(runs).toEqual(runsOf(checked!, { version: 1, system: 'rolling-wheel' }));
    const drawn = runs.map((run) => run.drawn['initial.X_dot']!);
    expect(new Set(drawn).size).toBe(50);
    for (const x of drawn) expect(x > 1 && x < 3).toBe(true);
    expect(runs[0]!.file).toMatchObject({ initial: { X_dot: drawn[0] } });
  });

  test('passes by share, and tells the worst', () => {
    const end = { reason: 'end', message: '', time: 1 };
    const values = [2, 3, 1.5, NaN].map((value) => ({
      value,
      end: Number.isNaN(value) ? { ...end, reason: 'touchdown', message: 'a corner touched' } : end,
    }));
    const most = outcomeOf({ ...checked!, spread: { ...checked!.spread!, count: 4, share: 0.5 } }, values, 0);
    expect(most).toMatchObject({ passed: true, value: null, spread: { passed: 2, count: 4 } });
    expect(most.message).toBe('2 of 4 runs passed; the worst: the run stopped early: a corner touched');
    expect(outcomeOf(checked!, values, 0).passed).toBe(false);
  });
});

test('a run is measured, and one that falls fails with the reason', () => {
  const system = systems['ripstik']!;
  const [lean] = checkTests(one({ measure: 'max(abs(rho_f))', bound: [0, '20 deg'] }));
  const scenario = scenarioOf({ version: 1, system: 'ripstik', initial: { X_dot: 1, alpha: '1 deg' }, duration: 3 });
  const fallen = measureRun(lean!, scenario, system, null);
  expect(fallen.end.reason).toBe('touchdown');
  expect(outcomeOf(lean!, [fallen], 0)).toMatchObject({ passed: false, value: null });
  const [time] = checkTests(one({ stops: true, bound: [0.1, 2] }));
  expect(measureRun(time!, scenario, system, null).value).toBe(fallen.end.time);
});

test('JUnit: one case a test, nothing unescaped', () => {
  const [checked] = checkTests(one({ name: 'a < b & "c"' }));
  const end = { reason: 'end', message: '', time: 1 };
  const outcomes = [1, 2].map((value) => outcomeOf(checked!, [{ value, end }], 0.5));
  const xml = junitOf(reportOf('ripstik', outcomes));
  expect(xml).toContain('tests="2" failures="1" errors="0" time="1.000"');
  expect(xml).toContain('name="a &lt; b &amp; &quot;c&quot;"');
  expect(xml.match(/<failure /g)).toHaveLength(1);
});

test('any system has tests: a bicycle too slow to stand, and one that is typed', () => {
  const slow = scenarioOf({ version: 1, system: 'bicycle', initial: { speed: 2, roll_dot: 0.5 }, duration: 6 });
  const [falls] = checkTests(one({ stops: true, bound: [null, 5] }));
  const run = measureRun(falls!, slow, systems['bicycle']!, null);
  expect(outcomeOf(falls!, [run], 0)).toMatchObject({
    passed: true,
    message: expect.stringMatching(/^time = 4\.\d+; must be at most 5$/) as string,
  });

  const { model, view } = readSystem(
    'system "Spring"\ncoordinate x [m] = 1\nbody b mass 1 at (x, 0, 0)\nforce -x on x\n',
  );
  const typed = deriveSystem(model!, view!);
  const scenario = checkScenario({ version: 1, system: typed.meta.id, duration: 4 }, { [typed.meta.id]: typed.meta });
  const [lowest, settles] = checkTests({
    version: 1,
    tests: [
      { name: 'to the other side', measure: 'min.x', bound: [-1.001, -0.999] },
      { name: 'comes to rest', measure: 'settle.x', bound: [null, 3] },
    ],
  });
  expect(outcomeOf(lowest!, [measureRun(lowest!, scenario, typed, null)], 0).passed).toBe(true);
  const never = outcomeOf(settles!, [measureRun(settles!, scenario, typed, null)], 0);
  expect(never.message).toBe('settle.x: not settled by the end of the run, within a fiftieth of its change');
});

test('figures of a bound in degrees are told in degrees, with a true minus sign', () => {
  const [checked] = checkTests(one({ bound: ['-20 deg', '20 deg'] }));
  const end = { reason: 'end', message: '', time: 1 };
  expect(outcomeOf(checked!, [{ value: -Math.PI / 4, end }], 0)).toMatchObject({
    passed: false,
    value: -Math.PI / 4,
    message: 'time = −45°; must be −20° to 20°',
  });
});

test('what comes with a system is right', () => {
  for (const id of Object.keys(metas)) {
    const shipped = shippedTests(id);
    if (shipped) expect(checkTests(shipped).length).toBeGreaterThan(0);
  }
  expect(shippedTests('constructor')).toBeNull();
});
