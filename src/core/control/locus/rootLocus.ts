import type { Matrix } from 'ml-matrix';
import { norm } from '../linearization/matrices.ts';
import { distance, eigenvalues, plainEigenvalues, type Complex } from '../linearization/spectrum.ts';

/** Eigenvalues of a linear system against one parameter (a speed, a length …). */
export interface RootLocus {
  /** Ascending; the asked values and those that were put between them where branches moved fast. */
  values: number[];
  /** One per eigenvalue, each with an entry per value: a branch follows one mode as far as it can be followed. */
  branches: Complex[][];
  /** Where a real part crosses zero, ascending. */
  critical: CriticalValue[];
}

export interface CriticalValue {
  value: number;
  /** On the imaginary axis there: a real zero (divergence) or a pair (oscillation). */
  eigenvalue: Complex;
  /** The number of growing modes below and above. */
  unstableBelow: number;
  unstableAbove: number;
}

/** The system matrix (d x d) at a parameter value; null where there is no steady motion. */
export type Family = (value: number) => Matrix | null;

/** Share of the spectrum's size by which an eigenvalue may move between neighbouring values before one is put between. */
const STRIDE = 0.08;
/** Halvings of an interval of the asked values at most. */
const MOST_HALVINGS = 5;
/** Bisections of a critical value: to the last digits of a double. */
const MOST_BISECTIONS = 60;
/** Share of the largest value's size at which bisection goes on with the real part in place of the number of growing modes. */
const FINISH = 1e-6;
/** A real part within this share of the matrix's norm is neither growing nor decaying. */
const NEUTRAL = 1e-10;

/**
 * Branches of eigenvalues over `values` (ascending), refined where they move fast, and the critical values between
 * them. Values where the family has no matrix are left out. Not guaranteed: a real part that crosses zero and comes
 * back between two neighbouring values is not seen; a branch may change its mode where two come very close.
 *
 * @param family the matrix by value
 * @param values ascending
 */
export function rootLocus(family: Family, values: readonly number[]): RootLocus {
  const samples: Sample[] = [];
  for (const value of values) {
    const next = sampleAt(family, value);
    if (!next || next.spectrum.length !== (samples[0] ?? next).spectrum.length) continue;
    const last = samples.at(-1);
    if (last) samples.push(...between(family, last, next, MOST_HALVINGS));
    samples.push(next);
  }
  const branches = track(samples.map((s) => s.spectrum));
  const critical: CriticalValue[] = [];
  const width = FINISH * Math.max(...samples.map((s) => Math.abs(s.value)));
  let last = samples[0];
  for (let i = 1; i < samples.length; i++) {
    const [here, next] = [samples[i]!, samples[i + 1]];
    const through = next && isTouch(here, last!, next) ? passing(family, here, width) : null;
    critical.push(...crossings(family, last!, through?.before ?? here, width), ...(through?.crossing ?? []));
    last = through?.after ?? here;
  }
  return { values: samples.map((s) => s.value), branches, critical };
}

interface Sample {
  value: number;
  spectrum: Complex[];
  size: number;
  unstable: number;
  /** Number of exact zeros. */
  neutral: number;
}

function sampleAt(family: Family, value: number): Sample | null {
  const A = family(value);
  if (!A) return null;
  const size = norm(A);
  const spectrum = eigenvalues(A);
  return {
    value,
    spectrum,
    size,
    unstable: spectrum.filter(([re]) => re > NEUTRAL * size).length,
    neutral: spectrum.filter(isZero).length,
  };
}

/** Several modes stand still at one value alone (a caster without trail, a board at rest): the number of growing ones there is that of neither side. */
function isTouch(here: Sample, a: Sample, b: Sample): boolean {
  return here.neutral > Math.max(a.neutral, b.neutral);
}

/** The samples on both sides of such a value, and the crossing there if the numbers differ. */
function passing(
  family: Family,
  { value }: Sample,
  width: number,
): { before: Sample; after: Sample; crossing: CriticalValue[] } | null {
  const [before, after] = [sampleAt(family, value - width), sampleAt(family, value + width)];
  if (!before || !after) return null;
  const changes = before.unstable !== after.unstable;
  return {
    before,
    after,
    crossing: changes
      ? [{ value, eigenvalue: [0, 0], unstableBelow: before.unstable, unstableAbove: after.unstable }]
      : [],
  };
}

/** Samples between two, until neighbours are close. */
function between(family: Family, a: Sample, b: Sample, depth: number): Sample[] {
  if (depth === 0) return [];
  const reach = Math.max(...a.spectrum.map((x) => Math.hypot(...x)), ...b.spectrum.map((x) => Math.hypot(...x)));
  const match = assign(a.spectrum, b.spectrum);
  const stride = Math.max(...a.spectrum.map((x, i) => distance(x, b.spectrum[match[i]!]!)));
  if (!(stride > STRIDE * reach)) return [];
  const middle = sampleAt(family, 0.5 * (a.value + b.value));
  if (middle?.spectrum.length !== a.spectrum.length) return [];
  return [...between(family, a, middle, depth - 1), middle, ...between(family, middle, b, depth - 1)];
}

/** Spectra put in the order of branches: each continues where its last two entries point to. */
function track(spectra: readonly Complex[][]): Complex[][] {
  const branches = (spectra[0] ?? []).map((x) => [x]);
  for (let s = 1; s < spectra.length; s++) {
    const expected = branches.map((branch): Complex => {
      const [last, before] = [branch.at(-1)!, branch.at(-2)];
      return before ? [2 * last[0] - before[0], 2 * last[1] - before[1]] : last;
    });
    const match = assign(expected, spectra[s]!);
    branches.forEach((branch, i) => branch.push(spectra[s]![match[i]!]!));
  }
  return branches;
}

/**
 * The assignment of least total distance (H. W. Kuhn, "The Hungarian method for the assignment problem", Naval Research
 * Logistics Quarterly 2 (1955), 83-97), by shortest augmenting paths: entry i of the result is where `from[i]` goes.
 *
 * @param from as many as `to`
 * @param to as many as `from`
 */
export function assign(from: readonly Complex[], to: readonly Complex[]): number[] {
  const n = from.length;
  const [u, v] = [new Float64Array(n + 1), new Float64Array(n + 1)];
  // Column j is given to row owner[j]; 0 stands for none.
  const owner = new Int32Array(n + 1);
  for (let row = 1; row <= n; row++) {
    const way = new Int32Array(n + 1);
    const least = new Float64Array(n + 1).fill(Infinity);
    const done = new Uint8Array(n + 1);
    owner[0] = row;
    let column = 0;
    do {
      done[column] = 1;
      const i = owner[column]!;
      let [delta, next] = [Infinity, 0];
      for (let j = 1; j <= n; j++) {
        if (done[j]) continue;
        const cost = distance(from[i - 1]!, to[j - 1]!) - u[i]! - v[j]!;
        if (cost < least[j]!) {
          least[j] = cost;
          way[j] = column;
        }
        if (least[j]! < delta) [delta, next] = [least[j]!, j];
      }
      for (let j = 0; j <= n; j++) {
        if (done[j]) {
          u[owner[j]!]! += delta;
          v[j]! -= delta;
        } else least[j]! -= delta;
      }
      column = next;
    } while (owner[column] !== 0);
    for (; column !== 0; column = way[column]!) owner[column] = owner[way[column]!]!;
  }
  const result = Array<number>(n).fill(0);
  for (let j = 1; j <= n; j++) result[owner[j]! - 1] = j - 1;
  return result;
}

/** Every value between two samples at which the number of growing modes changes; closer than `width` they count as one. */
function crossings(family: Family, a: Sample, b: Sample, width: number): CriticalValue[] {
  if (a.unstable === b.unstable) return [];
  const middle = 0.5 * (a.value + b.value);
  // The number is decided a little off the axis: stop where that starts to matter, and finish on the real part itself.
  const m = b.value - a.value > width ? sampleAt(family, middle) : null;
  const through = m && isTouch(m, a, b) ? passing(family, m, width) : null;
  if (through)
    return [
      ...crossings(family, a, through.before, width),
      ...through.crossing,
      ...crossings(family, through.after, b, width),
    ];
  if (m) return [...crossings(family, a, m, width), ...crossings(family, m, b, width)];
  return [{ ...finish(family, a, b), unstableBelow: a.unstable, unstableAbove: b.unstable }];
}

/** The zero of the real part of the mode that begins to grow, by bisection around the narrow interval. */
function finish(family: Family, a: Sample, b: Sample): { value: number; eigenvalue: Complex } {
  const outside = a.unstable > b.unstable ? a : b;
  const growing = outside.spectrum.filter(([re]) => re > NEUTRAL * outside.size);
  const guide = growing.reduce((best, x) => (x[0] < best[0] ? x : best));
  const neutral = outside.spectrum.filter(isZero).length;
  /** The mode at a value; an exact zero where it has joined the neutral ones. */
  const modeAt = (value: number): Complex | null => {
    const A = family(value);
    if (!A) return null;
    if (guide[1] !== 0) return closest(plainEigenvalues(A), guide);
    const spectrum = eigenvalues(A);
    const moving = spectrum.filter((x) => !isZero(x));
    return spectrum.length - moving.length > neutral ? [0, 0] : closest(moving, guide);
  };
  const margin = b.value - a.value;
  let [low, high] = [a.value - margin, b.value + margin];
  const [atLow, atHigh] = [modeAt(low), modeAt(high)];
  let value = 0.5 * (a.value + b.value);
  const met = guide[1] === 0 ? throughZero(family, low, high, neutral) : null;
  if (met !== null) return { value: met, eigenvalue: [0, 0] };
  if (!atLow || !atHigh || atLow[0] * atHigh[0] >= 0) return { value, eigenvalue: [0, Math.abs(guide[1])] };
  let frequency = guide[1];
  for (let k = 0; k < MOST_BISECTIONS; k++) {
    value = 0.5 * (low + high);
    const here = value > low && value < high ? modeAt(value) : null;
    if (!here) break;
    frequency = here[1];
    if (here[0] === 0) break;
    if (here[0] > 0 === atLow[0] > 0) low = value;
    else high = value;
  }
  return { value, eigenvalue: [0, Math.abs(frequency)] };
}

/**
 * Where two real modes of opposite sign meet in zero and go on as an undamped oscillation, a disc that becomes fast enough to
 * stand: their squares cross zero straight, while the modes themselves do so as a root. Null where that is not what happens.
 */
function throughZero(family: Family, from: number, to: number, neutral: number): number | null {
  /** The square of the slowest mode that is not neutral on both sides. */
  const squareAt = (value: number): number | null => {
    const A = family(value);
    if (!A) return null;
    const spectrum = eigenvalues(A);
    const moving = spectrum.filter((x) => !isZero(x));
    if (spectrum.length - moving.length > neutral) return 0;
    const [re, im] = moving.reduce((best, x) => (Math.hypot(...x) < Math.hypot(...best) ? x : best));
    return re * im === 0 ? re * re - im * im : null;
  };
  let [low, high] = [from, to];
  const [atLow, atHigh] = [squareAt(low), squareAt(high)];
  if (atLow === null || atHigh === null || !(atLow * atHigh < 0)) return null;
  for (let k = 0; k < MOST_BISECTIONS; k++) {
    const value = 0.5 * (low + high);
    if (!(value > low && value < high)) break;
    const here = squareAt(value);
    if (here === null) return null;
    if (here === 0) return centreOf((x) => squareAt(x) === 0, value, low, high);
    if (here > 0 === atLow > 0) low = value;
    else high = value;
  }
  return 0.5 * (low + high);
}

/** The middle of where something holds around a value, between two at which it does not. */
function centreOf(holds: (value: number) => boolean, value: number, low: number, high: number): number {
  const edge = (inside: number, outside: number): number => {
    for (let k = 0; k < MOST_BISECTIONS / 2; k++) {
      const middle = 0.5 * (inside + outside);
      if (holds(middle)) inside = middle;
      else outside = middle;
    }
    return inside;
  };
  return 0.5 * (edge(value, low) + edge(value, high));
}

function isZero([re, im]: Complex): boolean {
  return re === 0 && im === 0;
}

function closest(spectrum: readonly Complex[], to: Complex): Complex {
  return spectrum.reduce((best, x) => (distance(x, to) < distance(best, to) ? x : best));
}
