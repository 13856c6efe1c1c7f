import { readFileSync } from 'node:fs';
import fc from 'fast-check';
import { afterEach, describe, expect, test } from 'vitest';
import { cases } from '../../src/core/systems/registry.ts';
import { compileExpression, ExpressionError } from '../../src/core/scenario/expressions.ts';
import { parseScenario } from '../../src/core/scenario/schema.ts';
import { ScenarioError } from '../../src/core/scenario/types.ts';
import { CsvByteReader } from '../../src/csv/reading/byteReader.ts';
import { checkMaterials, checkMesh, MeshError } from '../../src/scene/actors/meshText.ts';
import { metas } from '../helpers.ts';
import { awkward, damaged } from './damage.ts';
import { runs, SEED, tally } from './tally.ts';

/** Files, links and formulas of strangers: taken, or refused with what and where; nothing else. */

const keysOf = (o: object): string[] => Reflect.ownKeys(o).map(String).sort();
const prototypes = [Object.prototype, Array.prototype, Function.prototype, String.prototype];
const clean = prototypes.map(keysOf);
afterEach(() => expect(prototypes.map(keysOf)).toEqual(clean));

describe('scenarios', () => {
  const count = tally('scenarios');
  const strange: fc.Arbitrary<unknown> = fc.oneof(
    fc.constantFrom(
      null,
      true,
      '',
      'x',
      0,
      -1,
      1e308,
      '__proto__',
      'constructor',
      '1/0',
      't',
      't^t^t',
      'deg',
      [],
      {},
      [[]],
      { toString: 1 },
    ),
    fc.string(),
    fc.double(),
    fc.object({ maxDepth: 2 }),
  );
  /** One value of the file in another's place, or a key of another name. */
  const misfit = fc
    .tuple(fc.constantFrom(...cases), fc.nat(), fc.oneof(strange, awkward), fc.boolean())
    .map(([{ scenario }, which, value, rename]) => {
      const copy = structuredClone(scenario) as unknown as Record<string, unknown>;
      const places: [Record<string, unknown>, string][] = [];
      const walk = (o: Record<string, unknown>): void => {
        for (const key of Object.keys(o)) {
          places.push([o, key]);
          if (typeof o[key] === 'object' && o[key] !== null) walk(o[key] as Record<string, unknown>);
        }
      };
      walk(copy);
      const [holder, key] = places[which % places.length]!;
      if (rename && !Array.isArray(holder)) {
        const text = JSON.stringify(copy);
        return text.replace(JSON.stringify(key), JSON.stringify(typeof value === 'string' ? value : '__proto__'));
      }
      holder[key] = value;
      return JSON.stringify(copy);
    });
  const file = fc.oneof(
    misfit,
    damaged(fc.constantFrom(...cases).map((c) => JSON.stringify(c.scenario, null, 1))),
    fc.json({ maxDepth: 4 }),
    fc.string(),
  );

  test('taken whole, or refused with a place', () => {
    fc.assert(
      fc.property(file, (text) => {
        try {
          const scenario = parseScenario(text, metas);
          expect(metas[scenario.system]).toBeDefined();
          for (const value of Object.values(scenario.parameters)) expect(Number.isFinite(value)).toBe(true);
          count('taken');
        } catch (error) {
          if (!(error instanceof ScenarioError)) throw error;
          expect(error.message.length).toBeGreaterThan(8);
          expect(error.message.length).toBeLessThan(2000);
          count('refused');
        }
      }),
      { seed: SEED, numRuns: runs(1500) },
    );
  });

  test.each([
    ['deep list', '['.repeat(1e5)],
    ['deep object', `{"a":${'{"a":'.repeat(2e4)}`],
    ['long text', `"${'x'.repeat(3e5)}"`],
    ['a key twice', '{"version":1,"version":1}'],
    ['a prototype', '{"version":1,"system":"ripstik","__proto__":{"duration":1}}'],
    ['a prototype within', '{"version":1,"system":"ripstik","initial":{"__proto__":1}}'],
  ])('%s is refused', (_what, text) => {
    expect(() => parseScenario(text, metas)).toThrow(ScenarioError);
  });
});

describe('expressions', () => {
  const count = tally('expressions');
  const token = fc.constantFrom(
    't',
    '1',
    '2.5e3',
    '.5',
    'pi',
    'e',
    'sin',
    'cos',
    'exp',
    'max',
    'atan2',
    'import',
    'constructor',
    'f',
    '(',
    ')',
    '(',
    ')',
    '+',
    '-',
    '*',
    '/',
    '^',
    '**',
    ',',
    '?',
    ':',
    '<',
    '==',
    ' deg',
    ' ',
    '!',
    "'",
    '%',
    'i',
    'x=1',
    ';',
    '[1]',
    'true',
    '√',
  );
  const formula = fc.oneof(
    fc.array(token, { maxLength: 40 }).map((list) => list.join('')),
    damaged(fc.constant('20 deg * sin(2*pi*1.5*t) + max(0, 1 - t^2)')),
    awkward,
    fc.string(),
  );

  test('a number at every time, or refused with a reason', () => {
    fc.assert(
      fc.property(formula, (text) => {
        try {
          const { evaluate, derivative } = compileExpression(text, { variables: ['t'] });
          for (const t of [0, 0.1, 1e3])
            expect([typeof evaluate(t), typeof derivative(t)]).toEqual(['number', 'number']);
          count('taken');
        } catch (error) {
          if (!(error instanceof ExpressionError)) throw error;
          expect(error.message.length).toBeGreaterThan(5);
          count('refused');
        }
      }),
      { seed: SEED, numRuns: runs(4000) },
    );
  });

  test.each([
    ['brackets', '('.repeat(1e5)],
    ['signs', '-'.repeat(1e5) + '1'],
    ['a long sum', `1${'+1'.repeat(1e5)}`],
    ['a tower', '9^9^9^9^9^9'],
    ['nested calls', `${'sin('.repeat(500)}t${')'.repeat(500)}`],
    ['nested choices', `${'t?'.repeat(500)}1${':1'.repeat(500)}`],
  ])('%s: a value or a reason, at once', (_what, text) => {
    try {
      compileExpression(text, { variables: ['t'] }).evaluate(1);
    } catch (error) {
      expect(error).toBeInstanceOf(ExpressionError);
    }
  });
});

describe('meshes', () => {
  const count = tally('meshes');
  const small = 'o a\nusemtl deck\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\nf -3 -2 -1\n';
  const mesh = fc.oneof(
    damaged(fc.constant(small)),
    damaged(fc.constant(readFileSync('public/models/rod.mdl', 'utf8').slice(0, 4000))),
    fc.string(),
  );
  const material = fc.oneof(
    damaged(fc.constant('newmtl deck\nKd 0.1 0.2 0.3\nNs 20\nmap_Kd http://x/y.png\n')),
    fc.string(),
  );

  test('drawn, or refused with a line', () => {
    fc.assert(
      fc.property(mesh, material, (mdl, mat) => {
        for (const [check, text, name] of [
          [checkMesh, mdl, 'a.mdl'],
          [checkMaterials, mat, 'a.mat'],
        ] as const) {
          try {
            // Nothing that would load another file is left.
            expect(check(text, name)).not.toMatch(/^\s*(mtllib|map_\w+|bump|disp|decal|refl)\b/m);
            count('taken');
          } catch (error) {
            if (!(error instanceof MeshError)) throw error;
            expect(error.message).toContain(name);
            count('refused');
          }
        }
      }),
      { seed: SEED, numRuns: runs(1500) },
    );
  });
});

describe('CSV', () => {
  const count = tally('csv');
  const names = metas.ripstik!.coordinates.map((q) => q.name);
  const good = [
    ['t', ...names].join(','),
    ...Array.from({ length: 6 }, (_, i) => [i / 10, ...names.map((_, c) => Math.sin(i + c))].join(',')),
  ].join('\n');
  const bytes = fc.oneof(
    damaged(fc.constant(good)).map((text) => new TextEncoder().encode(text)),
    damaged(
      fc.constant(`# scenario: {"version":1,"system":"ripstik"}\n${good.replaceAll(',', ';').replaceAll('.', ',')}`),
    ).map((text) => new TextEncoder().encode(text)),
    fc.uint8Array({ maxLength: 300 }),
    fc
      .array(fc.constantFrom(...names, 't', 't', 'psi', '', 'alpha [deg]', '__proto__'), { maxLength: 30 })
      .map((head) =>
        new TextEncoder().encode(
          `${head.join(',')}\n${head.map((_, i) => i).join(',')}\n${head.map((_, i) => i + 1).join(',')}`,
        ),
      ),
  );

  test('a motion of finite states in rising time, or refused with a place', () => {
    fc.assert(
      fc.property(bytes, (file) => {
        const reader = new CsvByteReader({ systems: metas, timeStep: 0.01 }, file.length);
        reader.push(file);
        const result = reader.finish();
        count(result.kind === 'motion' ? 'read' : 'refused');
        if (result.kind !== 'motion') {
          expect(result.kind === 'unusable' && result.issues[0]!.message.length > 5).toBe(true);
          return;
        }
        const t = result.data[0]!;
        for (let r = 1; r < result.rows; r++) expect(t[r]!).toBeGreaterThan(t[r - 1]!);
        for (const [c, name] of result.columns.entries()) {
          expect(result.data[c]!.length).toBe(result.rows);
          if (names.includes(name)) for (const x of result.data[c]!) expect(Number.isFinite(x)).toBe(true);
        }
      }),
      { seed: SEED, numRuns: runs(1500) },
    );
  });

  test('a hundred thousand columns, a line without end, one column', () => {
    const read = (text: string): string => {
      const reader = new CsvByteReader({ systems: metas });
      reader.push(new TextEncoder().encode(text));
      return reader.finish().kind;
    };
    const wide = Array.from({ length: 1e5 }, (_, i) => `c${i}`).join(',');
    expect(read(`${wide}\n${wide}\n`)).toBe('unusable');
    expect(read(`${'1,'.repeat(1e5)}1\n`)).toBe('unusable');
    expect(read('1'.repeat(3e6))).toBe('unusable');
    expect(read('t\n1\n2\n')).toBe('unusable');
  });
});
