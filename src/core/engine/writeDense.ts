/**
 * Dense output of the module that `program.ts` writes, as EmbeddedRungeKutta makes it (shared/interpolation.ts).
 */
import { HERMITE_TERMS } from '../integrators/shared/interpolation.ts';
import { f64, F64, f64x2, F64X2, get, giveBack, i32, I32, set, type Code, type Module } from './assembler.ts';
import { BYTES, eachPair, evaluate, slopeOf, weighted, y1Of, type Parts } from './layout.ts';

/**
 * makeDense(step, t, h): coefficients of a step from its y0 and slopes; 0 where an extra stage has no value.
 *
 * @param module that it becomes part of
 * @param parts what the module consists of so far
 */
export function writeDense(module: Module, parts: Parts): void {
  const { kind, layout } = parts;
  const N = 2 * kind.n;
  const y1 = y1Of(kind);
  const makeDense = module.func([I32, F64, F64], [I32], 'makeDense');
  const [step, t, h] = [0, 1, 2] as const;
  const p = makeDense.local(I32);
  const o = makeDense.local(I32);
  const difference = makeDense.local(F64X2);
  const curvature = makeDense.local(F64X2);
  const both = makeDense.local(F64X2);
  const { stages, c, A, dense } = kind.tableau;
  const coefficient = (k: number): number => (layout.dense + k * N) * BYTES;
  const giveUp = giveBack(i32.const(0));
  makeDense.body = [
    set(both, f64x2.splat(get(h))),
    set(o, i32.const(0)),
    eachPair(p, get(step), N, [
      set(difference, f64x2.sub(f64x2.load(get(p), y1), f64x2.load(get(p)))),
      set(curvature, f64x2.sub(f64x2.mul(get(both), f64x2.load(get(p), slopeOf(kind, 0))), get(difference))),
      f64x2.store(get(o), coefficient(0), get(difference)),
      f64x2.store(get(o), coefficient(1), get(curvature)),
      f64x2.store(
        get(o),
        coefficient(2),
        f64x2.sub(
          f64x2.sub(get(difference), f64x2.mul(get(both), f64x2.load(get(p), slopeOf(kind, stages)))),
          get(curvature),
        ),
      ),
      set(o, i32.add(get(o), i32.const(2 * BYTES))),
    ]),
    A.slice(stages + 1).map((row, k) => {
      const s = stages + 1 + k;
      const sample = layout.sample * BYTES;
      return [
        set(o, i32.const(0)),
        eachPair(p, get(step), N, [
          f64x2.store(
            get(o),
            sample,
            f64x2.add(f64x2.load(get(p)), f64x2.mul(get(both), weighted(kind, row, p, f64x2))),
          ),
          set(o, i32.add(get(o), i32.const(2 * BYTES))),
        ]),
        evaluate(
          parts,
          f64.add(get(t), f64.mul(f64.const(c[s]!), get(h))),
          i32.const(sample),
          i32.add(get(step), i32.const(slopeOf(kind, s))),
          giveUp,
        ),
      ];
    }),
    dense.length > 0 ? set(o, i32.const(0)) : [],
    dense.length > 0
      ? eachPair(p, get(step), N, [
          dense.map((weights, k) =>
            f64x2.store(
              get(o),
              coefficient(HERMITE_TERMS + k),
              f64x2.mul(weighted(kind, weights, p, f64x2), get(both)),
            ),
          ),
          set(o, i32.add(get(o), i32.const(2 * BYTES))),
        ])
      : [],
    i32.const(1),
  ];
}

/**
 * interpolate(step, s): the state at a fraction of a step into `sample`.
 *
 * @param module that it becomes part of
 */
export function writeInterpolate(module: Module, { kind, layout }: Parts): void {
  const N = 2 * kind.n;
  const interpolate = module.func([I32, F64], [], 'interpolate');
  const [step, s] = [0, 1] as const;
  const p = interpolate.local(I32);
  const o = interpolate.local(I32);
  const along = interpolate.local(F64X2);
  const rest = interpolate.local(F64X2);
  const terms = HERMITE_TERMS + kind.tableau.dense.length;
  const coefficient = (k: number): Code => f64x2.load(get(o), (layout.dense + k * N) * BYTES);
  const nested = Array.from({ length: terms - 1 }, (_, k) => k).reduceRight<Code>(
    (total, k) => f64x2.add(coefficient(k), f64x2.mul(get(k % 2 === 0 ? rest : along), total)),
    coefficient(terms - 1),
  );
  interpolate.body = [
    set(along, f64x2.splat(get(s))),
    set(rest, f64x2.splat(f64.sub(f64.const(1), get(s)))),
    set(o, i32.const(0)),
    eachPair(p, get(step), N, [
      f64x2.store(get(o), layout.sample * BYTES, f64x2.add(f64x2.load(get(p)), f64x2.mul(get(along), nested))),
      set(o, i32.add(get(o), i32.const(2 * BYTES))),
    ]),
  ];
}
