/**
 * Steps of an embedded Runge-Kutta pair as one WebAssembly module: slopes, error norm, projection on the constraints, the choice
 * of the next step and dense output, operation by operation as EmbeddedRungeKutta, AdaptiveStepper, DirectAccelerations and
 * Projection do it, so that both give the same bits. Where anything has no value the module says so, and they do it over.
 */
import { F64, I32, Module } from './assembler.ts';
import { importsFor } from './host.ts';
import { BYTES, layoutOf, type Kind, type Parts } from './layout.ts';
import { writeDense, writeInterpolate } from './writeDense.ts';
import { accelerationsOf, projectionOf } from './writeMechanics.ts';
import { writeAttempt, writeSteps } from './writeSteps.ts';

/**
 * The module. It imports the functions of `host.ts` that it calls, and `host.force(t, y)` where forces act, and exports
 *
 *     accelerations(y, rate) -> 1 or 0                  at a state at an address, [v, a] to another
 *     project(y) -> 1 or 0                              a state at an address onto the constraints, in place
 *     steps(place, count, …) -> how many                steps from the y0 and k_1 of a place on (writeSteps.ts)
 *     makeDense(step, t, h) -> 1 or 0                   coefficients of a step's dense output
 *     interpolate(step, s)                              at a fraction of it, into `sample`
 *
 * @param kind tape, constraint set, method and number of coordinates
 */
export function writeProgram(kind: Kind): Uint8Array<ArrayBuffer> {
  const layout = layoutOf(kind);
  const module = new Module();
  const functions = importsFor(module, [...kind.tape.ops, ['pow', 0, 0]]);
  const force = kind.forced ? module.imported('force', [F64, I32], []) : null;
  const accelerations = accelerationsOf(module, kind, layout, functions);
  const parts: Parts = { kind, layout, accelerations, force };
  const attempt = writeAttempt(module, parts, projectionOf(module, kind, layout, functions, accelerations));
  writeSteps(module, parts, attempt, functions.get('pow')!);
  writeDense(module, parts);
  writeInterpolate(module, parts);
  return module.bytes(layout.size * BYTES);
}
