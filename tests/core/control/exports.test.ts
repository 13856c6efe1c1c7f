// Exports are read back by small readers of their own, and every number is the same to the last bit.
import { spawnSync } from 'node:child_process';
import { describe, expect, test } from 'vitest';
import { analyse } from '../../../src/core/control/analysis.ts';
import {
  designCsv,
  designJson,
  designMatlab,
  designNumpy,
  digits,
  exportFormats,
  type Design,
} from '../../../src/core/control/design/exports.ts';
import { systems } from '../../../src/core/systems/all.ts';
import { scenarioOf, seeded } from '../../helpers.ts';

const at = { X_dot: 1 };
const analysed = (control?: object) =>
  analyse(scenarioOf({ version: 1, system: 'ripstik', ...(control ? { control } : { at }) }), systems['ripstik']!);
const placed = analysed({
  type: 'lqr',
  inputs: ['tau_fc', 'tau_bc'],
  at,
  Q: { alpha_fp: 10, alpha_bp_dot: 0.1 },
  R: { tau_fc: 1 / 3 },
});
const open = analysed();

/** `name = [ … ];`, `np.array([…])`, `diag([…])`: rows of the numbers inside, as the language would make them. */
function readMatrix(source: string, name: string): number[][] | null {
  const found = new RegExp(`^${name} = (np\\.)?(diag|array)?\\(?\\[([^=]*?)\\]\\)?;?$`, 'm').exec(source);
  if (!found) return null;
  const [, , kind, body] = found;
  const numbers = (text: string) => (text.match(/[-+\d.e]+/g) ?? []).map(Number);
  if (kind === 'diag') {
    const diagonal = numbers(body!);
    return diagonal.map((x, i) => diagonal.map((_, k) => (i === k ? x : 0)));
  }
  return body!
    .split(/;\n|\],?\n/)
    .map(numbers)
    .filter((row) => row.length > 0);
}

const diagonal = (values: readonly number[]) => values.map((x, i) => values.map((_, k) => (i === k ? x : 0)));
const expected = (d: Design) => ({ A: d.A, B: d.B, Q: d.Q && diagonal(d.Q), R: d.R && diagonal(d.R), K: d.K });
/** `toEqual` takes -0 for 0 apart; so does this. */
const same = (a: unknown, b: unknown) => expect(a).toEqual(b);

describe('exports of a design', () => {
  test('digits name every number exactly', () => {
    const random = seeded(20260101);
    for (let i = 0; i < 2000; i++) {
      const x = (random() - 0.5) * 10 ** Math.floor(40 * random() - 20);
      expect(Number(digits(x)), `seed 20260101, number ${i}`).toBe(x);
    }
    for (const x of [0, -0, 1, -3, 1e15, 2 ** 53, 5e-324, Number.MAX_VALUE]) expect(Number(digits(x))).toBe(x);
  });

  test('the matrices are those of the board', () => {
    expect(placed.A).toHaveLength(20);
    expect(placed.K).toHaveLength(2);
    expect(placed.K![0]!.some((x) => x !== 0)).toBe(true);
  });

  test('JSON', () => {
    const read = JSON.parse(designJson(placed)) as Design;
    same(
      [read.states, read.inputs, read.A, read.B, read.Q, read.R, read.K],
      [placed.states, placed.inputs, placed.A, placed.B, placed.Q, placed.R, placed.K].map(
        (x) => JSON.parse(JSON.stringify(x)) as unknown,
      ),
    );
    expect(Object.keys(JSON.parse(designJson(open)) as object)).toEqual(['system', 'states', 'inputs', 'A', 'B']);
  });

  test('CSV by names', () => {
    const lines = designCsv(placed).trimEnd().split('\n');
    expect(lines[0]).toBe('matrix,row,column,value');
    const matrices = expected(placed) as Record<string, number[][]>;
    const names: Record<string, [readonly string[], readonly string[]]> = {
      A: [placed.states, placed.states],
      B: [placed.states, placed.inputs],
      Q: [placed.states, placed.states],
      R: [placed.inputs, placed.inputs],
      K: [placed.inputs, placed.states],
    };
    expect(lines).toHaveLength(1 + 400 + 40 + 400 + 4 + 40);
    for (const line of lines.slice(1)) {
      const [matrix, row, column, value] = line.split(',') as [string, string, string, string];
      const [rows, columns] = names[matrix]!;
      expect(Number(value), line).toBe(matrices[matrix]![rows.indexOf(row)]![columns.indexOf(column)]!);
    }
  });

  test.each([
    ['MATLAB', designMatlab],
    ['NumPy', designNumpy],
  ] as const)('%s text', (_, write) => {
    for (const [name, matrix] of Object.entries(expected(placed))) same(readMatrix(write(placed), name), matrix);
    for (const state of placed.states) expect(write(placed)).toContain(state);
    const plain = write(open);
    same(readMatrix(plain, 'A'), open.A);
    for (const name of ['Q', 'R', 'K']) expect(readMatrix(plain, name)).toBeNull();
  });

  test('NumPy text is Python', () => {
    const python = spawnSync('python3', ['-c', 'import ast, sys; ast.parse(sys.stdin.read())'], {
      input: designNumpy(placed),
    });
    if (!python.error) expect(String(python.stderr)).toBe('');
  });

  test('formats end as their programs expect', () => {
    expect(exportFormats.map((f) => f.extension)).toEqual(['json', 'csv', 'm', 'py']);
  });
});

describe('an analysis', () => {
  test('gives every eigenvalue a shape, in the same order', () => {
    expect(open.modes.map((m) => m.eigenvalue)).toEqual(open.eigenvalues);
    expect(placed.closedLoopModes!.map((m) => m.eigenvalue)).toEqual(placed.closedLoopEigenvalues);
    expect(open.closedLoopModes).toBeNull();
    for (const mode of [...open.modes, ...placed.closedLoopModes!]) expect(mode.moves.length).toBeGreaterThan(0);
  });

  test('a shape solves A x = lambda x', () => {
    for (const mode of open.modes.filter((m) => m.eigenvalue[1] === 0 && m.eigenvalue[0] !== 0)) {
      const image = open.A.map((row) => row.reduce((sum, a, k) => sum + a * mode.shape[k]!, 0));
      image.forEach((x, i) => expect(Math.abs(x - mode.eigenvalue[0] * mode.shape[i]!)).toBeLessThan(1e-8));
    }
  });
});
