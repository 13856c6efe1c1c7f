/**
 * Exact Jacobians of a tape by forward sweeps over it, one for each variable (A. Griewank, A. Walther, Evaluating Derivatives,
 * 2nd ed., SIAM 2008, section 3.1): for functions whose derivatives as a graph of their own would be too long.
 */
import { code } from './graph.ts';
import { evaluateOne, type Call, type Program } from './program.ts';
import { logarithm, power } from '../elementary/powers.ts';

/**
 * A function like the program's that writes, for every output array and each of some input arrays, the derivatives row by row:
 * (outputs x variables), in the order of `by` and within it of the outputs.
 *
 * @param program that is differentiated
 * @param by numbers of the input arrays
 */
export function tangentsOf(program: Program, by: readonly number[]): Call {
  const { tape, memory, inputs, places } = program;
  const rate = new Float64Array(memory.length);
  const starts = inputs.map((_, k) => inputs.slice(0, k).reduce((sum, ids) => sum + ids.length, 0));
  return (...arrays) => {
    inputs.forEach((_, k) => memory.set(arrays[k]!, starts[k]));
    for (let k = 0; k < tape.length; k += 5) memory[tape[k + 1]!] = evaluateOne(tape, k, memory);
    let out = inputs.length;
    for (const input of by) {
      const count = inputs[input]!.length;
      const into = places.map(() => arrays[out++]!);
      for (let c = 0; c < count; c++) {
        rate.fill(0);
        rate[starts[input]! + c] = 1;
        sweep(tape, memory, rate);
        places.forEach((place, r) => {
          for (let i = 0; i < place.length; i++) into[r]![i * count + c] = rate[place[i]!]!;
        });
      }
    }
  };
}

function sweep(tape: Int32Array, m: Float64Array, d: Float64Array): void {
  for (let k = 0; k < tape.length; k += 5) {
    const [to, i, j] = [tape[k + 1]!, tape[k + 2]!, tape[k + 3]!];
    let x: number;
    switch (tape[k]) {
      case code.add:
        x = d[i]! + d[j]!;
        break;
      case code.sub:
        x = d[i]! - d[j]!;
        break;
      case code.mul:
        x = limited(d[i]!, m[j]!) + limited(m[i]!, d[j]!);
        break;
      case code.div:
        x = (d[i]! - limited(m[to]!, d[j]!)) / m[j]!;
        break;
      case code.neg:
        x = -d[i]!;
        break;
      case code.select:
        x = m[i] !== 0 ? d[j]! : d[tape[k + 4]!]!;
        break;
      default:
        x = d[i] === 0 && d[j] === 0 ? 0 : seldom(tape[k]!, m[i]!, m[j]!, m[to]!, d[i]!, d[j]!);
    }
    d[to] = x;
  }
}

/** A slope of 0 times a rate without bound: what is made of an exponential beyond doubles is at its limit (`graph.ts`). */
const limited = (x: number, y: number): number => (x === 0 || y === 0 ? 0 : x * y);

/** Of functions: x and y their operands, f the value, dx and dy the rates. */
function seldom(op: number, x: number, y: number, f: number, dx: number, dy: number): number {
  switch (op) {
    case code.sqrt:
      return (0.5 * dx) / f;
    case code.sin:
      return limited(Math.cos(x), dx);
    case code.cos:
      return -Math.sin(x) * dx;
    case code.asin:
      return dx / Math.sqrt(1 - x * x);
    case code.acos:
      return -dx / Math.sqrt(1 - x * x);
    case code.atan:
      return limited(1 / (1 + x * x), dx);
    case code.sinh:
      return limited(Math.cosh(x), dx);
    case code.cosh:
      return limited(Math.sinh(x), dx);
    case code.tanh:
      return limited(1 - f * f, dx);
    case code.exp:
      return limited(f, dx);
    case code.log:
      return dx / x;
    case code.log10:
      return dx / x / Math.LN10;
    case code.log2:
      return dx / x / Math.LN2;
    case code.cbrt:
      return dx / (3 * f * f);
    case code.abs:
      return x < 0 ? -dx : dx;
    case code.atan2:
      return (y * dx - x * dy) / (x * x + y * y);
    case code.pow:
      return limited(y * power(x, y - 1), dx) + (dy === 0 ? 0 : f * logarithm(x) * dy);
    default:
      return 0;
  }
}
