/**
 * Steps of the module that `program.ts` writes: an attempt as EmbeddedRungeKutta makes it, and the loop of AdaptiveStepper with
 * the controller of stepControl.ts around it.
 */
import {
  BETA,
  GROW_MOST,
  LEAST_ERROR,
  SAFETY,
  SHRINK_MOST,
  SMALLEST_ULPS,
  STRETCH,
  STEP_ROUNDING,
  piExponent,
} from '../integrators/shared/stepControl.ts';
import {
  branchIf,
  call,
  f64,
  F64,
  f64x2,
  F64X2,
  forever,
  get,
  giveBack,
  i32,
  I32,
  set,
  when,
  type Code,
  type Func,
  type Module,
} from './assembler.ts';
import { BYTES, each, eachPair, evaluate, load, slopeOf, TOLD, weighted, y1Of, type Parts } from './layout.ts';

/**
 * attempt(step, t, h, rtol, atol, projecting): scaled error of a step from its y0 and k_1; NaN where it has none.
 *
 * @param module that it becomes part of
 * @param parts what the module consists of so far
 * @param project as `projectionOf` writes it
 */
export function writeAttempt(module: Module, parts: Parts, project: Func): Func {
  const { kind } = parts;
  const N = 2 * kind.n;
  const y1 = y1Of(kind);
  const attempt = module.func([I32, F64, F64, F64, F64, I32], [F64]);
  const [step, t, h, rtol, atol, projecting] = [0, 1, 2, 3, 4, 5] as const;
  const p = attempt.local(I32);
  const squares = attempt.local();
  const lower = attempt.local();
  const scale = attempt.local();
  const r = attempt.local();
  const none = giveBack(f64.const(NaN));
  const { stages, c, A, error, lowOrderError } = kind.tableau;
  const both = attempt.local(F64X2);
  const body: Code[] = [set(both, f64x2.splat(get(h)))];
  for (let s = 1; s <= stages; s++) {
    body.push(
      eachPair(
        p,
        get(step),
        N,
        f64x2.store(get(p), y1, f64x2.add(f64x2.load(get(p)), f64x2.mul(get(both), weighted(kind, A[s]!, p, f64x2)))),
      ),
    );
    if (s < stages)
      body.push(
        evaluate(
          parts,
          f64.add(get(t), f64.mul(f64.const(c[s]!), get(h))),
          i32.add(get(step), i32.const(y1)),
          i32.add(get(step), i32.const(slopeOf(kind, s))),
          none,
        ),
      );
  }
  const end: Code = [
    when(get(projecting), when(i32.eqz(call(project, i32.add(get(step), i32.const(y1)))), none)),
    evaluate(
      parts,
      f64.add(get(t), get(h)),
      i32.add(get(step), i32.const(y1)),
      i32.add(get(step), i32.const(slopeOf(kind, stages))),
      none,
    ),
  ];
  const scaleHere = set(
    scale,
    f64.add(get(atol), f64.mul(get(rtol), f64.max(f64.abs(f64.load(get(p))), f64.abs(f64.load(get(p), y1))))),
  );
  const norm: Code = lowOrderError
    ? [
        set(squares, f64.const(0)),
        set(lower, f64.const(0)),
        each(p, get(step), N, [
          scaleHere,
          set(r, f64.div(weighted(kind, error, p), get(scale))),
          set(squares, f64.add(get(squares), f64.mul(get(r), get(r)))),
          set(r, f64.div(weighted(kind, lowOrderError, p), get(scale))),
          set(lower, f64.add(get(lower), f64.mul(get(r), get(r)))),
        ]),
        when(
          i32.and(f64.eq(get(squares), f64.const(0)), f64.eq(get(lower), f64.const(0))),
          set(r, f64.const(0)),
          set(
            r,
            f64.div(
              f64.mul(get(h), get(squares)),
              f64.sqrt(f64.mul(f64.add(get(squares), f64.mul(f64.const(0.01), get(lower))), f64.const(N))),
            ),
          ),
        ),
      ]
    : [
        set(squares, f64.const(0)),
        each(p, get(step), N, [
          scaleHere,
          set(r, f64.div(f64.mul(get(h), weighted(kind, error, p)), get(scale))),
          set(squares, f64.add(get(squares), f64.mul(get(r), get(r)))),
        ]),
        set(r, f64.sqrt(f64.div(get(squares), f64.const(N)))),
      ];
  attempt.body = [body, error.length > stages ? [end, norm] : [norm, when(f64.le(get(r), f64.const(1)), end)], get(r)];
  return attempt;
}

/**
 * steps(place, count, t, h, error, limit, most, rtol, atol, projecting): at most `count` steps, the first from y0 and k_1 of
 * this place, each next one in the place after it.
 *
 * A step that does not come about for any reason ends it, and leaves the one before as the last: TypeScript goes on from there,
 * in the same way, and says what was the matter.
 *
 * @param module that it becomes part of
 * @param parts what the module consists of so far
 * @param attempt as `writeAttempt` writes it
 * @param pow the host's
 */
export function writeSteps(module: Module, parts: Parts, attempt: Func, pow: Func): void {
  const { kind, layout } = parts;
  const { stages, order } = kind.tableau;
  const steps = module.func([I32, I32, F64, F64, F64, F64, F64, F64, F64, I32], [I32], 'steps');
  const [place, count, t, h, lastError, limit, most, rtol, atol, projecting] = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9] as const;
  const [made, p] = [steps.local(I32), steps.local(I32)] as const;
  const [left, smallest, step, end, error, factor, rejected] = Array.from({ length: 7 }, () => steps.local()) as [
    number,
    number,
    number,
    number,
    number,
    number,
    number,
  ];
  const { add, mul, min, max, abs, gt, ge, le, lt } = f64;
  const c = f64.const;
  const exponent = piExponent(order);
  const y0 = i32.add(get(place), i32.const(TOLD.count * BYTES));
  const leave = giveBack(get(made));
  /** As `stepWithin`. */
  const within: Code = [
    set(step, min(get(h), get(most))),
    when(
      i32.and(ge(mul(c(STRETCH), get(step)), get(left)), le(get(left), mul(c(STEP_ROUNDING), get(most)))),
      set(step, get(left)),
      when(gt(mul(c(2), get(step)), get(left)), set(step, f64.div(get(left), c(2)))),
    ),
    when(f64.eq(get(step), get(left)), set(end, get(limit)), set(end, add(get(t), get(step)))),
  ];
  const shorter: Code = [
    set(rejected, add(get(rejected), c(1))),
    set(factor, max(c(SHRINK_MOST), mul(c(SAFETY), call(pow, get(error), c(-exponent))))),
    set(h, mul(get(step), get(factor))),
    when(i32.eqz(gt(get(h), get(smallest))), leave),
  ];
  const next: Code = [
    when(
      gt(get(error), c(0)),
      set(factor, mul(mul(c(SAFETY), call(pow, get(error), c(-exponent))), call(pow, get(lastError), c(BETA)))),
      set(factor, c(GROW_MOST)),
    ),
    set(factor, max(c(SHRINK_MOST), get(factor))),
    when(gt(get(rejected), c(0)), set(factor, min(c(1), get(factor))), set(factor, min(c(GROW_MOST), get(factor)))),
    set(lastError, max(get(error), c(LEAST_ERROR))),
    set(factor, mul(get(step), get(factor))),
    when(lt(get(step), get(h)), set(h, max(get(h), get(factor))), set(h, get(factor))),
  ];
  const tell = (what: keyof typeof TOLD, value: Code): Code => f64.store(get(place), TOLD[what] * BYTES, value);
  steps.body = [
    forever([
      branchIf(1, i32.ge(get(made), get(count))),
      set(left, f64.sub(get(limit), get(t))),
      branchIf(1, i32.eqz(gt(get(left), c(0)))),
      set(smallest, mul(c(SMALLEST_ULPS * Number.EPSILON), max(abs(get(t)), abs(get(left))))),
      set(rejected, c(0)),
      forever([
        within,
        when(i32.eqz(gt(get(end), get(t))), leave),
        set(error, call(attempt, y0, get(t), get(step), get(rtol), get(atol), get(projecting))),
        branchIf(1, le(get(error), c(1))),
        when(f64.ne(get(error), get(error)), leave),
        shorter,
      ]),
      next,
      set(t, get(end)),
      tell('end', get(t)),
      tell('taken', get(step)),
      tell('next', get(h)),
      tell('error', get(lastError)),
      tell('rejected', get(rejected)),
      tell('factor', load(layout.factors + kind.set.factors.length - 1)),
      set(made, i32.add(get(made), i32.const(1))),
      branchIf(1, i32.ge(get(made), get(count))),
      eachPair(p, y0, 2 * kind.n, [
        f64x2.store(get(p), layout.place * BYTES, f64x2.load(get(p), y1Of(kind))),
        f64x2.store(get(p), layout.place * BYTES + slopeOf(kind, 0), f64x2.load(get(p), slopeOf(kind, stages))),
      ]),
      set(place, i32.add(get(place), i32.const(layout.place * BYTES))),
    ]),
    get(made),
  ];
}
