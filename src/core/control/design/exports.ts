import type { ControlReport } from './report.ts';
import type { ScenarioLocus } from '../locus/scenarioLocus.ts';

/**
 * A linearization and its design as text for other programs. All numbers are SI and radians and are read back exactly:
 * 17 significant digits, or in JSON the shortest digits that name the same number.
 */

/** What is written; Q, R and K only where there is a design. Q and R are diagonals, by state and by input. */
export type Design = Pick<ControlReport, 'system' | 'states' | 'inputs' | 'A' | 'B' | 'Q' | 'R' | 'K'>;

export interface ExportFormat {
  id: 'json' | 'csv' | 'matlab' | 'numpy';
  /** How its file ends, and its media type. */
  extension: string;
  type: string;
  write(design: Design): string;
}

export const exportFormats: readonly ExportFormat[] = [
  { id: 'json', extension: 'json', type: 'application/json', write: designJson },
  { id: 'csv', extension: 'csv', type: 'text/csv', write: designCsv },
  { id: 'matlab', extension: 'm', type: 'text/plain', write: designMatlab },
  { id: 'numpy', extension: 'py', type: 'text/x-python', write: designNumpy },
];

export function designJson({ system, states, inputs, A, B, Q, R, K }: Design): string {
  const parts = { system, states, inputs, A, B, ...(K ? { Q, R, K } : {}) };
  // A row of a matrix on a line of its own.
  const lines = Object.entries(parts).map(([name, value]) => {
    const rows =
      Array.isArray(value) && Array.isArray(value[0])
        ? (value as number[][]).map((row) => `    ${JSON.stringify(row)}`)
        : null;
    return `  "${name}": ${rows ? `[\n${rows.join(',\n')}\n  ]` : JSON.stringify(value)}`;
  });
  return `{\n${lines.join(',\n')}\n}\n`;
}

/**
 * One entry a line, by name: `matrix,row,column,value`.
 *
 * @param design matrices with the names of their rows and columns, SI
 */
export function designCsv(design: Design): string {
  const lines = matricesOf(design).flatMap(({ name, rows, columns, entries }) =>
    entries.flatMap((row, i) => row.map((x, k) => `${name},${rows[i]!},${columns[k]!},${digits(x)}`)),
  );
  return `matrix,row,column,value\n${lines.join('\n')}\n`;
}

/**
 * The design as a MATLAB script.
 *
 * @param design matrices with the names of their rows and columns, SI
 */
export function designMatlab(design: Design): string {
  const list = (names: readonly string[]): string => `{${names.map((n) => `'${n}'`).join(', ')}}`;
  const matrices = matricesOf(design).map(({ name, entries, diagonal }) =>
    diagonal
      ? `${name} = diag([${diagonal.map(digits).join(', ')}]);`
      : `${name} = [\n${entries.map((row) => `  ${row.map(digits).join(', ')}`).join(';\n')}\n];`,
  );
  return [
    ...heading(design).map((line) => `% ${line}`),
    `states = ${list(design.states)};`,
    `inputs = ${list(design.inputs)};`,
    ...matrices,
    '',
  ].join('\n');
}

/**
 * The design as a NumPy script.
 *
 * @param design matrices with the names of their rows and columns, SI
 */
export function designNumpy(design: Design): string {
  const list = (names: readonly string[]): string => `[${names.map((n) => `"${n}"`).join(', ')}]`;
  const matrices = matricesOf(design).map(({ name, entries, diagonal }) =>
    diagonal
      ? `${name} = np.diag([${diagonal.map(digits).join(', ')}])`
      : `${name} = np.array([\n${entries.map((row) => `    [${row.map(digits).join(', ')}],`).join('\n')}\n])`,
  );
  const head = [...heading(design).map((line) => `# ${line}`), 'import numpy as np', ''];
  return [...head, `states = ${list(design.states)}`, `inputs = ${list(design.inputs)}`, ...matrices, ''].join('\n');
}

function heading({ system, K }: Design): string[] {
  return [
    `${system}: x' = A x + B u about a steady motion, x the deviations of all coordinates, then of all velocities`,
    ...(K ? ["u = -K x makes the integral of x' Q x + u' R u least on what the inputs reach"] : []),
    'SI units, radians',
  ];
}

interface NamedMatrix {
  name: string;
  rows: readonly string[];
  columns: readonly string[];
  entries: readonly (readonly number[])[];
  diagonal?: readonly number[];
}

function matricesOf({ states, inputs, A, B, Q, R, K }: Design): NamedMatrix[] {
  const plant = [
    { name: 'A', rows: states, columns: states, entries: A },
    { name: 'B', rows: states, columns: inputs, entries: B },
  ];
  if (!K || !Q || !R) return plant;
  return [
    ...plant,
    { name: 'Q', rows: states, columns: states, entries: diagonalMatrix(Q), diagonal: Q },
    { name: 'R', rows: inputs, columns: inputs, entries: diagonalMatrix(R), diagonal: R },
    { name: 'K', rows: inputs, columns: states, entries: K },
  ];
}

function diagonalMatrix(diagonal: readonly number[]): number[][] {
  return diagonal.map((x, i) => diagonal.map((_, k) => (i === k ? x : 0)));
}

/**
 * Whole numbers plainly, others with 17 significant digits.
 *
 * @param x any finite number
 */
export function digits(x: number): string {
  return Number.isInteger(x) && Math.abs(x) < 1e15 ? (Object.is(x, -0) ? '-0' : String(x)) : x.toPrecision(17);
}

/** A root locus, one value a line: what was varied, then real and imaginary part of every branch (1/s). */
export function locusCsv({
  request,
  values,
  branches,
}: Pick<ScenarioLocus, 'request' | 'values' | 'branches'>): string {
  const head = [request.name, ...branches.flatMap((_, i) => [`re_${i + 1}`, `im_${i + 1}`])];
  const rows = values.map((value, k) => [value, ...branches.flatMap((branch) => [...branch[k]!])].map(digits));
  return `${[head, ...rows].map((row) => row.join(',')).join('\n')}\n`;
}
