/** C99 of a system: mass matrix, forces and constraints as straight lines, accelerations and multipliers, and a test. */
import { equationsOf } from '../description/derive.ts';
import type { Id, OpName } from '../description/graph.ts';
import type { Source, TestVector } from './source.ts';
import { straightLine, type Syntax } from './straightLine.ts';

/** What a correct compiler and its mathematics stay below, relative to the largest acceleration. */
const AGREES = 1e-10;

const NAMES: Partial<Record<OpName, string>> = { abs: 'fabs' };

const C: Syntax = {
  number: (x) => (/[.e]/.test(String(x)) || !Number.isFinite(x) ? constant(x) : `${x}.0`),
  call: (name, operands) => `${NAMES[name] ?? name}(${operands.join(', ')})`,
  truth: (condition) => `(${condition} ? 1.0 : 0.0)`,
  select: (condition, yes, no) => `(${condition} ? ${yes} : ${no})`,
  isTrue: (x) => `${x} != 0.0`,
};

function constant(x: number): string {
  if (Number.isNaN(x)) return 'NAN';
  if (!Number.isFinite(x)) return x < 0 ? '-INFINITY' : 'INFINITY';
  return String(x);
}

/**
 * One file: compiled as it is, a library; with -DTEST, a program that compares.
 *
 * @param source what is exported
 * @param about lines of what it is and what is left out
 */
export function cOf(source: Source, about: readonly string[]): string {
  const { model, id, set } = source;
  const names = model.coordinates.map(({ name }) => name);
  const R = set?.rows.length ?? 0;
  const parts = [
    `/*\n${about.map((line) => ` * ${line}`.trimEnd()).join('\n')}\n *\n * Compile and check:  cc -std=c99 -O2 -DTEST ${id}.c -lm -o ${id} && ./${id}\n */`,
    '#include <math.h>',
    enumOf('Coordinates, and their rates', 'Q', names, 'N'),
    enumOf(
      'Parameters',
      'P',
      model.parameters.map(({ name }) => name),
      'PARAMETERS',
    ),
    ...(model.mechanical
      ? [
          enumOf(
            'Inputs',
            'U',
            model.inputs.map(({ name }) => name),
            'INPUTS',
          ),
        ]
      : []),
    `/* ${model.parameters.map(({ name, unit }) => `${name} [${unit}]`).join(', ') || 'no parameters'} */\n` +
      `const double ${id}_parameters[PARAMETERS + 1] = ${braces(source.p, 1)};`,
    ...(model.mechanical ? [`enum { ROWS = ${R} }; /* constraints: ${set ? set.id : 'none'} */`] : []),
    model.mechanical ? equations(source) : firstOrder(source),
    ...(model.mechanical ? [solver(source)] : []),
    test(source),
  ];
  return `${parts.join('\n\n')}\n`;
}

function enumOf(what: string, letter: string, names: readonly string[], count: string): string {
  return `/* ${what} */\nenum { ${[...names.map((name) => `${letter}_${name}`), count].join(', ')} };`;
}

/** Arrays of C have at least one entry. */
function braces(values: ArrayLike<number>, more: number): string {
  const all = [...Array.from(values, (x) => C.number(x)), ...Array<string>(more).fill('0.0')];
  return `{${all.join(', ')}}`;
}

function given({ model }: Source): Map<Id, string> {
  const { coordinates, parameters, q, v, p } = model;
  return new Map([
    ...q.map((node, i): [Id, string] => [node, `q[Q_${coordinates[i]!.name}]`]),
    ...v.map((node, i): [Id, string] => [node, `v[Q_${coordinates[i]!.name}]`]),
    ...p.map((node, i): [Id, string] => [node, `p[P_${parameters[i]!.name}]`]),
  ]);
}

function body(source: Source, outputs: Readonly<Record<string, readonly Id[]>>): string {
  const { graph } = source.model;
  const { lines, of } = straightLine(graph, Object.values(outputs).flat(), given(source), 'w', C);
  return [
    ...lines.map(({ name, text }) => `  const double ${name} = ${text};`),
    ...Object.entries(outputs).flatMap(([name, ids]) => ids.map((node, k) => `  ${name}[${k}] = ${of(node)};`)),
  ].join('\n');
}

function equations(source: Source): string {
  const { model, id, set } = source;
  const { M, h, sets } = equationsOf(model);
  const rows = set && sets.find((one) => one.id === set.id);
  return `/* M a = h + B u + Omega^T lambda,  Omega a + gamma = 0; matrices row by row:
   M[N*N], h[N], Omega[ROWS*N], gamma[ROWS] */
void ${id}_equations(const double *q, const double *v, const double *p,
    double *M, double *h, double *Omega, double *gamma_) {
  (void)q, (void)v, (void)p, (void)Omega, (void)gamma_;
${body(source, { M, h, Omega: rows?.omega ?? [], gamma_: rows?.gamma ?? [] })}
}`;
}

function firstOrder(source: Source): string {
  const { model, id } = source;
  return `/* The rates of the coordinates: rate[N] */
void ${id}_rates(const double *q, const double *p, double *rate) {
  (void)q, (void)p;
${body(source, { rate: model.q.map((_, i) => model.rates.get(i)!.value) })}
}`;
}

function solver({ model, id, held }: Source): string {
  const inputs = model.inputs.flatMap(({ name, column }) =>
    Object.entries(column).map(
      ([coordinate, weight]) => `  b[Q_${coordinate}] += ${weight === 1 ? '' : `${C.number(weight)}*`}u[U_${name}];`,
    ),
  );
  const hold =
    held.length === 0
      ? ''
      : `
  /* Held where they are: ${held.map((i) => model.coordinates[i]!.name).join(', ')} */
  static const int held[] = {${held.map((i) => `Q_${model.coordinates[i]!.name}`).join(', ')}};
  for (i = 0; i < ${held.length}; i++) {
    const int at = held[i];
    for (j = 0; j < N; j++) M[at*N + j] = M[j*N + at] = 0.0;
    for (j = 0; j < ROWS; j++) Omega[j*N + at] = 0.0;
    M[at*N + at] = 1.0;
    b[at] = 0.0;
  }`;
  return `/* Accelerations a[N] and multipliers lambda[ROWS] at a state, with inputs u[INPUTS].
   Returns 0, or 1 where mass matrix or constraints are singular. */
int ${id}_accelerations(const double *q, const double *v, const double *p, const double *u,
    double *a, double *lambda) {
  enum { S = N + ROWS };
  double M[N*N], Omega[ROWS*N + 1], gamma_[ROWS + 1], K[S*S], b[S];
  int i, j, k;
  ${id}_equations(q, v, p, M, b, Omega, gamma_);
  (void)u, (void)lambda;
${inputs.join('\n')}${hold}
  /* [M, -Omega^T; Omega, 0] [a; lambda] = [h + B u; -gamma], by elimination with partial pivoting
     (Golub and Van Loan, Matrix Computations, 4th ed., section 3.4), rows scaled to the same size. */
  for (i = 0; i < S; i++)
    for (j = 0; j < S; j++)
      K[i*S + j] = i < N ? (j < N ? M[i*N + j] : -Omega[(j - N)*N + i]) : (j < N ? Omega[(i - N)*N + j] : 0.0);
  for (i = 0; i < ROWS; i++) b[N + i] = -gamma_[i];
  for (i = 0; i < S; i++) {
    double most = 0.0;
    for (j = 0; j < S; j++) most = fmax(most, fabs(K[i*S + j]));
    if (!(most > 0.0)) return 1;
    for (j = 0; j < S; j++) K[i*S + j] /= most;
    b[i] /= most;
  }
  for (k = 0; k < S; k++) {
    int pivot = k;
    for (i = k + 1; i < S; i++) if (fabs(K[i*S + k]) > fabs(K[pivot*S + k])) pivot = i;
    if (!(fabs(K[pivot*S + k]) > 0.0)) return 1;
    for (j = k; j < S; j++) {
      const double x = K[k*S + j];
      K[k*S + j] = K[pivot*S + j];
      K[pivot*S + j] = x;
    }
    { const double x = b[k]; b[k] = b[pivot]; b[pivot] = x; }
    for (i = k + 1; i < S; i++) {
      const double factor = K[i*S + k]/K[k*S + k];
      for (j = k; j < S; j++) K[i*S + j] -= factor*K[k*S + j];
      b[i] -= factor*b[k];
    }
  }
  for (i = S - 1; i >= 0; i--) {
    for (j = i + 1; j < S; j++) b[i] -= K[i*S + j]*b[j];
    b[i] /= K[i*S + i];
  }
  for (i = 0; i < N; i++) a[i] = b[i];
  for (i = 0; i < ROWS; i++) lambda[i] = b[N + i];
  return 0;
}`;
}

function test(source: Source): string {
  const { model, id, tests } = source;
  const one = (vector: TestVector): string => {
    const { what, q, v, u, acceleration, lambda } = vector;
    const expected = braces(acceleration, 0);
    return model.mechanical
      ? `  { /* ${what} */
    const double q[] = ${braces(q, 0)}, v[] = ${braces(v, 0)}, u[] = ${braces(u, 1)};
    const double a_[] = ${expected}, lambda_[] = ${braces(lambda, 1)};
    double a[N] = {0.0}, lambda[ROWS + 1] = {0.0};
    if (${id}_accelerations(q, v, ${id}_parameters, u, a, lambda)) return puts("singular"), 1;
    worst = fmax(worst, differ(N, a, a_));
    worst = fmax(worst, differ(ROWS, lambda, lambda_));
  }`
      : `  { /* ${what} */
    const double q[] = ${braces(q, 0)}, rate_[] = ${expected};
    double rate[N];
    ${id}_rates(q, ${id}_parameters, rate);
    worst = fmax(worst, differ(N, rate, rate_));
  }`;
  };
  return `#ifdef TEST
#include <stdio.h>

/* The largest difference, relative to the largest value or 1. */
static double differ(int n, const double *x, const double *y) {
  double most = 1.0, worst = 0.0;
  int i;
  for (i = 0; i < n; i++) {
    most = fmax(most, fabs(y[i]));
    if (!(fabs(x[i] - y[i]) <= worst)) worst = fabs(x[i] - y[i]);
  }
  return worst/most;
}

/* What RipStik Lab computes at ${tests.length === 1 ? 'this state' : 'these states'}. */
int main(void) {
  double worst = 0.0;
${tests.map(one).join('\n')}
  printf("largest relative difference %.3g\\n", worst);
  return worst < ${AGREES} ? 0 : 1;
}
#endif`;
}
