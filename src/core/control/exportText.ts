import type { ControlReport } from './report.ts';

/** A design as text for other programs. Numbers are written so that reading them back is exact. */
export const EXPORT_FORMATS = [
  { id: 'json', label: 'JSON', extension: 'json' },
  { id: 'csv', label: 'CSV', extension: 'csv' },
  { id: 'matlab', label: 'MATLAB', extension: 'm' },
  { id: 'numpy', label: 'NumPy', extension: 'py' },
] as const;

export type ExportFormat = (typeof EXPORT_FORMATS)[number]['id'];

/** A, B, and where there is a design Q, R and K, with the names of states and inputs. */
export function exportText(report: ControlReport, format: ExportFormat): string {
  switch (format) {
    case 'json':
      return `${JSON.stringify({ states: report.states, inputs: report.inputs, ...Object.fromEntries(matricesOf(report)) }, null, 2)}\n`;
    case 'csv':
      return csv(report);
    case 'matlab':
      return matlab(report);
    case 'numpy':
      return numpy(report);
  }
}

function matricesOf({ A, B, Q, R, K }: ControlReport): [string, number[][]][] {
  const design: [string, number[][]][] = Q && R && K ? [['Q', diagonal(Q)], ['R', diagonal(R)], ['K', K]] : [];
  return [['A', A], ['B', B], ...design];
}

function diagonal(entries: readonly number[]): number[][] {
  return entries.map((x, i) => entries.map((_, k) => (i === k ? x : 0)));
}

/** One table below the other: matrix and row name in front, column names above. */
function csv(report: ControlReport): string {
  const { states, inputs } = report;
  const names: Record<string, [readonly string[], readonly string[]]> = {
    A: [states, states],
    B: [states, inputs],
    Q: [states, states],
    R: [inputs, inputs],
    K: [inputs, states],
  };
  const tables = matricesOf(report).map(([name, rows]) => {
    const [down, across] = names[name]!;
    return [[name, ...across].join(','), ...rows.map((row, r) => [down[r]!, ...row].join(','))].join('\n');
  });
  return `${tables.join('\n\n')}\n`;
}

function matlab(report: ControlReport): string {
  const list = (names: readonly string[]): string => `{${names.map((n) => `'${n}'`).join(', ')}}`;
  const parts = matricesOf(report).map(([name, rows]) => `${name} = [\n${rows.map((row) => `  ${row.join(', ')}`).join(';\n')}\n];`);
  return `% ${HEAD}\nstates = ${list(report.states)};\ninputs = ${list(report.inputs)};\n${parts.join('\n')}\n`;
}

function numpy(report: ControlReport): string {
  const list = (names: readonly string[]): string => `[${names.map((n) => `"${n}"`).join(', ')}]`;
  const parts = matricesOf(report).map(([name, rows]) => `${name} = np.array([\n${rows.map((row) => `    [${row.join(', ')}],`).join('\n')}\n])`);
  return `# ${HEAD}\nimport numpy as np\n\nstates = ${list(report.states)}\ninputs = ${list(report.inputs)}\n${parts.join('\n')}\n`;
}

const HEAD = "x' = A x + B u, u = -K x, cost x' Q x + u' R u; x are deviations from the steady motion, SI units and radians";
