import { expect, test } from 'vitest';
import { methods } from '../../../src/core/integrators/methods.ts';
import { DigitsMeter, secondScenario, trustSentence, type Trust } from '../../../src/core/simulation/trust.ts';
import { systems } from '../../../src/core/systems/all.ts';
import { runOf, scenarioOf, seeded, type FinishedRun } from '../../helpers.ts';

/** Both runs of a scenario, and what they agree in. */
function trustOf(raw: object): { first: FinishedRun; trust: Trust } {
  const scenario = scenarioOf(raw);
  const second = secondScenario(scenario);
  const [a, b] = [runOf(raw), runOf({ ...raw, method: second.method })];
  const meter = new DigitsMeter(systems[scenario.system]!.meta, second.method);
  meter.take('first', [...a.columns.values()], a.rows);
  meter.take('second', [...b.columns.values()], b.rows);
  return { first: a, trust: meter.finish(a.end, b.end) };
}

const random = seeded(1517);
const between = (low: number, high: number): number => low + (high - low) * random();

/** Scenarios whose solution is known, as the exact value of some coordinates at t. */
const KNOWN: { name: string; raw: object; exact: (t: number) => Record<string, number> }[] = [
  {
    name: 'decay',
    raw: { version: 1, system: 'stiff-decay', duration: 1.5, outputStep: 0.01 },
    exact: (t) => ({ y: Math.exp(-15 * t) }),
  },
  ...[0, 1, 2].map(() => {
    const [turn, roll] = [between(-2, 2), between(-9, 9)];
    const speed = roll * scenarioOf({ version: 1, system: 'rolling-wheel' }).parameters['rho']!;
    return {
      name: `wheel turning at ${turn}, rolling at ${roll} rad/s`,
      raw: { version: 1, system: 'rolling-wheel', initial: { theta_dot: turn, phi_dot: roll }, duration: 6 },
      exact: (t: number) => ({
        X: (speed / turn) * Math.sin(turn * t),
        Y: (speed / turn) * (1 - Math.cos(turn * t)),
        theta: turn * t,
        phi: roll * t,
      }),
    };
  }),
];

/** As the digits are defined, against the solution. */
function trueDigits({ columns, rows }: FinishedRun, exact: (t: number) => Record<string, number>, floor: number) {
  const size = new Map<string, number>();
  return Array.from({ length: rows }, (_, row) => {
    const differences = Object.entries(exact(columns.get('t')![row]!)).map(([name, value]) => {
      const least = name === 'X' || name === 'Y' ? floor : 1;
      size.set(name, Math.max(size.get(name) ?? least, Math.abs(value)));
      return Math.abs(columns.get(name)![row]! - value) / size.get(name)!;
    });
    return -Math.log10(Math.max(...differences));
  });
}

for (const { name, raw, exact } of KNOWN) {
  for (const method of methods) {
    test(`no digit is claimed that is not right: ${name}, ${method.id}`, () => {
      for (const exponent of method.adaptive ? [-3, -6, -8, -10, -12] : [NaN]) {
        const options = method.adaptive
          ? { name: method.id, rtol: 10 ** exponent, atol: 10 ** (exponent - 2) }
          : { name: method.id, step: 0.004 };
        const { first, trust } = trustOf({ ...raw, method: options });
        const right = trueDigits(first, exact, 0.1);
        expect(trust.digits.length).toBe(first.rows);
        trust.digits.forEach(([t, claimed], row) =>
          // Beyond what doubles hold after some thousand operations, rounding of the known solution itself is seen.
          expect(Math.min(claimed, 13), `t = ${t}, 1e${exponent}`).toBeLessThan(right[row]! + 0.5),
        );
      }
    }, 60_000);
  }
}

test('no digit is claimed that is not right: cart and pendulum, beside a run near to rounding', () => {
  for (let n = 0; n < 4; n++) {
    const raw = {
      version: 1,
      system: 'cart-pendulum',
      initial: { theta: between(-3, 3), theta_dot: between(-2, 2) },
      duration: 6,
      outputStep: 0.05,
    };
    const best = runOf({ ...raw, method: { name: 'gauss', stages: 4, rtol: 1e-14, atol: 1e-15 } });
    for (const { id, adaptive } of methods) {
      const method = adaptive ? { name: id, rtol: 1e-6, atol: 1e-8 } : { name: id, step: 0.002 };
      const { first, trust } = trustOf({ ...raw, method });
      for (const [row, [t, claimed]] of trust.digits.entries()) {
        const difference = Math.max(
          ...['X', 'theta'].map((name) => {
            const values = best.columns.get(name)!.slice(0, row + 1);
            const size = Math.max(name === 'X' ? 0.1 : 1, ...values.map(Math.abs));
            return Math.abs(first.columns.get(name)![row]! - values[row]!) / size;
          }),
        );
        expect(Math.min(claimed, 12), `${id}, ${JSON.stringify(raw.initial)}, t = ${t}`).toBeLessThan(
          0.5 - Math.log10(difference),
        );
      }
    }
  }
}, 120_000);

test('the falling board of the report fades between 1.5 and 4 s', () => {
  const { trust } = trustOf({
    version: 1,
    system: 'ripstik',
    parameterSet: 'authors',
    constraints: 'report',
    initial: { alpha: '10 deg' },
    duration: 5.8,
    events: { touchdown: 'ignore' },
  });
  const { until, compared } = trust;
  expect(until[4]).toBeGreaterThan(1.5);
  expect(until[2]).toBeGreaterThan(until[4]);
  expect(until[1]).toBeGreaterThan(until[2]);
  expect(until[1]).toBeLessThan(4);
  expect(compared).toBe(5.8);
  expect(trustSentence(trust)).toMatch(
    /^right to 4 digits until t = 1\.\d+ s, .*; compared to t = 5\.8 s with dop853 at rtol 1e-13$/,
  );
});

test('a fixed step that tumbles past pitch 90° is told', () => {
  const { trust } = trustOf({
    version: 1,
    system: 'ripstik',
    constraints: 'none',
    initial: { Z: 1, theta: '80 deg', theta_dot: 9, alpha_dot: 5, psi_dot: 4 },
    method: { name: 'rk4', step: 0.02 },
    duration: 3,
  });
  expect(trust.until[4]).toBeLessThan(3);
});

test('the same touchdown is compared to the end, and no further', () => {
  const { first, trust } = trustOf({ version: 1, system: 'ripstik', initial: { alpha: '10 deg' }, duration: 5 });
  expect(first.end.reason).toBe('touchdown');
  expect(trust.compared).toBe(first.end.time);
  expect(trust.until[4]).toBe(first.end.time);
  expect(trust.digits.at(-1)![1]).toBeGreaterThan(6);
});

test('what one run has no row for is not claimed', () => {
  const meter = new DigitsMeter(
    systems['rolling-wheel']!.meta,
    secondScenario(scenarioOf({ version: 1, system: 'rolling-wheel' })).method,
  );
  const rows = (times: number[], error: number): Float64Array[] => [
    Float64Array.from(times),
    ...Array.from({ length: 8 }, () => Float64Array.from(times, (t) => t + error * t)),
  ];
  meter.take('first', rows([0, 1, 2, 3], 0), 4);
  meter.take('second', rows([0, 1], 1e-5), 2);
  meter.take('second', rows([1.5], 1e-5), 1);
  const trust = meter.finish({ reason: 'end' }, { reason: 'newton' });
  expect(meter.over).toBe(true);
  expect(trust.compared).toBe(1);
  expect(trust.until).toEqual({ 4: 1, 2: 1, 1: 1 });
  expect(trust.digits[0]).toEqual([0, 15]);
  expect(trust.digits[1]![1]).toBeCloseTo(5, 1);
});

test('numbers that are none hold no digit', () => {
  const meter = new DigitsMeter(
    systems['stiff-decay']!.meta,
    secondScenario(scenarioOf({ version: 1, system: 'stiff-decay' })).method,
  );
  meter.take(
    'first',
    [0, 1, 1].map((x) => Float64Array.of(x)),
    1,
  );
  meter.take(
    'second',
    [0, NaN, 1].map((x) => Float64Array.of(x)),
    1,
  );
  expect(meter.trust.digits).toEqual([[0, 0]]);
});

test('the second method is another one, with tolerances a hundredfold tighter', () => {
  for (const { id } of methods) {
    for (const rtol of [1e-3, 1e-8, 1e-12]) {
      const scenario = scenarioOf({ version: 1, system: 'cart-pendulum', method: { name: id, rtol, atol: rtol } });
      const { method } = secondScenario(scenario);
      expect(method.name).not.toBe(id);
      expect(method.rtol).toBeLessThanOrEqual(rtol / 100);
      expect(method.atol).toBeLessThanOrEqual(rtol / 100);
    }
  }
});
