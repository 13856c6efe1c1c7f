import { expect, test } from 'vitest';
import katex from 'katex';
import { equationsOf } from '../../../src/core/description/derive.ts';
import type { Id } from '../../../src/core/description/graph.ts';
import { latexOf, numberLatex } from '../../../src/core/description/latex.ts';
import { Polynomials, type Atom, type Polynomial } from '../../../src/core/description/polynomial.ts';
import { Program } from '../../../src/core/description/program.ts';
import { readDescription } from '../../../src/core/description/read.ts';
import { templates } from '../../../src/core/description/templates.ts';
import { typesetOf } from '../../../src/core/description/typeset.ts';
import { setMarks } from '../../../src/core/model/typeset.ts';
import { learnSystem, loadTypeset } from '../../../src/core/systems/registry.ts';

const seed = 20260328;

function random(): () => number {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return 0.3 + state / 2 ** 32;
  };
}

const FUNCTIONS: Record<string, (...x: number[]) => number> = {
  sin: Math.sin,
  cos: Math.cos,
  atan2: Math.atan2,
  pow: Math.pow,
  abs: Math.abs,
  tanh: Math.tanh,
  exp: Math.exp,
  atan: Math.atan,
  lt: (a, b) => Number(a < b),
  le: (a, b) => Number(a <= b),
  select: (c, a, b) => (c !== 0 ? a : b),
};

/** The value of what is printed, part by part. */
function valueOf(p: Polynomial, values: ReadonlyMap<string, number>, parts: Polynomials['parts']): number {
  const known = new Map<string, number>();
  const atom = ({ key, kind, name, of }: Atom): number => {
    let x = known.get(key);
    if (x !== undefined) return x;
    if (kind === 'part') x = value(parts.get(name)!);
    else if (kind === 'sum') x = value(of[0]!);
    else if (kind === 'function') x = FUNCTIONS[name]!(...of.map(value));
    else x = values.get(name)!;
    known.set(key, x);
    return x;
  };
  const value = (q: Polynomial): number =>
    [...q.values()].reduce(
      (sum, { coefficient, powers }) =>
        sum + powers.reduce((product, [a, power]) => product * atom(a) ** power, coefficient),
      0,
    );
  return value(p);
}

test.each(templates.map((template) => [template.id, template] as const))(
  '%s: what is printed is what is computed, and KaTeX sets it',
  async (_, { load }) => {
    const text = (await load()).default;
    const model = readDescription(text).model!;
    const { graph, q, v, p } = model;
    const equations = equationsOf(model);
    const symbols = new Map([...q, ...v, ...p].map((id, k) => [id, { name: `x${k}`, kind: 'coordinate' as const }]));
    const polynomials = new Polynomials(graph, symbols, new Map());
    const roots: Id[] = [
      ...equations.M,
      ...equations.h,
      ...equations.sets.flatMap(({ omega, gamma }) => [...omega, ...gamma]),
      model.kinetic,
      model.potential,
      ...[...model.rates.values()].map(({ value }) => value),
    ].filter((id) => graph.reach([id]).length <= 150);
    const next = random();
    const at = Float64Array.from([...q, ...v, ...p], next);
    const out = new Float64Array(roots.length);
    new Program(graph, { at: [...q, ...v, ...p] }, { out: roots }).interpreted()(at, out);
    const values = new Map([...at].map((x, k) => [`x${k}`, x]));
    roots.forEach((id, k) => {
      const printed = polynomials.of(id);
      const x = valueOf(printed, values, polynomials.parts);
      expect(Math.abs(x - out[k]!), `seed ${seed}: ${latexOf(printed)}`).toBeLessThan(1e-9 * (1 + Math.abs(out[k]!)));
    });

    const typeset = typesetOf(readDescription(text).model!, 'x');
    const { energies, letters, motion, structure, losses, mass, forces, constraints, bodies } = typeset;
    const all = [
      ...Object.values(energies),
      ...letters,
      ...motion,
      ...structure,
      ...losses,
      ...(mass?.entries.map(({ latex }) => latex) ?? []),
      ...(forces?.flatMap(({ latex }) => latex ?? []) ?? []),
      ...constraints.flatMap(({ rows, heights }) => [
        ...heights,
        ...rows.flatMap(({ latex, entries, gamma }) => [latex, gamma, ...entries.map((e) => e.latex)]),
      ]),
      ...bodies.flatMap(({ id: _id, ...body }) => Object.values(body) as (string | null)[]),
    ].filter((latex) => latex !== undefined && latex !== null);
    for (const latex of all.slice(0, 80)) {
      const set = setMarks(latex, typeset.symbols);
      expect(set).not.toContain('\\text{');
      katex.renderToString(set, { strict: false, throwOnError: true });
    }
  },
);

const written = (body: string): ReturnType<typeof typesetOf> => {
  const { model, faults } = readDescription(body);
  expect(faults).toEqual([]);
  const typeset = typesetOf(model!, 'x');
  const set = (latex: string): string => setMarks(latex, typeset.symbols);
  return { ...typeset, motion: typeset.motion.map(set), letters: typeset.letters.map(set) };
};

test('a pendulum reads as in a book', () => {
  const { motion } = written(
    [
      'coordinate theta [rad]',
      'parameter m [kg] = 1',
      'parameter l [m] = 1',
      'parameter gravity [m/s²] = 9.81',
      "kinetic 1/2 m l^2 theta'^2",
      'potential -m gravity l cos(theta)',
    ].join('\n'),
  );
  expect(motion).toHaveLength(1);
  expect(motion[0]).toContain('\\sin {\\theta}');
  expect(motion[0]).toMatch(/= Q_\{\\theta\}$/);
});

test('a point on a circle has no sines in its mass', () => {
  const { motion, letters } = written(
    [
      'coordinate a [rad]',
      'parameter l [m] = 1',
      'J = l^2/3',
      'body bob mass 2 at (l sin(a), 0, -l cos(a))',
      "kinetic 1/2 J a'^2",
    ].join('\n'),
  );
  expect(motion).toHaveLength(1);
  expect(motion[0]).not.toMatch(/sin|cos/);
  // A definition keeps its name.
  expect(letters).toEqual(['J = \\tfrac{1}{3} \\, l^{2}']);
});

test('equations of first order', () => {
  const { motion } = written(
    ['coordinate x [1] = 1', 'coordinate y [1] = 1', "x' = 1.1 x - 0.4 x y", "y' = 0.1 x y - 0.4 y/(1 + x)"].join('\n'),
  );
  expect(motion[0]).toBe('\\dot{x} = 1.1 \\, x - 0.4 \\, x \\, y');
  expect(motion[1]).toContain('\\dfrac{');
});

test('numbers as a person writes them', () => {
  expect([0.5, 1 / 12, 0.3, -2 / 3, 7, 1e-9, 0.25, 12.5].map(numberLatex)).toEqual([
    '\\tfrac{1}{2}',
    '\\tfrac{1}{12}',
    '0.3',
    '- \\tfrac{2}{3}',
    '7',
    '1 \\cdot 10^{-9}',
    '\\tfrac{1}{4}',
    '\\tfrac{25}{2}',
  ]);
});

test('a typed system has its equations in the registry', async () => {
  const { meta } = await learnSystem("coordinate x [m]\nkinetic 1/2 x'^2\npotential 2 x^2");
  const typeset = await loadTypeset(meta.id);
  expect(typeset?.system).toBe(meta.id);
  expect(typeset?.motion).toHaveLength(1);
});
