// Links: every scenario comes back as it was, and nothing a stranger writes gets further than a named refusal.
import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { cases, systemViews } from '../../../src/core/systems/registry.ts';
import { checkScenario, collectScenarioErrors } from '../../../src/core/scenario/schema.ts';
import type { ScenarioFile } from '../../../src/core/scenario/types.ts';
import { decodeLink, encodeLink, LinkError, LONGEST_LINK } from '../../../src/core/scenario/link.ts';
import { difference, patched } from '../../../src/core/scenario/patch.ts';

const systems = Object.fromEntries(Object.entries(systemViews).map(([id, { meta }]) => [id, meta]));
const known = { systems, cases };
const SEED = { seed: 20261123 };

const number = fc.oneof(fc.double({ noNaN: true, noDefaultInfinity: true }), fc.constantFrom(0, -0, 5e-324, 1e21, 0.1));
const expression = fc.constantFrom(
  '12 deg',
  'pi/8',
  '0.3 rad',
  '0.1',
  '-2',
  '1e-3',
  'atan(1/2)',
  '2 * (3 + 4)',
  'sqrt(2)',
);
const value = fc.oneof(number, expression);

/** A case with values named anew, taken out and put in another order. */
const edited = fc
  .constantFrom(...cases)
  .chain((c) => {
    const meta = systems[c.scenario.system]!;
    const names = [
      ...meta.coordinates.map((q) => q.name),
      ...(meta.order === 1 ? [] : meta.coordinates.map((q) => `${q.name}_dot`)),
    ];
    const some = (list: readonly string[]) =>
      fc.option(fc.dictionary(fc.constantFrom(...list), value, { maxKeys: 6, noNullPrototype: true }), {
        nil: undefined,
      });
    return fc
      .record({
        initial: some(names),
        keep: fc.boolean(),
        parameters: fc.option(
          fc.dictionary(
            fc.constantFrom(...meta.parameters.map((p) => p.name)),
            fc.double({ min: 0.01, max: 2, noNaN: true }),
            { maxKeys: 5, noNullPrototype: true },
          ),
          { nil: undefined },
        ),
        hold: fc.option(fc.uniqueArray(fc.constantFrom(...meta.coordinates.map((q) => q.name)), { maxLength: 4 }), {
          nil: undefined,
        }),
        duration: fc.option(fc.double({ min: 0.1, max: 20, noNaN: true }), { nil: undefined }),
        method: fc.option(
          fc.record(
            { name: fc.constantFrom('rk4', 'radau', 'bdf'), projection: fc.boolean() },
            { requiredKeys: [], noNullPrototype: true },
          ),
          { nil: undefined },
        ),
        columns: fc.option(fc.subarray(['lambda', 'energy', 'residual']), { nil: undefined }),
      })
      .map(({ initial, keep, ...rest }) => {
        const before = c.scenario.initial ?? {};
        const scenario: Record<string, unknown> = {
          ...c.scenario,
          ...(initial ? { initial: keep ? { ...before, ...initial } : { ...initial, ...before } } : {}),
        };
        for (const [key, entry] of Object.entries(rest)) {
          if (entry === undefined) delete scenario[key];
          else scenario[key] = entry;
        }
        return { caseId: c.id as string | null, scenario: scenario as unknown as ScenarioFile };
      });
  })
  .filter(({ scenario }) => collectScenarioErrors(scenario, systems).size === 0);

describe('what is encoded comes back', () => {
  test.each(cases.map((c) => [c.id, c] as const))('%s by its name', (_, c) => {
    const text = encodeLink({ caseId: c.id, scenario: c.scenario }, known);
    expect(text).toMatch(/^v=1&case=[\w-]+&sum=\w+$/);
    expect(decodeLink(`#${text}`, known)).toEqual({ caseId: c.id, scenario: c.scenario, altered: false });
  });

  test.each(cases.map((c) => [c.id, c] as const))('%s in full', (_, c) => {
    const text = encodeLink({ caseId: null, title: c.title, scenario: c.scenario }, known);
    // The longest names every figure of nine sensors.
    expect(text.length).toBeLessThan(LONGEST_LINK / 5);
    expect(decodeLink(text, known)).toEqual({ caseId: null, title: c.title, scenario: c.scenario, altered: false });
  });

  test('any case with any edits, its numbers and the order of its names to the last', () => {
    fc.assert(
      fc.property(edited, ({ caseId, scenario }) => {
        const opened = decodeLink(encodeLink({ caseId, scenario }, known), known);
        expect(opened).toStrictEqual({ caseId, scenario, altered: false });
        const run = (file: ScenarioFile) =>
          JSON.stringify(checkScenario(file, systems), (_, v: unknown) => (Object.is(v, -0) ? '-0' : v));
        expect(run(opened.scenario)).toBe(run(scenario));
      }),
      { ...SEED, numRuns: 400 },
    );
  });

  test('any plain objects at all', () => {
    const name = fc.string({ minLength: 1, maxLength: 6, unit: 'grapheme' }).filter((s) => s !== '__proto__');
    const leaf = fc.oneof(
      value,
      fc.boolean(),
      fc.constant(null),
      fc.string({ unit: 'binary' }),
      fc.constantFrom('', '""', '{}', '[1', 'null', '\ud800'),
      fc.array(fc.oneof(value, fc.string()), { maxLength: 3 }),
    );
    const record = fc.letrec<{ tree: Record<string, unknown> }>((tie) => ({
      tree: fc.dictionary(name, fc.oneof({ depthSize: 'small', maxDepth: 4 }, leaf, tie('tree')), {
        maxKeys: 4,
        noNullPrototype: true,
      }),
    })).tree;
    fc.assert(
      fc.property(record, record, (from, to) => {
        const made = patched(from, difference(from, to));
        expect(made).toStrictEqual(to);
      }),
      { ...SEED, numRuns: 1000 },
    );
  });

  test('tool, view, time and plots', () => {
    const content = {
      caseId: 'ridden',
      scenario: cases[0]!.scenario,
      tool: 'plots',
      view: 'caster',
      time: 2.345,
      plots: { panes: [{ x: 't', y: ['alpha'] }] },
    };
    expect(decodeLink(encodeLink(content, known), known)).toEqual({ ...content, altered: false });
  });
});

describe('what mail and chat programs do to links is undone', () => {
  const damages: [string, (text: string) => string][] = [
    ['written as HTML', (text) => text.replaceAll('&', '&amp;')],
    ['written as HTML twice', (text) => text.replaceAll('&', '&amp;amp;')],
    ['a sign by its number', (text) => text.replaceAll('&', '&#38;')],
    ['equals signs as codes', (text) => text.replaceAll('=', '%3D')],
    ['the first equals sign as a code', (text) => text.replace('=', '%3d')],
    ['all of it as codes', (text) => encodeURIComponent(text)],
    ['all of it as codes, with its beginning', (text) => encodeURIComponent(`#${text}`)],
    ['two beginnings', (text) => `#%23${text}`],
    ...['.', ',', ')', '>', '&gt;', '%20', '%22', '"', '’', '…', '%3E'].map(
      (end): [string, (text: string) => string] => [`${end} behind it`, (text) => text + end],
    ),
  ];
  test.each(damages)('%s', (_, damage) => {
    fc.assert(
      fc.property(edited, ({ caseId, scenario }) => {
        const content = { caseId, title: 'A & B = 100 % #1', scenario };
        const text = encodeLink(content, known);
        expect(decodeLink(damage(text), known)).toEqual(decodeLink(text, known));
      }),
      { ...SEED, numRuns: 20 },
    );
    const own = { caseId: null, title: 'A & B = 100 % #1', scenario: cases[0]!.scenario };
    expect(decodeLink(damage(encodeLink(own, known)), known)).toEqual({ ...own, altered: false });
  });
});

describe('what is refused, by name and place', () => {
  const good = encodeLink(
    { caseId: 'released', scenario: { ...cases.find((c) => c.id === 'released')!.scenario, duration: 3 } },
    known,
  );
  const refusal = (text: string): string => {
    try {
      decodeLink(text, known);
    } catch (error) {
      expect(error).toBeInstanceOf(LinkError);
      return (error as Error).message;
    }
    return 'opened';
  };

  test.each([
    ['nothing', '', /no link of this page/],
    ['another version', good.replace('v=1', 'v=2'), /version "2"/],
    ['an unknown case', good.replace('released', 'nowhere'), /case: no case is called "nowhere"/],
    ['the end cut off', good.slice(0, -11), /cut on its way|no entry/],
    ['a broken code', good.replace('duration=3', 'duration=%E0%A4%A'), /duration: holds a broken % code/],
    ['a wrong type', good.replace('duration=3', 'duration=soon'), /duration: must be a number, not the text "soon"/],
    ['not a number', good.replace('duration=3', 'duration=1e999'), /duration/],
    ['an unknown name', `${good}&initial.alhpa=1`, /initial\.alhpa: .*did you mean "alpha"/],
    ['the prototype', `${good}&__proto__.polluted=1`, /no name of a scenario/],
    ['the prototype by another way', `${good}&initial.__proto__.polluted=1`, /no name of a scenario/],
    ['the prototype in disguise', `${good}&initial.%5F%5Fproto%5F%5F.polluted=1`, /no name of a scenario/],
    ['the constructor', `${good}&constructor.prototype.polluted=1`, /constructor: unknown name/],
    ['a tower', `${good}&${'a.'.repeat(3000)}a=1`, /nested more than/],
    ['a tower of brackets', `${good}&hold=${'%5B'.repeat(5000)}`, /hold|characters/],
    ['a tower of JSON', `${good}&hold=${'['.repeat(2000)}${']'.repeat(2000)}`, /nested value/],
    ['a tower of plots', `${good}&plots=${'['.repeat(2000)}${']'.repeat(2000)}`, /plots: is nested/],
    ['a trap in plots', `${good}&plots={"__proto__":{"polluted":1}}`, /plots: holds a name/],
    ['a novel', `${good}&title=${'x'.repeat(LONGEST_LINK)}`, /characters are more than/],
    ['a crowd', good + '&a=1'.repeat(600), /entries are more than/],
    ['twice', `${good}&duration=4`, /duration: stands twice/],
    ['a part of a number', `${good}&duration.x=4`, /has no entries of its own/],
    ['markup as a tool', `${good}&tool=%3Cimg%3E`, /tool: .* is no name/],
    ['a time before the start', `${good}&time=-1`, /time: must be seconds/],
    ['an expression without end', good.replace('duration=3', `initial.alpha=${'('.repeat(4000)}`), /initial\.alpha/],
  ])('%s', (_, text, message) => {
    expect(refusal(text)).toMatch(message);
    expect(({} as Record<string, unknown>)['polluted']).toBeUndefined();
  });

  test('a value changed by hand opens, and says so', () => {
    expect(decodeLink(good.replace('duration=3', 'duration=4'), known)).toMatchObject({
      altered: true,
      scenario: { duration: 4 },
    });
  });

  test('cut anywhere, it says that its end is missing; cut in its check alone, it opens', () => {
    const check = good.lastIndexOf('=') + 1;
    for (let at = 4; at < check; at++)
      expect(refusal(good.slice(0, at)), good.slice(0, at)).toMatch(/the end is missing; the link was cut/);
    for (let at = check + 1; at < good.length; at++)
      expect(decodeLink(good.slice(0, at), known)).toMatchObject({ scenario: { duration: 3 } });
  });

  test('too much for a link is refused when it is made', () => {
    const scenario = { ...cases[0]!.scenario, inputs: { tau_fp: `0${'+0'.repeat(LONGEST_LINK)}` } };
    expect(() => encodeLink({ caseId: 'ridden', scenario }, known)).toThrow(LinkError);
  });

  test('mutations of good links: opened or refused, never anything else, and prototypes stay as they are', () => {
    const alphabet = fc.constantFrom(
      '&',
      '=',
      '.',
      '%',
      '+',
      '__proto__',
      'constructor',
      '{}',
      '[',
      '%00',
      '%ud800',
      '\u0000',
      'NaN',
      '1e999',
      '"',
      '&case=',
      '&initial.',
      '-',
      '9',
    );
    const mutation = fc.tuple(
      fc.nat({ max: 400 }),
      fc.nat({ max: 12 }),
      fc.oneof(alphabet, fc.string({ unit: 'binary', maxLength: 4 })),
    );
    const plain = JSON.stringify([
      Object.getOwnPropertyNames(Object.prototype),
      Object.getOwnPropertyNames(Array.prototype),
    ]);
    fc.assert(
      fc.property(edited, fc.array(mutation, { minLength: 1, maxLength: 4 }), ({ caseId, scenario }, mutations) => {
        const start = encodeLink({ caseId, scenario }, known);
        const text = mutations.reduce(
          (now, [at, cut, put]) => now.slice(0, at % now.length) + put + now.slice((at % now.length) + cut),
          start,
        );
        try {
          const { scenario: opened } = decodeLink(text, known);
          expect(collectScenarioErrors(opened, systems).size).toBe(0);
        } catch (error) {
          if (!(error instanceof LinkError)) throw error;
          expect(error.message.length).toBeGreaterThan(5);
        }
        expect(
          JSON.stringify([Object.getOwnPropertyNames(Object.prototype), Object.getOwnPropertyNames(Array.prototype)]),
        ).toBe(plain);
      }),
      { ...SEED, numRuns: 1500 },
    );
  });

  test('random bytes', () => {
    fc.assert(
      fc.property(fc.string({ unit: 'binary', maxLength: 200 }), (text) => {
        expect(refusal(text)).not.toBe('opened');
      }),
      { ...SEED, numRuns: 1000 },
    );
  });
});
