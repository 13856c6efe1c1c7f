import katex from 'katex';
import { describe, expect, test } from 'vitest';
import type { Motion } from '../../src/app/types.ts';
import { cases } from '../../src/core/cases/cases.ts';
import { parseScenario } from '../../src/core/scenario/schema.ts';
import { Simulation } from '../../src/core/simulation/simulation.ts';
import { loadSystem } from '../../src/core/systems/loaders.ts';
import { loadTypeset, marksOf, setMarks, type Typeset } from '../../src/core/systems/typeset.ts';
import { systemViews } from '../../src/core/systems/views.ts';
import { Trajectory } from '../../src/core/trajectory/trajectory.ts';
import { equations as words } from '../../src/text/equations.ts';
import { meaningOf, titleOfRow } from '../../src/tools/equations/meaning.ts';
import { constraintForce, presentOf } from '../../src/tools/equations/present.ts';
import { OPTIONS, withNames } from '../../src/tools/equations/rendering.ts';

const metas = Object.fromEntries(Object.entries(systemViews).map(([id, view]) => [id, view.meta]));
const ids = Object.keys(systemViews);

/** Every string of a page that is LaTeX. */
function formulasOf(typeset: Typeset): string[] {
  const found: string[] = [];
  const walk = (value: unknown): void => {
    if (typeof value === 'string') found.push(value);
    else if (Array.isArray(value)) value.forEach(walk);
    else if (value !== null && typeof value === 'object') Object.entries(value).forEach(([key, inner]) => !['id', 'system', 'symbols', 'title', 'column', 'row'].includes(key) && walk(inner));
  };
  walk(typeset);
  return found;
}

const GREEK: Record<string, string> = { α: '\\alpha', δ: '\\delta', θ: '\\theta', λ: '\\lambda', ρ: '\\rho', φ: '\\varphi', ψ: '\\psi' };

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
    for (const { name, symbol } of [...meta.coordinates, ...meta.parameters]) expect(typeset.symbols[name], name).toBe(letterOf(symbol));
    for (const { name, source } of meta.parameters) expect(source, name).toMatch(/\S/);
    const printed = new Set(formulasOf(typeset).flatMap(marksOf));
    // gravity does no work on level ground, and a flat vehicle's place enters no equation
    const absent = [...meta.coordinates, ...meta.parameters].filter(({ name }) => !printed.has(name) && !printed.has(`${name}_dot`)).map(({ name }) => name);
    expect(absent.filter((name) => name !== 'gravity')).toEqual([]);
  });

  test('rows and bodies are those of the system, and every symbol means something', async () => {
    const [typeset, system] = [(await loadTypeset(id))!, (await loadSystem(id))!];
    expect(typeset.constraints.map(({ id: set, rows, heights }) => [set, rows.length, heights.length])).toEqual(
      Object.entries(system.constraintSets).map(([set, { rows, contact }]) => [set, rows, contact?.count ?? 0]),
    );
    for (const set of typeset.constraints) set.rows.forEach(({ title }, row) => {
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
  const scenario = parseScenario({ ...cases.find(({ id }) => id === caseId)!.scenario, duration }, metas);
  const system = (await loadSystem(scenario.system))!;
  const simulation = new Simulation(scenario, system, { extras: ['lambda', 'energy', 'residual', 'inputs'] });
  while (simulation.advance(1e9).state === 'running');
  const { columns, rows } = simulation.takeChunk();
  const kept = simulation.columns.map((name, i) => [name, columns[i]!] as const).filter(([name]) => !without?.test(name));
  const trajectory = new Trajectory(kept.map(([name]) => name));
  trajectory.append(kept.map(([, values]) => values), rows);
  return { id: 1, source: 'run', title: caseId, system: systemViews[scenario.system]!, parameters: scenario.parameters, trajectory, constraints: scenario.constraints, scenario, written: null, adjustments: [], issues: [], marks: [], judgement: null };
}
