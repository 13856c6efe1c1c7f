import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { compileExpression, evaluateNumber, ExpressionError } from '../../../src/core/scenario/expressions.ts';

const of = (text: string) => compileExpression(text, { variables: ['t'] });
function refusal(text: string | number, variables: readonly string[] = ['t']): ExpressionError {
  try {
    compileExpression(text, { variables });
  } catch (error) {
    if (error instanceof ExpressionError) return error;
    throw error;
  }
  throw new Error(`"${text}" was accepted`);
}

describe('values', () => {
  it.each([
    ['45 deg', Math.PI / 4],
    ['45°', Math.PI / 4],
    ['−10 °', -Math.PI / 18],
    ['2π', 2 * Math.PI],
    ['2×3·4', 24],
    ['1/2 pi', Math.PI / 2],
    ['-2^2', -4],
    ['2^-1', 0.5],
    ['2^3^2', 512],
    ['2**3', 8],
    ['1e-3', 1e-3],
    ['.5', 0.5],
    ['1 > 0 ? 7 : 8', 7],
    ['max(1, 3, 2)', 3],
    ['hypot(3, 4)', 5],
    ['atan2(1, -1)', (3 * Math.PI) / 4],
    ['mod(-1, 3)', 2],
    ['tau', 2 * Math.PI],
    ['1 rad', 1],
    ['(0 < 1 < 2) + (3 == 3)', 2],
    ['1/2 deg', Math.PI / 360],
    ['1/2°', Math.PI / 360],
    ['-3/4 pi', -0.75 * Math.PI],
    ['1/2 (1+2)', 1.5],
    ['2 pi/4', Math.PI / 2],
    ['1/(2 pi)', 0.5 / Math.PI],
    ['20 deg * sin(pi/2)', Math.PI / 9],
    ['10²³', 1e23],
    ['10⁻³', 1e-3],
    ['2 pi²', 2 * Math.PI ** 2],
    ['(1+2)² pi', 9 * Math.PI],
    ['2^(1/2) pi', Math.PI * Math.SQRT2],
    ['2^3 deg', (8 * Math.PI) / 180],
  ])('%s', (text, value) => expect(evaluateNumber(text) / value).toBeCloseTo(1, 14));

  it.each([
    ['pi/2 deg', '(pi/2) deg or pi/(2 deg)'],
    ['pi/2°', '(pi/2) ° or pi/(2 °)'],
    ['2 pi/4 pi', '(2 pi/4) pi or 2 pi/(4 pi)'],
    ['1/2pi', '(1/2) pi or 1/(2 pi)'],
    ['6/2(1+2)', '(6/2) (1+2) or 6/(2 (1+2))'],
    ['1 + sin(t)/2 cos(t)', '(sin(t)/2) cos(t) or sin(t)/(2 cos(t))'],
    ['max(1, t/2 pi)', '(t/2) pi or t/(2 pi)'],
    ['t > 1 ? 1/t pi : 0', '(1/t) pi or 1/(t pi)'],
    ['3/4/5 deg', '(3/4/5) deg or 3/4/(5 deg)'],
    ['e^-2t', '(e^-2) t or e^(-2 t)'],
    ['sin(t)^2t', '(sin(t)^2) t or sin(t)^(2 t)'],
    ['10°²', '(10 deg)^'],
    ['2³^2', '(x³)^y or x^(3^y)'],
    ['sin²(t)', 'sin(…)²'],
    ['²', 'nothing before it'],
    ['2 + ²', 'nothing before it'],
  ])('%s is refused with both readings', (text, readings) => expect(refusal(text).message).toContain(readings));

  it('a product without a sign is one with a sign, or refused', () => {
    const factor = fc.constantFrom('2', '.5', 't', 'pi', '(t+1)', 'sin(t)', 'deg', 't^2', '(-3)', 'e^(-1)');
    const join = fc.constantFrom(' ', '', '*', ' * ', '/', ' / ', '+', ' - ');
    fc.assert(
      fc.property(fc.array(fc.tuple(factor, join), { minLength: 1, maxLength: 6 }), factor, (parts, last) => {
        const text = parts.map(([f, j]) => f + j).join('') + last;
        let value: number;
        try {
          value = of(text).evaluate(0.7);
        } catch (error) {
          return void expect(error).toBeInstanceOf(ExpressionError);
        }
        // The same text with every product signed, in the language of the test itself.
        const tokens = text.match(/[\d.]+|[a-z]+|\^-?|[()+\-*/]/g)!;
        let signed = '';
        tokens.forEach((token, i) => {
          const before = tokens[i - 1] ?? '';
          const operand = /^[\d.a-z(]/.test(token);
          if (operand && /[\w.)]$/.test(before) && before !== 'sin') signed += '*';
          signed += token.replace('^', '**');
        });
        const run = new Function('t', 'pi', 'e', 'deg', 'sin', `return ${signed}`) as (...x: unknown[]) => number;
        const expected = run(0.7, Math.PI, Math.E, Math.PI / 180, Math.sin);
        expect(Math.abs(value - expected)).toBeLessThanOrEqual(1e-12 * Math.max(1, Math.abs(expected)));
      }),
      { numRuns: 2000 },
    );
  });

  it('the disturbance and the gait of the specification', () => {
    const push = of('22*exp(-10*(t-8)^2) - 22*exp(-10*(t-12)^2)');
    expect(push.evaluate(8)).toBeCloseTo(22, 12);
    expect(push.evaluate(12)).toBeCloseTo(-22, 12);
    expect(of('20 deg * sin(2*pi*1.5*t)').evaluate(1 / 6)).toBeCloseTo(Math.PI / 9, 14);
    expect(of('20 deg * sin(2*pi*1.5*t)').derivative(0)).toBeCloseTo((Math.PI / 9) * 3 * Math.PI, 12);
  });

  it('knows what is constant', () => {
    expect(of('2 pi').constant).toBe(true);
    expect(of('0 * t').constant).toBe(false);
    expect(compileExpression(3, { variables: [] })).toMatchObject({ constant: true });
  });
});

/** Smooth formulas of t whose values stay moderate. */
const formula = fc.letrec<{ node: string }>((tie) => ({
  node: fc.oneof(
    { maxDepth: 5, withCrossShrink: true },
    fc.constant('t'),
    fc.integer({ min: 1, max: 9 }).map((n) => `${n / 4}`),
    fc
      .tuple(
        fc.constantFrom(
          'sin',
          'cos',
          'tanh',
          'atan',
          'sinh(tanh',
          'exp(-cosh(tanh',
          'log(2+cos',
          'sqrt(2+sin',
          'cbrt(3+sin',
          'asin(0.5*sin',
          'log2(3+sin',
          '1/(2+cos',
        ),
        tie('node'),
      )
      .map(([f, a]) => `${f}(${a})${')'.repeat((f.match(/\(/g) ?? []).length)}`),
    fc.tuple(tie('node'), fc.constantFrom(' + ', ' - ', '*'), tie('node')).map(([a, op, b]) => `(${a}${op}${b})`),
    fc.tuple(tie('node'), fc.constantFrom('2', '3')).map(([a, n]) => `(sin(${a}))^${n}`),
    fc.tuple(tie('node'), tie('node')).map(([a, b]) => `(2+sin(${a}))^tanh(${b})`),
    fc.tuple(tie('node'), tie('node')).map(([a, b]) => `atan2(2+cos(${a}), sin(${b}))`),
    fc.tuple(tie('node'), tie('node')).map(([a, b]) => `hypot(1, ${a}, ${b})`),
    fc.tuple(tie('node'), tie('node')).map(([a, b]) => `(t > 10 ? ${a} : ${b})`),
  ),
})).node;

describe('derivatives', () => {
  it('agree with central differences', () => {
    fc.assert(
      fc.property(
        formula.filter((text) => text.length < 400),
        fc.double({ min: -1, max: 1, noNaN: true }),
        (text, t) => {
          const f = of(text);
          const at = (h: number) => (f.evaluate(t + h) - f.evaluate(t - h)) / (2 * h);
          // Richardson's step leaves an error of order h^4; where even its own two steps disagree nothing can be said.
          const [coarse, fine] = [at(2e-3), at(1e-3)];
          const difference = (4 * fine - coarse) / 3;
          fc.pre(Number.isFinite(difference) && Math.abs(coarse - fine) < 1e-3 * (1 + Math.abs(fine)));
          const scale = 1 + Math.abs(difference) + Math.abs(f.evaluate(t));
          expect(Math.abs(f.derivative(t) - difference) / scale).toBeLessThan(1e-4);
        },
      ),
      { numRuns: 500 },
    );
  });

  it.each([
    ['t^3', 2, 12],
    ['t^t', 1, 1],
    ['2^t', 0, Math.LN2],
    ['sqrt(0*t)', 0, 0],
    ['abs(t)', -2, -1],
    ['floor(t)', 0.5, 0],
    ['mod(t, 2)', 5.5, 1],
    ['max(t, 2*t)', 1, 2],
    ['min(t, 2*t)', 1, 1],
    ['log10(t)', 1, 1 / Math.LN10],
    ['acos(t)', 0, -1],
    ['tan(t)', 0, 1],
    ['t^0', 0, 0],
    ['t^2', 0, 0],
    ['-(+t)', 1, -1],
    ['t > 1', 1, 0],
    ['sign(t)', 1, 0],
  ])('of %s at %f', (text, t, slope) => expect(of(text).derivative(t)).toBeCloseTo(slope, 12));

  it.each([
    ['sin(t)/t', 0, 0],
    ['(1-cos(t))/t', 0, 0.5],
    ['sin(pi*(t-2))/(pi*(t-2))', 2, 0],
    ['t^2*log(t)', 0, 0],
    ['hypot(t, 0)', 0, 1],
    ['10 deg/(1+exp(100*(t-1)))', 8.2, 0],
    ['10 deg/(1+exp(100*(t-1)))', 1e300, 0],
    ['1e200*atan(1e200*t)', 1, 1],
    ['exp(1000*t)/exp(999*t)', 1, Math.E],
    ['1/(1+exp(exp(exp(t))))', 1e5, 0],
  ])('of %s at %f, its limit', (text, t, slope) => expect(of(text).derivative(t)).toBeCloseTo(slope, 9));

  // u is 0 at `at`; u = factor (t - at) is exact beside it, where cos(u) and (1 + u)^(1/u) have steps of rounding.
  const LIMITS: readonly (readonly [text: string, value: number, rate: number])[] = [
    ['sin(u)/u', 1, 0],
    ['(exp(u)-1)/u', 1, 1 / 2],
    ['(1-cos(u))/u^2', 1 / 2, 0],
    ['(u-sin(u))/u^3', 1 / 6, 0],
    ['(cosh(u)-1)/(u*sin(u))', 1 / 2, 0],
    ['log(cosh(u))/u^2', 1 / 2, 0],
    ['log(1+u)/u', 1, -1 / 2],
    ['(sqrt(1+u)-1)/u', 1 / 2, -1 / 8],
    ['(2^u-1)/u', Math.LN2, Math.LN2 ** 2 / 2],
    ['(1+u)^(1/u)', Math.E, -Math.E / 2],
    ['atan2(u,1+u)/u', 1, -1],
    ['asin(u)/u+acos(u)', 1 + Math.PI / 2, -1],
    ['tan(u)/sinh(u)', 1, 0],
    ['u*atan(1/u^2)', 0, Math.PI / 2],
    ['u^3/u^2', 0, 1],
    ['cbrt(u^3)', 0, 1],
    ['sqrt(u^4)/u', 0, 1],
    ['u*hypot(1,u)/abs(u)*sign(u)', 1, 0],
    ['exp(-1/u^2)/u', 0, 0],
    ['tanh(1/u)*u/abs(u)', 1, 0],
    ['max(u,sin(u))*min(0,1-u)/u^2', 0, 0],
    ['mod(u,3)*(1-cos(u))/u^2', 0, 1 / 2],
    ['(1+floor(u)+ceil(-u))*u/tanh(u)', 1, 0],
  ];
  it.each(LIMITS)('%s has its limits %d and %d for u towards 0', (text, value, rate) => {
    for (const [at, factor] of [
      [0, 1],
      [0.5, 0.3],
      [2, 5],
      [-3, 0.25],
    ] as const) {
      const f = of(text.replaceAll(/\bu\b/g, `(${factor}*(t-${at}))`));
      expect(f.evaluate(at), `at ${at}`).toBeCloseTo(value, 12);
      expect(f.derivative(at), `at ${at}`).toBeCloseTo(factor * rate, 11);
    }
  });

  it('what grows without bound beside a point has no limit there', () => {
    for (const text of ['ceil(log10(t))', 'sin(1/t)', '1/t-1/t^2', 'exp(1/t)/exp(2/t^2)+1/t'])
      expect(of(text).evaluate(0), text).toBeNaN();
  });

  it.each([
    ['log(cosh(t^4))', 1e5, 4e15],
    ['log10(cosh(7+2*t))', -8e148, -2 / Math.LN10],
    ['log(exp(t)^13.4)', 1e26, 13.4],
    ['ln(atan(0.9^(t*t)))', -1e5, -2e5 * Math.log(0.9)],
    ['log(atan2(9e-100*t, t^t))', 1e50, 1e-50 - (Math.log(1e50) + 1)],
    ['sqrt(log(exp(t^2)+exp(t)))', 1e6, 1],
  ])('the rate of %s at %f loses nothing to how large its parts are', (text, t, slope) =>
    expect(of(text).derivative(t) / slope).toBeCloseTo(1, 12),
  );
});

describe('texts of strangers', () => {
  const HOSTILE = [
    'constructor',
    '__proto__',
    'a.b',
    't.constructor',
    'sin.constructor("return 1")()',
    'f(x)=x',
    'f(t)=t',
    't=1',
    'import("x")',
    'import(1)',
    'evaluate(1)',
    'parse(1)',
    'createUnit(1)',
    '[1,2]',
    '[1,2][1]',
    '{a:1}',
    '"x"',
    "'x'",
    '`x`',
    '1:3',
    '1;2',
    '1\n2',
    'toString()',
    'hasOwnProperty(1)',
    'this',
    'window',
    'process',
    'globalThis',
    't!',
    "t'",
    't#1',
    '5%',
    'true',
    'null',
    'undefined',
    'NaN',
    'Infinity',
    'i',
    'end',
    '1 to 2',
    '1 and 2',
    'not 1',
    '0x',
    '\\',
    '$',
    '@',
    '😀',
    '\u0000',
    'valueOf',
    '10^10^10',
    '1/0',
    '0/0',
    't + 1/0',
    '1e999',
    'sqrt(-1)',
    '',
    '   ',
    '()',
    '(',
    ')',
    ')(',
    '1 +',
    'sin',
    'sin()',
    'sin(1, 2)',
    'sin 3',
    '1 2',
    '0,5',
    't(3)',
    'pow(1)',
    'factorial(5)',
    'random()',
    'map(1)',
    'sin(constructor)',
    'max()',
  ];
  it.each(HOSTILE)('%j is refused', (text) => {
    const error = refusal(text);
    expect(error.message.length).toBeGreaterThan(5);
    if (error.position !== null) expect(error.position).toBeLessThanOrEqual(text.length);
  });

  it.each([NaN, Infinity, -Infinity])('%f is refused', (x) => expect(refusal(x).message).toMatch(/finite/));

  it.each([
    ['foo + 1', 0, 'unknown name "foo"; known: t, pi'],
    ['1 + foo', 4, 'unknown name "foo"'],
    ['45° + foo', 6, '(at character 7)'],
    ['2*sen(t)', 2, 'unknown function "sen"'],
    ['(1 + 2', 6, '")" is missing'],
    ['1 + * 2', 4, 'Value expected'],
    ['0,5', 1, 'decimals are written with a point'],
    ['2 cos', 2, 'write cos(…)'],
    ['t(3)', 0, 'write t * (…)'],
    ['1 + a.b', 4, 'unknown name "a"'],
    ['5%', 1, 'mod(a, b)'],
    ['1 + sin(1, 2)', 4, 'sin takes 1 argument, not 2'],
  ])('%j is refused at character %i', (text, position, message) => {
    expect(refusal(text)).toMatchObject({ position, message: expect.stringContaining(message) });
  });

  it('t has no place in a constant', () => {
    expect(refusal('2*t', [])).toMatchObject({ position: 2, message: expect.stringContaining('constant') });
    expect(() => evaluateNumber('t')).toThrow(ExpressionError);
  });

  it('long, large and deep ones are refused before they cost anything', () => {
    expect(refusal('1'.repeat(1001)).message).toMatch(/1001 characters/);
    expect(refusal('1+'.repeat(400) + '1').message).toMatch(/more than 200 parts/);
    for (const deep of [
      '('.repeat(400) + 't' + ')'.repeat(400),
      '-'.repeat(900) + 't',
      `${'t^'.repeat(400)}t`,
      '1?'.repeat(150) + 't' + ':1'.repeat(150),
      'sin('.repeat(150) + 't' + ')'.repeat(150),
    ]) {
      expect(refusal(deep).message).toMatch(/nested deeper|more than 200 parts/);
    }
  });

  it('nested functions cost their length, not two to its power', () => {
    for (const [open, close] of [
      ['max(0,', ')'],
      ['mod(', ',9)'],
      ['hypot(1,', ')'],
      ['atan2(', ',2)'],
    ]) {
      const f = of(`${open!.repeat(55)}t${close!.repeat(55)}`);
      expect(f.evaluate(1)).not.toBeNaN();
      expect(f.derivative(1)).not.toBeNaN();
    }
  });

  it('anything else is a number or an ExpressionError', () => {
    const piece = fc.oneof(
      fc.constantFrom(
        't',
        'pi',
        'sin',
        '(',
        ')',
        '+',
        '-',
        '*',
        '/',
        '^',
        '<',
        '==',
        '?',
        ':',
        ',',
        ' ',
        '1',
        '2.5',
        'deg',
        '°',
        'mod',
        '[',
        '.',
        '"',
        '=',
        'x',
        '!',
      ),
      fc.string({ maxLength: 3 }),
    );
    fc.assert(
      fc.property(fc.array(piece, { maxLength: 30 }), (pieces) => {
        try {
          expect(typeof of(pieces.join('')).evaluate(0.5)).toBe('number');
        } catch (error) {
          if (!(error instanceof ExpressionError)) throw error;
        }
      }),
      { numRuns: 1000 },
    );
  });
});
