/**
 * Writes the unrolled kernels of `src/core/linalg/`: `npx tsx scripts/write-kernels.ts`. Straight-line code with local
 * constants runs in V8 about three times as fast as loops over arrays of this size.
 */
import { writeFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';

const range = (n: number): number[] => Array.from({ length: n }, (_, i) => i);
const less = (terms: string[]): string => terms.map((t) => ` - ${t}`).join('');

/** Cholesky by rows (Golub and Van Loan, 4th ed., section 4.2.9), inverses of the diagonal kept. */
function factor(n: number): string[] {
  const lines = [`export function factor${n}(A: Float64Array, inverse: Float64Array, relativeFloor: number): number {`];
  for (const i of range(n)) {
    for (const j of range(i)) {
      lines.push(
        `  const l${i}_${j} = (A[${i * n + j}]!${less(range(j).map((k) => `l${i}_${k} * l${j}_${k}`))}) * r${j};`,
      );
    }
    lines.push(`  const a${i} = A[${i * n + i}]!;`);
    lines.push(`  const d${i} = a${i}${less(range(i).map((k) => `l${i}_${k} * l${i}_${k}`))};`);
    lines.push(
      `  if (!(d${i} > relativeFloor * a${i})) return ${i + 1};`,
      `  const l${i}_${i} = Math.sqrt(d${i});`,
      `  const r${i} = 1 / l${i}_${i};`,
    );
  }
  for (const i of range(n)) for (const j of range(i + 1)) lines.push(`  A[${i * n + j}] = l${i}_${j};`);
  for (const i of range(n)) lines.push(`  inverse[${i}] = r${i};`);
  return [...lines, '  return 0;', '}'];
}

/** All rows of Omega at once, so that an entry of L is read once for all of them; then their scalar products. */
function rows(n: number, m: number): string[] {
  const lines = [
    `export function rows${n}x${m}(L: Float64Array, inverse: Float64Array, omega: Float64Array, Y: Float64Array, S: Float64Array): void {`,
  ];
  for (const i of range(n)) {
    for (const j of range(i)) lines.push(`  const l${i}_${j} = L[${i * n + j}]!;`);
    lines.push(`  const r${i} = inverse[${i}]!;`);
    for (const r of range(m))
      lines.push(
        `  const y${r}_${i} = (omega[${r * n + i}]!${less(range(i).map((k) => `l${i}_${k} * y${r}_${k}`))}) * r${i};`,
      );
  }
  for (const r of range(m)) for (const i of range(n)) lines.push(`  Y[${r * n + i}] = y${r}_${i};`);
  for (const r of range(m)) {
    for (const s of range(r + 1)) {
      lines.push(
        `  const s${r}_${s} = ${range(n)
          .map((k) => `y${r}_${k} * y${s}_${k}`)
          .join(' + ')};`,
        `  S[${r * m + s}] = s${r}_${s};`,
      );
      if (s < r) lines.push(`  S[${s * m + r}] = s${r}_${s};`);
    }
  }
  return [...lines, '}'];
}

function forward(n: number): string[] {
  const lines = [`export function forward${n}(L: Float64Array, inverse: Float64Array, b: Float64Array): void {`];
  for (const i of range(n))
    lines.push(`  const x${i} = (b[${i}]!${less(range(i).map((k) => `L[${i * n + k}]! * x${k}`))}) * inverse[${i}]!;`);
  for (const i of range(n)) lines.push(`  b[${i}] = x${i};`);
  return [...lines, '}'];
}

function back(n: number): string[] {
  const lines = [`export function back${n}(L: Float64Array, inverse: Float64Array, b: Float64Array): void {`];
  for (const i of range(n).reverse()) {
    lines.push(
      `  const x${i} = (b[${i}]!${less(
        range(n)
          .filter((k) => k > i)
          .map((k) => `L[${k * n + i}]! * x${k}`),
      )}) * inverse[${i}]!;`,
    );
  }
  for (const i of range(n)) lines.push(`  b[${i}] = x${i};`);
  return [...lines, '}'];
}

const sum = (terms: string[]): string => terms.map((t) => ` + ${t}`).join('');

/** M x - Omega^T y = f, Omega x = g: forward, Schur complement, back, without going through memory in between. */
function solve(n: number, m: number): string[] {
  const lines = [
    `export function solve${n}x${m}(L: Float64Array, inverse: Float64Array, Y: Float64Array, S: Float64Array, inverseS: Float64Array, f: Float64Array, g: Float64Array): void {`,
  ];
  for (const i of range(n))
    lines.push(`  const x${i} = (f[${i}]!${less(range(i).map((k) => `L[${i * n + k}]! * x${k}`))}) * inverse[${i}]!;`);
  for (const r of range(m))
    lines.push(
      `  const c${r} = (g[${r}]!${less(range(n).map((k) => `Y[${r * n + k}]! * x${k}`))}${less(range(r).map((s) => `S[${r * m + s}]! * c${s}`))}) * inverseS[${r}]!;`,
    );
  for (const r of range(m).reverse())
    lines.push(
      `  const w${r} = (c${r}${less(
        range(m)
          .filter((s) => s > r)
          .map((s) => `S[${s * m + r}]! * w${s}`),
      )}) * inverseS[${r}]!;`,
    );
  for (const i of range(n).reverse()) {
    lines.push(
      `  const z${i} = (x${i}${sum(range(m).map((r) => `Y[${r * n + i}]! * w${r}`))}${less(
        range(n)
          .filter((k) => k > i)
          .map((k) => `L[${k * n + i}]! * z${k}`),
      )}) * inverse[${i}]!;`,
    );
  }
  for (const i of range(n)) lines.push(`  f[${i}] = z${i};`);
  for (const r of range(m)) lines.push(`  g[${r}] = w${r};`);
  return [...lines, '}'];
}

export function kernelText(n: number, m: number): string {
  return [
    '// Generated by `npx tsx scripts/write-kernels.ts`; do not edit. A test compares it with the generator.',
    `// The kernels of \`saddle.ts\` for ${n} coordinates and ${m} constraint rows, as straight lines.`,
    '/* eslint-disable */',
    '',
    ...factor(n),
    '',
    ...factor(m),
    '',
    ...rows(n, m),
    '',
    ...solve(n, m),
    '',
    ...forward(n),
    '',
    ...back(n),
    '',
    ...forward(m),
    '',
    ...back(m),
    '',
  ].join('\n');
}

/** Sizes worth it: the board. */
export const kernelSizes = [[10, 4]] as const;

export const kernelFile = (n: number, m: number): string => `src/core/linalg/saddle${n}x${m}.generated.ts`;

if (import.meta.url === pathToFileURL(process.argv[1] ?? '').href) {
  for (const [n, m] of kernelSizes) writeFileSync(kernelFile(n, m), kernelText(n, m));
}
