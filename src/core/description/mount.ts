/** A model as what the rest of the program takes: a view at once, a system when its equations are derived. */
import type { ConstraintSet, ConstraintSetMeta, ContactMeta, System, SystemMeta, SystemView } from '../model/system.ts';
import { checkEquations, solvedFor } from './checks.ts';
import { timeFormulas } from './timeFormulas.ts';
import { energiesOf, equationsOf, jacobianOf, outsidePowerOf, type Equations } from './derive.ts';
import { directOf } from './direct.ts';
import { meshOf } from './drawing.ts';
import { MOST_NODES, type Id } from './graph.ts';
import type { Model, SetModel } from './model.ts';
import { needed, Program, type Arrays, type Call } from './program.ts';
import { tangentsOf } from './tangents.ts';

/** Operations times variables up to which Jacobians are a graph of their own. */
const MOST_WORK = 250_000;

/**
 * What the page needs of a description to show a motion of it.
 *
 * @param model what was read of a description
 * @param id of the system, unique to its text
 * @throws DescriptionError
 * @param text of the description
 */
export function viewOf(model: Model, id: string, text: string): SystemView {
  const poses = new Program(model.graph, { q: model.q, p: model.p }, { out: posesOf(model) }).interpreted();
  return {
    meta: { ...metaOf(model, id), description: text },
    poses: (q, p, out) => poses(q, p, out),
    contacts: [],
    tracks: model.tracks.map(({ body }) => ({ body, role: model.bodies[body]!.role ?? 'neutral' })),
  };
}

function posesOf({ bodies }: Model): Id[] {
  return bodies.flatMap(({ origin, frame }) => [...origin, ...frame.R]);
}

function metaOf(model: Model, id: string): SystemMeta {
  return {
    id,
    title: model.title,
    ...(model.mechanical ? {} : { order: 1 as const }),
    coordinates: model.coordinates,
    ...(model.clock === null ? {} : { clock: model.coordinates[model.clock]!.name }),
    parameters: model.parameters,
    parameterSets: model.presets,
    constraintSets: model.sets.map((set) => setMeta(model, set)),
    inputs: model.inputs,
    ...(model.speed
      ? { speed: { name: 'speed', label: 'forward speed', along: model.speed.along, heading: model.speed.heading } }
      : {}),
    ...(model.forward ? { forward: model.forward } : {}),
    bodies: model.bodies.map((body, k) => {
      const mesh = meshOf(model, k);
      return {
        id: body.id,
        label: body.label,
        role: body.role ?? 'neutral',
        ...(mesh === null ? {} : { model: mesh }),
      };
    }),
    ...(model.loss === model.graph.zero ? {} : { losses: true as const }),
    ...(model.held.length > 0 ? { held: model.held } : {}),
    ...(model.shown.length > 0 ? { shown: model.shown } : {}),
    ...(model.events.length > 0
      ? { events: model.events.map((event) => ({ id: event.id, label: event.label, sets: event.sets })) }
      : {}),
  };
}

function setMeta(model: Model, set: SetModel): ConstraintSetMeta {
  const { id, label, rows } = set;
  if (rows.length === 0) return { id, label };
  const heights = rows.flatMap(({ height }, k) => (height === null ? [] : [k]));
  return {
    id,
    label,
    rows: rows.length,
    ...(heights.length > 0
      ? {
          contact: {
            rows: heights,
            solveFor: solvedFor(model, set).map((i) => model.coordinates[i]!.name),
            points: heights.map((k) => rows[k]!.label || `the height of line ${rows[k]!.line}`).join(' and '),
          },
        }
      : {}),
  };
}

export interface DeriveOptions {
  /** Told of every part; may stop the work by throwing. */
  step?: (done: number, of: number) => void;
}

/**
 * The system of a model: everything that the mechanics take.
 *
 * @param model what was read of a description
 * @param view what the page shows of the model
 * @throws DescriptionError that names the line of what makes it no system; GrowthError where it is too large
 */
export function systemOf(model: Model, view: SystemView, { step }: DeriveOptions = {}): System {
  const { graph, q, v, p } = model;
  const at = { q, v, p };
  graph.most = MOST_NODES;
  if (!model.mechanical) return firstOrderSystem(model, view);
  const equations = equationsOf(model, step);
  checkEquations(model, equations);
  const { M, h } = equations;
  const mechanics = lazy(model, () => [at, { M, h }]);
  const a = Array.from(q, () => graph.input());
  const jacobians = slopes(model, { q, v, a, p }, () => {
    const of = residualOf(model, equations, a);
    return [
      { of, by: 'q' },
      { of, by: 'v' },
    ];
  });
  const energy = lazy(model, () => [at, { out: energiesOf(model) }]);
  const poseJacobian = slopes(model, { q, p }, () => [{ of: posesOf(model), by: 'q' }]);
  return {
    ...view,
    mechanics: (...all) => mechanics(...all),
    jacobians: (...all) => jacobians(...all),
    energy: (...all) => energy(...all),
    poseJacobian: (...all) => poseJacobian(...all),
    constraintSets: Object.fromEntries(
      equations.sets.map((set, k) => [set.id, constraintSet(model, view.meta, equations, k, a)]),
    ),
    ...(model.clock === null ? {} : { clock: model.clock, timeFormulas: timeFormulas(model, resultsOf(equations)) }),
    ...outsidePower(model, a),
    ...crossings(model),
  };
}

function outsidePower(model: Model, a: readonly Id[]): Pick<System, 'outsidePower'> {
  if (model.clock === null && !model.forces.some((force) => force !== undefined && force !== model.graph.zero))
    return {};
  const { q, v, p } = model;
  const power = lazy(model, () => [{ q, v, a, p }, { out: [outsidePowerOf(model, a) ?? model.graph.zero] }]);
  const out = new Float64Array(1);
  return {
    outsidePower(...state) {
      power(...state, out);
      return out[0]!;
    },
  };
}

/** All that the equations of every constraint set are computed from. */
const resultsOf = ({ M, h, sets }: Equations): Id[] =>
  [M, h, ...sets.flatMap(({ omega, gamma }) => [omega, gamma])].flat();

/** A function that is derived when it is first called. */
function lazy(model: Model, make: () => [inputs: Arrays, outputs: Arrays]): Call {
  let call: Call | null = null;
  return (...arrays) => {
    call ??= new Program(model.graph, ...make()).tiered();
    call(...arrays);
  };
}

function residualOf({ graph, q }: Model, { M, h }: Equations, a: readonly Id[]): Id[] {
  const n = q.length;
  return h.map((x, i) => graph.sub(graph.sum(a.map((aj, j) => graph.mul(M[i * n + j]!, aj))), x));
}

/**
 * Derivatives of results by some of the inputs, row by row: as a graph of their own, compiled like any other function, or by
 * sweeps over the tape of the results where that graph would be too long.
 */
function slopes(
  model: Model,
  inputs: Arrays,
  parts: () => readonly { of: readonly Id[]; by: string }[],
): (...arrays: Float64Array[]) => void {
  const { graph } = model;
  let calls: { call: Call; outputs: number }[] | null = null;
  const names = Object.keys(inputs);
  const make = (): NonNullable<typeof calls> => {
    const all = parts();
    const given = new Map(Object.values(inputs).flatMap((ids) => ids.map((id) => [id, true])));
    const work = all.map(({ of, by }) => needed(graph, of, given).length * inputs[by]!.length);
    if (work.reduce((sum, x) => sum + x, 0) > MOST_WORK)
      return all.map(({ of, by }) => ({
        call: tangentsOf(new Program(graph, inputs, { of }), [names.indexOf(by)]),
        outputs: 1,
      }));
    graph.work = 'the Jacobians';
    const made = Object.fromEntries(all.map(({ of, by }, k) => [k, jacobianOf(graph, of, inputs[by]!)]));
    return [{ call: new Program(graph, inputs, made).tiered(), outputs: all.length }];
  };
  return (...arrays) => {
    calls ??= make();
    let out = names.length;
    for (const { call, outputs } of calls) {
      call(...arrays.slice(0, names.length), ...arrays.slice(out, out + outputs));
      out += outputs;
    }
  };
}

function constraintSet(
  model: Model,
  meta: SystemMeta,
  equations: Equations,
  k: number,
  a: readonly Id[],
): ConstraintSet {
  const { graph, q, v, p } = model;
  const { id, rows, omega, gamma } = equations.sets[k]!;
  const m = rows.length;
  const at = { q, v, p };
  const evaluate = lazy(model, () => [at, { omega, gamma }]);
  const dynamics = lazy(model, () => [at, { M: equations.M, h: equations.h, omega, gamma }]);
  const lambda = Array.from({ length: m }, () => graph.input());
  const n = q.length;
  const jacobians = slopes(model, { q, v, a, lambda, p }, () => {
    const force = q.map((_, i) => graph.sum(lambda.map((l, r) => graph.mul(l, omega[r * n + i]!))));
    const rate = gamma.map((g, r) => graph.add(g, graph.sum(a.map((x, i) => graph.mul(omega[r * n + i]!, x)))));
    return [
      { of: force, by: 'q' },
      { of: rate, by: 'q' },
      { of: rate, by: 'v' },
      { of: rows.map((row) => row.velocity), by: 'q' },
    ];
  });
  const { contact } = meta.constraintSets.find((set) => set.id === id)!;
  const heights = lazy(model, () => [
    { q, p },
    { out: rows.flatMap(({ height }) => (height === null ? [] : [height])) },
  ]);
  return {
    id,
    rows: m,
    evaluate: (...all) => evaluate(...all),
    dynamics: (...all) => dynamics(...all),
    jacobians: (...all) => jacobians(...all),
    contact: contact
      ? ({ ...contact, count: contact.rows.length, heights: (...all) => heights(...all) } satisfies ContactMeta & {
          points: string;
        })
      : null,
    ...directOf(model, equations, k),
  };
}

function firstOrderSystem(model: Model, view: SystemView): System {
  const { graph, q, v, p } = model;
  const n = q.length;
  const f = q.map((_, i) => model.rates.get(i)!.value);
  const rate = lazy(model, () => [{ q, p }, { out: f }]);
  const jacobian = lazy(model, () => [{ q, p }, { out: jacobianOf(graph, f, q) }]);
  const unit = Array.from({ length: n * n }, (_, k) => (k % (n + 1) === 0 ? graph.one : graph.zero));
  const h = (): Id[] => graph.forward(f, new Map(q.map((id, i) => [id, v[i]!])));
  const mechanics = lazy(model, () => [
    { q, v, p },
    { M: unit, h: h() },
  ]);
  const jacobians = lazy(model, () => {
    const residual = h().map((x) => graph.neg(x));
    return [
      { q, v, p },
      { dq: jacobianOf(graph, residual, q), dv: jacobianOf(graph, residual, v) },
    ];
  });
  const poseJacobian = slopes(model, { q, p }, () => [{ of: posesOf(model), by: 'q' }]);
  return {
    ...view,
    mechanics: (...all) => mechanics(...all),
    jacobians: (qs, vs, _a, ps, dq, dv) => jacobians(qs, vs, ps, dq, dv),
    energy: (_q, _v, _p, out) => void out.fill(0),
    poseJacobian: (...all) => poseJacobian(...all),
    constraintSets: {},
    firstOrder: { rate: (...all) => rate(...all), jacobian: (...all) => jacobian(...all) },
    ...(model.clock === null ? {} : { timeFormulas: timeFormulas(model, f) }),
    ...crossings(model),
  };
}

/** What ends a run by falling through zero. */
function crossings(model: Model): Pick<System, 'crossings'> {
  if (model.events.length === 0) return {};
  const { q, v, p, events } = model;
  const values = lazy(model, () => [{ q, v, p }, { out: events.map(({ value }) => value) }]);
  const out = new Float64Array(events.length);
  return {
    crossings: events.map(({ id, label, sets }, k) => ({
      id,
      label,
      sets,
      value(...state) {
        values(...state, out);
        return out[k]!;
      },
    })),
  };
}
