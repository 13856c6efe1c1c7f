import katex from 'katex';
import { describe, expect, test } from 'vitest';
import type { Motion } from '../../../src/app/runs/motion.ts';
import { cases, loadSystem, loadTypeset, systemViews } from '../../../src/core/systems/registry.ts';
import { termsOf } from '../../../src/core/mechanics/terms.ts';
import type { System } from '../../../src/core/model/system.ts';
import { checkScenario } from '../../../src/core/scenario/schema.ts';
import { EXTRA_COLUMNS, Simulation } from '../../../src/core/simulation/simulation.ts';
import { marksOf, setMarks, type Typeset } from '../../../src/core/model/typeset.ts';
import { Trajectory } from '../../../src/core/motion/trajectory.ts';
import { equations as words } from '../../../src/features/equations/words.ts';
import { meaningOf, titleOfRow } from '../../../src/features/equations/meaning.ts';
import { constraintForce, presentOf, stateAt, type Present } from '../../../src/features/equations/present.ts';
import { OPTIONS, withNames } from '../../../src/features/equations/rendering.ts';

const metas = Object.fromEntries(Object.entries(systemViews).map(([id, view]) => [id, view.meta]));
const ids = Object.keys(systemViews);

/** Every string of a page that is LaTeX. */
function formulasOf(typeset: Typeset): string[] {
  const found: string[] = [];
  const walk = (value: unknown): void => {
    if (typeof value === 'string') found.push(value);
    else if (Array.isArray(value)) value.forEach(walk);
    else if (value !== null && typeof value === 'object')
      Object.entries(value).forEach(
        ([key, inner]) => !['id', 'system', 'symbols', 'title', 'column', 'row'].includes(key) && walk(inner),
      );
  };
  walk(typeset);
  return found;
}

const GREEK: Record<string, string> = {
  α: '\\alpha',
  β: '\\beta',
  δ: '\\delta',
  ζ: '\\zeta',
  θ: '\\theta',
  κ: '\\kappa',
  λ: '\\lambda',
  ρ: '\\rho',
  φ: '\\varphi',
  ψ: '\\psi',
};

/** What the derivation makes of a meta's symbol. */
function letterOf(symbol: string): string {
  const [base, below] = symbol.split('_') as [string, string?];
  const set = below && /^[a-z]{3,}$/.test(below) ? `\\mathrm{${below}}` : below;
  return (GREEK[base] ?? base) + (set ? `_{${set}}` : '');
}

describe.each(ids)('equations of %s', (id) => {
  const { meta } = systemViews[id]!;

  test('set in KaTeX without an error, with words for screen readers', async () => {
    const typeset = (await loadTypeset(id))!;
    const formulas = formulasOf(typeset);
    expect(formulas.length).toBeGreaterThan(0);
    for (const latex of formulas) {
      const html = katex.renderToString(withNames(latex, typeset.symbols), OPTIONS);
      expect(html).toContain('<math');
      for (const mark of marksOf(latex)) expect(html, latex).toContain(`data-symbol="${mark}"`);
      // what is copied stands by itself
      const copied = setMarks(latex, typeset.symbols);
      expect(copied).not.toMatch(/\\s\{|\\text\{/);
      katex.renderToString(copied, { throwOnError: true, strict: 'error' });
    }
  });

  test('every coordinate and parameter has the letter of the panel, a unit and a source', async () => {
    const typeset = (await loadTypeset(id))!;
    for (const { name, symbol } of [...meta.coordinates, ...meta.parameters])
      expect(typeset.symbols[name], name).toBe(letterOf(symbol));
    for (const { name, source } of meta.parameters) expect(source, name).toMatch(/\S/);
    const printed = new Set(formulasOf(typeset).flatMap(marksOf));
    // gravity does no work on level ground, and a flat vehicle's place enters no equation
    const absent = [...meta.coordinates, ...meta.parameters]
      .filter(({ name }) => !printed.has(name) && !printed.has(`${name}_dot`))
      .map(({ name }) => name);
    expect(absent.filter((name) => name !== 'gravity')).toEqual([]);
  });

  test('rows and bodies are those of the system, and every symbol means something', async () => {
    const [typeset, system] = [(await loadTypeset(id))!, (await loadSystem(id))!];
    expect(typeset.constraints.map(({ id: set, rows, heights }) => [set, rows.length, heights.length])).toEqual(
      Object.entries(system.constraintSets).map(([set, { rows, contact }]) => [set, rows, contact?.count ?? 0]),
    );
    for (const set of typeset.constraints)
      set.rows.forEach(({ title }, row) => {
        expect(words.constraints.titles[title], title).toBeDefined();
        expect(titleOfRow(typeset, set.id, row)).toBe(words.constraints.titles[title]);
      });
    const letters = new Set([...typeset.letters, 'x = y'].map((latex) => marksOf(latex)[0]));
    for (const mark of Object.keys(typeset.symbols)) {
      const { what } = meaningOf(mark, systemViews[id]!, typeset, null, 0);
      if (!letters.has(mark)) expect(what, mark).not.toBe(words.meaning.abbreviation);
    }
  });
});

/** A run of a built-in case, its rows as a motion; `without` names columns that it does not keep. */
async function motionOf(caseId: string, duration: number, without: RegExp | null): Promise<Motion> {
  const scenario = checkScenario({ ...cases.find(({ id }) => id === caseId)!.scenario, duration }, metas);
  const system = (await loadSystem(scenario.system))!;
  const simulation = new Simulation(scenario, system, { extras: EXTRA_COLUMNS });
  while (!simulation.end) simulation.advance(() => false);
  const { columns, rows } = simulation.takeChunk();
  const kept = simulation.columns
    .map((name, i) => [name, columns[i]!] as const)
    .filter(([name]) => !without?.test(name));
  const trajectory = new Trajectory(kept.map(([name]) => name));
  trajectory.append(
    kept.map(([, values]) => values),
    rows,
  );
  return {
    id: 1,
    source: 'run',
    title: caseId,
    system: systemViews[scenario.system]!,
    parameters: scenario.parameters,
    trajectory,
    constraints: scenario.constraints,
    scenario,
    written: null,
    adjustments: [],
    issues: [],
    marks: [],
    judgement: null,
  };
}

/** As the page and its worker do it together. */
function presentIn(system: System, motion: Motion, time: number): Present | null {
  const at = stateAt(motion, time);
  return at && presentOf(termsOf(system, at), at, motion, time);
}

describe('the matrices at a moment', () => {
  test.each([
    ['ridden', 'ripstik'],
    ['bicycle-weave', 'bicycle'],
    ['falling-report', 'ripstik'],
  ])('%s: multipliers computed are those that the run recorded', async (caseId, id) => {
    const system = (await loadSystem(id))!;
    const whole = await motionOf(caseId, 0.5, null);
    const bare = await motionOf(caseId, 0.5, /^lambda_/);
    const time = whole.trajectory.column('t')![30]!;
    const [read, computed] = [presentIn(system, whole, time)!, presentIn(system, bare, time)!];
    expect([read.computed, computed.computed]).toEqual([false, true]);
    expect(read.m).toBe(system.constraintSets[whole.constraints!]!.rows);
    const scale = Math.max(...read.lambda!.map(Math.abs));
    for (let r = 0; r < read.m; r++)
      expect(Math.abs(read.lambda![r]! - computed.lambda![r]!)).toBeLessThan(1e-9 * scale);
    expect(Math.max(...read.slip.map(Math.abs))).toBeLessThan(1e-12);
    expect(read.condition).toBeGreaterThan(1);
    // energy is the run's own
    expect(read.kinetic + read.potential).toBeCloseTo(whole.trajectory.column('energy')![30]!, 9);
    const force = constraintForce(read)!;
    for (let i = 0; i < read.n; i++) {
      const sum = Array.from(read.lambda!, (l, r) => l * read.omega[r * read.n + i]!).reduce((a, b) => a + b, 0);
      expect(force[i]).toBeCloseTo(sum, 12);
    }
  });

  test('a file without velocities has no numbers; one without inputs leaves them open', async () => {
    const system = (await loadSystem('ripstik'))!;
    const motion = await motionOf('ridden', 0.2, /_dot$/);
    expect(presentIn(system, motion, 0.1)).toBeNull();
    const file: Motion = {
      ...(await motionOf('ridden', 0.2, /^(lambda_|tau_)/)),
      source: 'file',
      scenario: null,
      constraints: null,
    };
    const present = presentIn(system, file, 0.1)!;
    expect([present.inputs, present.lambda, constraintForce(present)]).toEqual([null, null, null]);
    expect(present.m).toBe(4);
  });

  test('a system of first order shows its rate', async () => {
    const motion = await motionOf(cases.find(({ scenario }) => scenario.system === 'stiff-decay')!.id, 1, null);
    const present = presentIn((await loadSystem('stiff-decay'))!, motion, 0)!;
    expect(present.rate![0]).toBe(-15);
    expect(present.m).toBe(0);
  });
});
