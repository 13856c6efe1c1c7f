import type { Op } from '../model/tape.ts';
import { F64, type Func, type Module } from './assembler.ts';
import { exponential, logarithm, power } from '../elementary/powers.ts';

/** Of WebAssembly's JavaScript interface, what is used: neither page nor process is presupposed here. */
const host = (
  globalThis as {
    WebAssembly?: {
      Module: new (bytes: Uint8Array<ArrayBuffer>) => object;
      Instance: new (module: object, imports: object) => { exports: unknown };
    };
  }
).WebAssembly;

let may: boolean | undefined;

/** Whether this host compiles WebAssembly: a page's policy may refuse it, and so may a host that has none. */
export function compiles(): boolean {
  if (may !== undefined) return may;
  try {
    may = host !== undefined && new host.Module(PROBE) !== null;
  } catch {
    may = false;
  }
  return may;
}

/** The smallest module there is: whether any may be compiled. */
const PROBE = Uint8Array.of(0x00, 0x61, 0x73, 0x6d, 0x01, 0x00, 0x00, 0x00);

/**
 * The exports of a module, which finds HOST_FUNCTIONS.
 *
 * @param bytes of the module
 * @param functions that it imports besides them
 */
export function instantiate(bytes: Uint8Array<ArrayBuffer>, functions: object = {}): unknown {
  return new host!.Instance(new host!.Module(bytes), { host: { ...HOST_FUNCTIONS, ...functions } }).exports;
}

/** Functions of one number that WebAssembly has no instruction for, by the names of operations on a tape. */
export const HOST_FUNCTIONS_OF_ONE = {
  asin: Math.asin,
  acos: Math.acos,
  atan: Math.atan,
  sinh: Math.sinh,
  cosh: Math.cosh,
  tanh: Math.tanh,
  exp: exponential,
  log: logarithm,
  log10: Math.log10,
  log2: Math.log2,
  cbrt: Math.cbrt,
} as const;

/** Those, and those of two numbers. */
export const HOST_FUNCTIONS: Readonly<Record<string, (x: number, y: number) => number>> = {
  ...HOST_FUNCTIONS_OF_ONE,
  atan2: Math.atan2,
  pow: power,
};

/**
 * Imports of those that a tape's operations ask for, by name. They come before the module's own functions.
 *
 * @param module that it becomes part of
 * @param ops the tape's operations
 */
export function importsFor(module: Module, ops: readonly Op[]): ReadonlyMap<string, Func> {
  const imports = new Map<string, Func>();
  for (const [kind, , second] of ops)
    if (HOST_FUNCTIONS[kind] && !imports.has(kind))
      imports.set(kind, module.imported(kind, second === undefined ? [F64] : [F64, F64], [F64]));
  return imports;
}
