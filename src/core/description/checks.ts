/**
 * What can't be seen in the text: whether M can be factored, whether rows are linear in the rates and independent. Asked at
 * the rest of the system and at states near it, which chance has chosen once for all.
 */
import type { Equations } from './derive.ts';
import type { Model, SetModel } from './model.ts';
import { Program } from './program.ts';
import { DescriptionError } from './tokens.ts';

const SAMPLES = 6;
/** What is left of terms of about one that cancel. */
const NOTHING = 1e-14;
/** Numbers from chance that are the same on every machine (Park and Miller, Comm. ACM 31 (1988)). */
function chance(seed: number): () => number {
  let x = seed;
  return () => (x = (x * 48271) % 2147483647) / 2147483647 - 0.5;
}

interface Sample {
  q: Float64Array;
  v: Float64Array;
  p: Float64Array;
}

/** The rest of the system, and states around it. */
function samples({ coordinates, parameters }: Model): Sample[] {
  const random = chance(20261128);
  return Array.from({ length: SAMPLES }, (_, k) => ({
    q: Float64Array.from(coordinates, ({ rest }) => (rest ?? 0) + (k === 0 ? 0 : random())),
    v: Float64Array.from(coordinates, () => 2 * random()),
    p: Float64Array.from(parameters, (parameter) => parameter.default),
  }));
}

/**
 * The coordinates that give way so that heights vanish: those said, and for the others the ones that change them most at rest.
 *
 * @param model what was read of a description
 * @param set the constraint set
 */
export function solvedFor(model: Model, set: SetModel): number[] {
  const { graph, q, p } = model;
  const rows = set.rows.filter(({ height }) => height !== null);
  const said = rows.map(({ solve }) => solve);
  if (said.every((i) => i !== null)) return said;
  const slopes = rows.flatMap(({ height }) => graph.gradient(height!, q));
  const program = new Program(graph, { q, p }, { slopes }).interpreted();
  const J = new Float64Array(slopes.length);
  const n = q.length;
  const taken = new Set(said.filter((i) => i !== null));
  for (const state of samples(model)) {
    program(state.q, state.p, J);
    const chosen = choose(J, n, said, taken, model.clock);
    if (chosen) return chosen;
  }
  const row = rows[said.indexOf(null)]!;
  throw new DescriptionError('no coordinate changes this height; say which gives way at the start: solve z', row.line);
}

/** Gauss's elimination with the largest pivot of each row; lengths are taken before angles of the same worth. */
function choose(
  slopes: Float64Array,
  n: number,
  said: readonly (number | null)[],
  taken: ReadonlySet<number>,
  clock: number | null,
): number[] | null {
  const m = said.length;
  const A = slopes.slice();
  const chosen: number[] = [];
  const used = new Set(taken);
  for (let r = 0; r < m; r++) {
    let best = said[r] ?? -1;
    if (best < 0)
      for (let c = 0; c < n; c++)
        if (
          !used.has(c) &&
          c !== clock &&
          Math.abs(A[r * n + c]!) > 1e-6 &&
          (best < 0 || Math.abs(A[r * n + c]!) > 1.0001 * Math.abs(A[r * n + best]!))
        )
          best = c;
    if (best < 0 || Math.abs(A[r * n + best]!) < 1e-9) return null;
    used.add(best);
    chosen.push(best);
    for (let s = r + 1; s < m; s++) {
      const f = A[s * n + best]! / A[r * n + best]!;
      for (let c = 0; c < n; c++) A[s * n + c]! -= f * A[r * n + c]!;
    }
  }
  return chosen;
}

/**
 * @param model what was read of a description
 * @param equations of the model
 * @throws DescriptionError that names the line which makes it no system
 */
export function checkEquations(model: Model, equations: Equations): void {
  checkMass(model, equations);
  for (const set of equations.sets) checkRows(model, set);
}

function checkMass(model: Model, { M }: Equations): void {
  const { graph, q, v, p } = model;
  const n = q.length;
  const program = new Program(graph, { q, v, p }, { M }).interpreted();
  const values = new Float64Array(n * n);
  let weightless = -1;
  let negative = false;
  for (const state of samples(model)) {
    program(state.q, state.v, state.p, values);
    const bad = values.findIndex((x) => !Number.isFinite(x));
    weightless = bad >= 0 ? Math.floor(bad / n) : firstWithoutMass(values, n);
    if (weightless < 0) return;
    negative = values[weightless * (n + 1)]! < 0;
  }
  const { name } = model.coordinates[weightless]!;
  throw new DescriptionError(
    negative
      ? `the kinetic energy of ${name} is negative; a mass, an inertia or the sign of a kinetic line is wrong`
      : `the mass matrix is singular: nothing gives ${name} a mass or inertia of its own; give a body that it moves a mass and an inertia, or add to the kinetic energy, in which the rate of ${name} is ${name}'`,
    model.lines[weightless]!,
  );
}

/** Cholesky on the matrix scaled to a unit diagonal: the first coordinate whose pivot is rounding; -1 where there is none. */
function firstWithoutMass(M: Float64Array, n: number): number {
  const L = new Float64Array(n * n);
  for (let i = 0; i < n; i++) {
    if (!(M[i * n + i]! > 0)) return i;
    for (let j = 0; j <= i; j++) {
      let sum = M[i * n + j]! / Math.sqrt(M[i * n + i]! * M[j * n + j]!);
      for (let k = 0; k < j; k++) sum -= L[i * n + k]! * L[j * n + k]!;
      if (i !== j) L[i * n + j] = sum / L[j * n + j]!;
      else if (!(sum > 1e-12)) return i;
      else L[i * n + i] = Math.sqrt(sum);
    }
  }
  return -1;
}

function checkRows(model: Model, { id, rows, omega }: Equations['sets'][number]): void {
  const { graph, q, v, p } = model;
  const n = q.length;
  const m = rows.length;
  const program = new Program(graph, { q, v, p }, { omega, slip: rows.map((row) => row.velocity) }).interpreted();
  const [O, slip] = [new Float64Array(m * n), new Float64Array(m)];
  let dependent = -1;
  let seen = 0;
  for (const state of samples(model)) {
    program(state.q, state.v, state.p, O, slip);
    if (![...O, ...slip].every(Number.isFinite)) continue;
    seen++;
    for (let r = 0; r < m; r++) {
      let sum = 0;
      let size = 0;
      for (let i = 0; i < n; i++) {
        const term = O[r * n + i]! * state.v[i]!;
        sum += term;
        size += Math.abs(term);
      }
      if (Math.abs(sum - slip[r]!) > Math.max(NOTHING, 1e-9 * (size + Math.abs(slip[r]!))))
        throw new DescriptionError(
          'this velocity is not linear in the rates; write it as a sum of rates with factors that have none',
          rows[r]!.line,
        );
    }
    dependent = firstDependent(O, m, n);
    if (dependent < 0) return;
  }
  if (seen === 0)
    throw new DescriptionError(`the constraints "${id}" have no value at the start and around it`, rows[0]!.line);
  throw new DescriptionError(
    `this constraint follows from those above it in "${id}", or asks for nothing; leave it out`,
    rows[dependent]!.line,
  );
}

/** Gram and Schmidt on the rows: the first that lies in the span of those before; -1 where there is none. */
function firstDependent(O: Float64Array, m: number, n: number): number {
  const basis: Float64Array[] = [];
  for (let r = 0; r < m; r++) {
    const row = O.slice(r * n, (r + 1) * n);
    const size = Math.hypot(...row);
    for (let pass = 0; pass < 2; pass++)
      for (const e of basis) {
        const along = e.reduce((sum, x, i) => sum + x * row[i]!, 0);
        for (let i = 0; i < n; i++) row[i]! -= along * e[i]!;
      }
    const left = Math.hypot(...row);
    if (!(left > Math.max(NOTHING, 1e-10 * size))) return r;
    basis.push(row.map((x) => x / left));
  }
  return -1;
}
