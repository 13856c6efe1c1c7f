import type { ControllerProgram } from '../sampled/program.ts';
import { digits } from './exports.ts';

/** A sampled controller as the source of a program, with its test vector: C, Python, MATLAB, and JSON. */
export interface ProgramFormat {
  id: 'c' | 'python' | 'matlab' | 'json';
  extension: string;
  type: string;
  write(program: ControllerProgram): string;
}

export const programFormats: readonly ProgramFormat[] = [
  { id: 'c', extension: 'c', type: 'text/plain', write: programC },
  { id: 'python', extension: 'py', type: 'text/x-python', write: programPython },
  { id: 'matlab', extension: 'm', type: 'text/plain', write: programMatlab },
  {
    id: 'json',
    extension: 'json',
    type: 'application/json',
    write: (program) => `${JSON.stringify(program, null, 1)}\n`,
  },
];

const NAMES = ['A', 'B', 'C', 'D'] as const;

function heading({ sample, delay, inputs, measured }: ControllerProgram): string[] {
  return [
    'A regulator of RipStik Lab. Once a sample: u = C c + D y, then c = A c + B y; c is 0 at first.',
    `Sample time ${digits(sample)} s; the inputs act ${digits(delay)} s after y is measured, and are held. SI units, radians.`,
    `y: ${measured.join(', ')}, each less what it is in the steady motion`,
    `u: ${inputs.join(', ')}; limits, rates and steps of the motors are not in it`,
  ];
}

/** C99, double precision; its main checks the test vector. */
function programC(program: ControllerProgram): string {
  const { measured, inputs, A, test } = program;
  // An array of C has at least one entry.
  const [n, p, k] = [A.length, measured.length, inputs.length];
  const rows = (M: readonly (readonly number[])[]): string =>
    M.length > 0 && M[0]!.length > 0
      ? `{\n${M.map((row) => `  {${row.map(digits).join(', ')}}`).join(',\n')}\n}`
      : '{{0}}';
  const table = (name: string, M: readonly (readonly number[])[], r: number, c: number): string =>
    `static const double ${name}[${Math.max(1, r)}][${Math.max(1, c)}] = ${rows(M)};`;
  return [
    ...heading(program).map((line) => `/* ${line} */`),
    '#include <math.h>',
    '#include <stdio.h>',
    '',
    `enum { MEMORY = ${n}, MEASURED = ${p}, INPUTS = ${k}, TESTED = ${test.y.length} };`,
    table('A', program.A, n, n),
    table('B', program.B, n, p),
    table('C', program.C, k, n),
    table('D', program.D, k, p),
    `static double c[${Math.max(1, n)}];`,
    '',
    'void controller_step(const double y[MEASURED], double u[INPUTS])',
    '{',
    `  double next[${Math.max(1, n)}];`,
    '  for (int i = 0; i < INPUTS; i++) {',
    '    u[i] = 0;',
    '    for (int j = 0; j < MEMORY; j++) u[i] += C[i][j] * c[j];',
    '    for (int j = 0; j < MEASURED; j++) u[i] += D[i][j] * y[j];',
    '  }',
    '  for (int i = 0; i < MEMORY; i++) {',
    '    next[i] = 0;',
    '    for (int j = 0; j < MEMORY; j++) next[i] += A[i][j] * c[j];',
    '    for (int j = 0; j < MEASURED; j++) next[i] += B[i][j] * y[j];',
    '  }',
    '  for (int i = 0; i < MEMORY; i++) c[i] = next[i];',
    '}',
    '',
    '#ifndef CONTROLLER_WITHOUT_TEST',
    table('test_y', test.y, test.y.length, p),
    table('test_u', test.u, test.u.length, k),
    'int main(void)',
    '{',
    '  double largest = 0, size = 1e-300, u[INPUTS];',
    '  for (int row = 0; row < TESTED; row++) {',
    '    controller_step(test_y[row], u);',
    '    for (int i = 0; i < INPUTS; i++) {',
    '      largest = fmax(largest, fabs(u[i] - test_u[row][i]));',
    '      size = fmax(size, fabs(test_u[row][i]));',
    '    }',
    '  }',
    '  printf("largest difference, of the largest input: %g\\n", largest / size);',
    '  return largest > 1e-9 * size;',
    '}',
    '#endif',
    '',
  ].join('\n');
}

/** Columns of each matrix, which a matrix without rows does not tell. */
const columnsOf = ({ A, measured }: ControllerProgram): Record<(typeof NAMES)[number], number> => ({
  A: A.length,
  B: measured.length,
  C: A.length,
  D: measured.length,
});

/** Lists alone, so that a microcontroller's Python runs it as well. */
function programPython(program: ControllerProgram): string {
  const { test } = program;
  const list = (name: string, M: readonly (readonly number[])[]): string =>
    `${name} = [${M.map((row) => `\n    [${row.map(digits).join(', ')}],`).join('')}\n]`;
  const n = program.A.length;
  return [
    ...heading(program).map((line) => `# ${line}`),
    ...NAMES.map((name) => list(name, program[name])),
    list('TEST_Y', test.y),
    list('TEST_U', test.u),
    '',
    '',
    'def times(matrix, x):',
    '    return [sum(a * b for a, b in zip(row, x)) for row in matrix]',
    '',
    '',
    'class Controller:',
    '    def __init__(self):',
    `        self.c = [0.0] * ${n}`,
    '',
    '    def step(self, y):',
    '        u = [a + b for a, b in zip(times(C, self.c), times(D, y))]',
    '        self.c = [a + b for a, b in zip(times(A, self.c), times(B, y))]',
    '        return u',
    '',
    '',
    'if __name__ == "__main__":',
    '    controller = Controller()',
    '    answers = [controller.step(y) for y in TEST_Y]',
    '    off = [abs(a - u) for answer, row in zip(answers, TEST_U) for a, u in zip(answer, row)]',
    '    difference = max(off) / max(abs(u) for row in TEST_U for u in row)',
    '    print("largest difference, of the largest input:", difference)',
    '    raise SystemExit(difference > 1e-9)',
    '',
  ].join('\n');
}

function programMatlab(program: ControllerProgram): string {
  const { measured, inputs, test } = program;
  const n = program.A.length;
  const matrix = (name: string, M: readonly (readonly number[])[], columns: number): string =>
    M.length === 0 || columns === 0
      ? `${name} = zeros(${M.length}, ${columns});`
      : `${name} = [\n${M.map((row) => `  ${row.map(digits).join(', ')}`).join(';\n')}\n];`;
  const columns = columnsOf(program);
  return [
    ...heading(program).map((line) => `% ${line}`),
    ...NAMES.map((name) => matrix(name, program[name], columns[name])),
    matrix('test_y', test.y, measured.length),
    matrix('test_u', test.u, inputs.length),
    `c = zeros(${n}, 1); answers = zeros(size(test_u));`,
    'for row = 1:size(test_y, 1)',
    "  y = test_y(row, :)';",
    "  answers(row, :) = (C * c + D * y)';",
    '  c = A * c + B * y;',
    'end',
    'difference = max(abs(answers(:) - test_u(:))) / max(abs(test_u(:)));',
    "fprintf('largest difference, of the largest input: %g\\n', difference);",
    "assert(difference <= 1e-9, 'the program does not answer as its test vector says');",
    '',
  ].join('\n');
}
