/**
 * Functions of one argument, and how a rate of change goes through each. Rates are multiplied and divided in an order
 * that neither overflows nor vanishes where the result is a number: dx / x / (x + 1/x) is the rate of atan(x) also where
 * x^2 is beyond doubles.
 */
import { exponential, logarithm } from '../../elementary/powers.ts';
import { cosine, sine } from '../../elementary/trigonometry.ts';

export interface SmoothFunction {
  f(x: number): number;
  /** d/dt f(x) from x, dx/dt and f(x); not asked where dx/dt is 0. */
  rate(x: number, dx: number, fx: number): number;
}

/** Up to here the engine's own sine and cosine are right to 1 ulp; beyond, the host's. */
const FARTHEST = 2 ** 20 * (Math.PI / 2);
const sin = (x: number): number => (Math.abs(x) <= FARTHEST ? sine(x) : Math.sin(x));
const cos = (x: number): number => (Math.abs(x) <= FARTHEST ? cosine(x) : Math.cos(x));
const log: SmoothFunction = { f: logarithm, rate: (x, dx) => dx / x };
const overCosh = (x: number, dx: number): number => dx / Math.cosh(x) / Math.cosh(x);

export const smooth: ReadonlyMap<string, SmoothFunction> = new Map([
  ['sin', { f: sin, rate: (x, dx) => cos(x) * dx }],
  ['cos', { f: cos, rate: (x, dx) => -sin(x) * dx }],
  ['tan', { f: Math.tan, rate: (x, dx) => dx / Math.cos(x) / Math.cos(x) }],
  ['asin', { f: Math.asin, rate: (x, dx) => dx / Math.sqrt((1 - x) * (1 + x)) }],
  ['acos', { f: Math.acos, rate: (x, dx) => -dx / Math.sqrt((1 - x) * (1 + x)) }],
  ['atan', { f: Math.atan, rate: (x, dx) => (Math.abs(x) > 1 ? dx / x / (x + 1 / x) : dx / (1 + x * x)) }],
  ['sinh', { f: Math.sinh, rate: (x, dx) => Math.cosh(x) * dx }],
  ['cosh', { f: Math.cosh, rate: (x, dx) => Math.sinh(x) * dx }],
  ['tanh', { f: Math.tanh, rate: overCosh }],
  ['exp', { f: exponential, rate: (_x, dx, fx) => fx * dx }],
  ['log', log],
  ['ln', log],
  ['log10', { f: Math.log10, rate: (x, dx) => dx / x / Math.LN10 }],
  ['log2', { f: Math.log2, rate: (x, dx) => dx / x / Math.LN2 }],
  ['sqrt', { f: Math.sqrt, rate: (_x, dx, fx) => (0.5 * dx) / fx }],
  ['cbrt', { f: Math.cbrt, rate: (_x, dx, fx) => dx / fx / fx / 3 }],
]);

/** Functions of one argument; of the last five see `decide` in `tree.ts`. */
export const unary: ReadonlySet<string> = new Set([...smooth.keys(), 'abs', 'sign', 'floor', 'ceil', 'round']);

/** Functions of several arguments: how many they take. More than two are taken two by two from the left. */
export const several: ReadonlyMap<string, readonly [fewest: number, most: number]> = new Map([
  ['atan2', [2, 2]],
  ['pow', [2, 2]],
  ['mod', [2, 2]],
  ['hypot', [2, 16]],
  ['min', [1, 16]],
  ['max', [1, 16]],
]);

export const operators: readonly string[] = ['+', '-', '*', '/', '^', '<', '>', '<=', '>=', '==', '!='];
