import type { CoordinateMeta, InputMeta, ParameterMeta } from '../model/system.ts';
import { RateError, type Frame, type Reader, type Scope, type Value, type Vector } from './expression.ts';
import { Graph, MOST_READ, type Id } from './graph.ts';
import type { BodyModel, Model, Row, SetModel, ShapeModel } from './model.ts';
import { symbolOf } from './symbols.ts';
import { DescriptionError, type LineToken } from './tokens.ts';

export const MOST_COORDINATES = 60;
const MOST_PARAMETERS = 200;
const MOST_BODIES = 100;
const MOST_ROWS = 60;

/**
 * A coordinate of a mechanical system that obeys `y' = …` has this mass: so little that it moves nothing by its reaction, and
 * that it alone gives way to its equation.
 */
const WEIGHTLESS = 2 ** -80;

type Role = 'neutral' | 'first' | 'second';

/** Makes the model of a description, statement by statement. */
export class Builder implements Scope {
  readonly graph = new Graph(MOST_READ);
  readonly world: Frame;
  readonly model: Model;
  private readonly values = new Map<string, Value>();
  private readonly vIds = new Set<Id>();
  /** Coordinates whose unit was not written. */
  private readonly unitless: CoordinateMeta[] = [];
  /** Rates of coordinates, and of all that was asked for so far. */
  private readonly rateOf = new Map<Id, Id>();
  /** What has no rates in it, as far as it was asked for. */
  private readonly placed = new Set<Id>();
  private clock: { q: Id; v: Id } | null = null;
  private readonly rows: { row: Row; sets: readonly string[] }[] = [];
  private readonly driven = new Map<number, Row>();
  /** Lines that define a name, the first of each. */
  private readonly later = new Map<string, number>();

  constructor() {
    const { graph } = this;
    const { zero, one } = graph;
    this.world = { name: 'world', R: [one, zero, zero, zero, one, zero, zero, zero, one], spin: [zero, zero, zero] };
    this.values.set('world', { kind: 'frame', frame: this.world });
    this.model = {
      title: 'Own system',
      graph,
      coordinates: [],
      lines: [],
      parameters: [],
      presets: {},
      q: [],
      v: [],
      p: [],
      clock: null,
      kinetic: zero,
      kineticLines: zero,
      inertia: zero,
      potential: zero,
      loss: zero,
      forces: [],
      inputs: [],
      sets: [],
      rates: new Map(),
      mechanical: false,
      bodies: [],
      shapes: [],
      tracks: [],
      events: [],
      held: [],
      shown: [],
      speed: null,
      forward: null,
      names: new Map(),
      defined: new Map(),
    };
  }

  look(name: string): Value | undefined {
    if (name === 't') return { kind: 'scalar', id: this.time().q };
    const rate = /^(.*?)(?:'|_dot)$/.exec(name)?.[1];
    if (rate === undefined) return this.values.get(name);
    const at = this.model.coordinates.findIndex((c) => c.name === rate);
    return at < 0 ? undefined : { kind: 'scalar', id: this.model.v[at]! };
  }

  *names(): Iterable<string> {
    yield* this.values.keys();
    for (const { name } of this.model.coordinates) yield `${name}'`;
    yield 't';
  }

  definedOn(name: string): number {
    return this.later.get(name) ?? 0;
  }

  inputOn(name: string): number {
    const known = this.model.names.get(name);
    return known?.kind === 'input' ? known.line : 0;
  }

  /** Looks over all lines for what they define, for those who use a name above its line. */
  foresee(lines: readonly string[]): void {
    for (const [k, line] of lines.entries()) {
      const found = /^\s*(?:(?:coordinate|parameter|frame|point|input)\s+([A-Za-z_][\w\s,]*)|([A-Za-z_]\w*)\s*=)/.exec(
        line,
      );
      for (const name of (found?.[1] ?? found?.[2] ?? '').split(',').map((part) => part.trim()))
        if (name && !this.later.has(name)) this.later.set(name, k + 1);
    }
  }

  frameOf(name: string): Frame | undefined {
    const value = this.values.get(name);
    return value?.kind === 'frame' ? value.frame : undefined;
  }

  /** The coordinate that is the time, from its first use on. */
  private time(): { q: Id; v: Id } {
    if (this.clock) return this.clock;
    this.clock = { q: this.graph.input(), v: this.graph.input() };
    this.rateOf.set(this.clock.q, this.clock.v);
    this.vIds.add(this.clock.v);
    return this.clock;
  }

  rate(ids: readonly Id[]): Id[] {
    const { graph, placed, rateOf } = this;
    const order = graph.beyond(ids, placed);
    if (order.some((i) => this.vIds.has(i)))
      throw new RateError(
        'this has a rate in it, and the rate of a rate is an acceleration, which the equations of motion give',
      );
    graph.spread(order, rateOf);
    for (const i of order) placed.add(i);
    return ids.map((i) => rateOf.get(i) ?? graph.zero);
  }

  rateAt(r: Reader, id: Id): Id {
    return this.ratesAt(r, [id])[0]!;
  }

  ratesAt(r: Reader, ids: readonly Id[]): Id[] {
    try {
      return this.rate(ids);
    } catch (error) {
      if (error instanceof RateError) return r.fail(error.message, r.tokens[1]);
      throw error;
    }
  }

  /** The same expression, which may have no rates in it. */
  ofPlace(r: Reader, id: Id): Id {
    if (this.graph.beyond([id], this.placed).some((i) => this.vIds.has(i)))
      r.fail('this may have no rates in it, only coordinates and parameters', r.tokens[1]);
    return id;
  }

  /** The same expression, which has to have a rate in it. @param otherwise what would be right */
  ofMotion(r: Reader, id: Id, otherwise: string): Id {
    if (!this.graph.depends(id, this.vIds))
      r.fail(`this has no rate in it: the rate of x is written x'; ${otherwise}`, r.tokens[1]);
    return id;
  }

  /** The same expression, of t and parameters alone. */
  ofTime(r: Reader, id: Id, from: LineToken | undefined): Id {
    if (this.graph.depends(id, new Set([...this.model.q, ...this.vIds])))
      r.fail('a driven coordinate is given by t and parameters alone; no other coordinate has a place here', from);
    return id;
  }

  constant(r: Reader, ...stops: string[]): number {
    const from = r.next;
    const { kind, text } = r.tokens[r.at + 1] ?? {};
    const words = new Set([...stops, 'deg', 'rad', 'pi', 'tau', 'e']);
    if (from?.kind === 'number' && kind === 'name' && !words.has(text!))
      r.fail(
        'a number is needed here, without names; a unit stands behind the name: parameter k [N/m] = 5',
        r.tokens[r.at + 1],
      );
    const id = r.scalar(...stops);
    const x = this.graph.value[id]!;
    if (!this.graph.isNumber(id)) r.fail('a number is needed here, without names', from);
    if (!Number.isFinite(x)) r.fail(`this is ${x}; a finite number is needed`, from);
    return x;
  }

  define(token: LineToken, line: number, kind: string, value: Value): void {
    this.values.set(token.text, value);
    this.model.names.set(token.text, { kind, line });
    if (kind === 'definition' && value.kind === 'scalar' && !this.model.defined.has(value.id))
      this.model.defined.set(value.id, token.text);
  }

  addCoordinate(
    token: LineToken,
    line: number,
    {
      unit: written,
      rest,
      label,
      role,
    }: { unit: string | undefined; rest: number; label: string | undefined; role: Role },
  ): void {
    const unit = written ?? 'm';
    const { model, graph } = this;
    if (model.coordinates.length >= MOST_COORDINATES)
      throw new DescriptionError(`there may be ${MOST_COORDINATES} coordinates`, line, token.at + 1, token.text.length);
    const angle = unit === 'rad' || unit === 'deg';
    if (!angle && unit !== 'm' && unit !== '1' && unit !== '')
      throw new DescriptionError(
        `a coordinate's unit is m, rad, deg, or 1 for anything else, not ${unit}`,
        line,
        token.at + 1,
        token.text.length,
      );
    const [q, v] = [graph.input(), graph.input()];
    model.coordinates.push({
      name: token.text,
      symbol: symbolOf(token.text),
      label: label ?? token.text,
      kind: angle ? 'angle' : 'length',
      ...(unit === '1' || unit === '' ? { pure: true as const } : {}),
      role,
      ...(rest === 0 ? {} : { rest }),
    });
    if (written === undefined) this.unitless.push(model.coordinates.at(-1)!);
    model.lines.push(line);
    model.q.push(q);
    model.v.push(v);
    this.vIds.add(v);
    this.rateOf.set(q, v);
    this.define(token, line, 'coordinate', { kind: 'scalar', id: q });
  }

  addParameter(
    token: LineToken,
    line: number,
    meta: { unit: string; angle: boolean; value: number; label: string | undefined; group?: string } & Pick<
      ParameterMeta,
      'positive' | 'min' | 'max' | 'note'
    >,
  ): void {
    const { model } = this;
    if (model.parameters.length >= MOST_PARAMETERS)
      throw new DescriptionError(`there may be ${MOST_PARAMETERS} parameters`, line, token.at + 1, token.text.length);
    const { unit, angle, value, label, group, ...bounds } = meta;
    model.parameters.push({
      name: token.text,
      symbol: symbolOf(token.text),
      label: label ?? token.text,
      unit,
      default: value,
      ...(angle ? { kind: 'angle' as const } : {}),
      ...bounds,
      group: group ?? 'Parameters',
    });
    const id = this.graph.input();
    model.p.push(id);
    this.define(token, line, 'parameter', { kind: 'scalar', id });
  }

  /** A frame turned about one of its own axes. */
  turn(frame: Frame, axis: 'x' | 'y' | 'z', angle: Id, r: Reader): Frame {
    const { graph } = this;
    const rate = this.rateAt(r, angle);
    const [c, s] = [graph.cos(angle), graph.sin(angle)];
    const k = ['x', 'y', 'z'].indexOf(axis);
    const [i, j] = [(k + 1) % 3, (k + 2) % 3];
    // Columns of R Rot: the axis stays, the next two turn.
    const R = [...frame.R];
    for (let row = 0; row < 9; row += 3) {
      const [u, w] = [frame.R[row + i]!, frame.R[row + j]!];
      R[row + i] = graph.add(graph.mul(u, c), graph.mul(w, s));
      R[row + j] = graph.sub(graph.mul(w, c), graph.mul(u, s));
    }
    const [u, w] = [frame.spin[i]!, frame.spin[j]!];
    const spin: Id[] = [...frame.spin];
    spin[i] = graph.add(graph.mul(u, c), graph.mul(w, s));
    spin[j] = graph.sub(graph.mul(w, c), graph.mul(u, s));
    spin[k] = graph.add(frame.spin[k]!, rate);
    return { name: frame.name, R, spin: spin as unknown as Vector };
  }

  addBody(body: BodyModel, role: Role): void {
    if (this.model.bodies.length >= MOST_BODIES)
      throw new DescriptionError(`there may be ${MOST_BODIES} bodies`, body.line);
    this.model.bodies.push({ ...body, role });
    if (body.mass !== null || body.inertia !== null) this.model.mechanical = true;
  }

  addTrack(name: string, position: Vector, label: string | undefined, r: Reader): void {
    const id = /^\w+$/.test(name) ? name : `point${this.model.tracks.length + 1}`;
    const body = this.model.bodies.length;
    this.addBody(
      {
        id,
        label: label ?? id,
        position,
        origin: position,
        frame: this.world,
        mass: null,
        inertia: null,
        line: r.line,
      },
      'neutral',
    );
    this.model.tracks.push({ body, label: label ?? id });
  }

  addShape(r: Reader, shape: ShapeModel): void {
    const others = new Set([...this.model.q, ...this.vIds, ...(this.clock ? [this.clock.q] : [])]);
    if ([...shape.sizes, ...shape.at].some((id) => this.graph.depends(id, others)))
      r.fail('a shape is measured in numbers and parameters; what moves is said by its body', r.tokens[1]);
    this.model.shapes.push(shape);
  }

  /** A force in the direction in which `velocity` grows. */
  addForce(force: Id, velocity: Id): void {
    const { graph, model } = this;
    graph.gradient(velocity, model.v).forEach((slope, i) => {
      model.forces[i] = graph.add(model.forces[i] ?? graph.zero, graph.mul(force, slope));
    });
    model.mechanical = true;
  }

  /** Weights of coordinates in a sum of them. */
  weights(r: Reader, id: Id): Record<string, number> {
    const { graph, model } = this;
    const weights: Record<string, number> = {};
    graph.gradient(id, model.q).forEach((slope, i) => {
      if (slope === graph.zero) return;
      if (!graph.isNumber(slope)) r.fail('an input acts on a sum of coordinates, such as alpha - 2*beta', r.tokens[1]);
      weights[model.coordinates[i]!.name] = graph.value[slope]!;
    });
    if (Object.keys(weights).length === 0) r.fail('an input acts on coordinates, and there is none here', r.tokens[1]);
    return weights;
  }

  addInput(
    token: LineToken,
    line: number,
    {
      unit,
      column,
      label,
      tracks,
    }: {
      unit: string | undefined;
      column: Record<string, number>;
      label: string | undefined;
      tracks: readonly string[] | undefined;
    },
  ): void {
    const { model } = this;
    const on = Object.keys(column);
    const angle = on.every((name) => model.coordinates.find((c) => c.name === name)!.kind === 'angle');
    const follows = tracks ?? (on.every((name) => column[name] === 1) ? on : undefined);
    const input: InputMeta = {
      name: token.text,
      symbol: symbolOf(token.text),
      label: label ?? token.text,
      unit: unit ?? (angle ? 'N·m' : 'N'),
      column,
      ...(follows ? { tracks: follows } : {}),
    };
    model.inputs.push(input);
    model.names.set(token.text, { kind: 'input', line });
  }

  addSet(id: string, label: string, line: number): void {
    this.model.sets.push({ id, label, rows: [], line });
  }

  addRow(r: Reader, sets: readonly string[], row: Row): void {
    if (this.rows.length >= MOST_ROWS) r.fail(`there may be ${MOST_ROWS} constraints`, r.tokens[0]);
    for (const id of sets)
      if (!this.model.sets.some((set) => set.id === id))
        r.fail(
          `there are no constraints "${id}": write "constraints ${id}" on a line above`,
          r.tokens.find(({ text }) => text === id),
        );
    this.rows.push({ row, sets });
  }

  addDrive(r: Reader, token: LineToken, at: number, value: Id): void {
    const { graph, model } = this;
    const { name } = model.coordinates[at]!;
    if (this.driven.has(at) || model.rates.has(at))
      r.fail(`"${name}" is already given on line ${this.driven.get(at)?.line ?? model.rates.get(at)!.line}`, token);
    const height = graph.sub(model.q[at]!, value);
    this.time();
    this.driven.set(at, {
      velocity: this.rateAt(r, height),
      height,
      solve: at,
      line: r.line,
      label: `${name} is driven`,
    });
  }

  addRate(r: Reader, token: LineToken, at: number, value: Id): void {
    const { model } = this;
    const { name } = model.coordinates[at]!;
    if (this.driven.has(at) || model.rates.has(at))
      r.fail(`"${name}" is already given on line ${this.driven.get(at)?.line ?? model.rates.get(at)!.line}`, token);
    model.rates.set(at, { value, line: r.line });
  }

  /** What the statements leave for the end: energies of bodies, rows of the sets, the clock. @throws DescriptionError */
  finish(): Model {
    const { model, graph } = this;
    if (model.coordinates.length === 0)
      throw new DescriptionError('there is no coordinate: write a line such as coordinate x [m]', 0);
    this.addEnergies();
    this.refuseIdleGravity();
    if (model.mechanical) {
      for (const [at, { value, line }] of model.rates) {
        const v = model.v[at]!;
        const { name } = model.coordinates[at]!;
        for (const input of model.inputs)
          if (name in input.column)
            throw new DescriptionError(
              `${name} is given by its equation on line ${line}, and no input acts on it; what drives it is an expression of t in that equation`,
              model.names.get(input.name)!.line,
            );
        model.inertia = graph.add(model.inertia, graph.mul(graph.number(WEIGHTLESS / 2), graph.square(v)));
        this.driven.set(at, {
          velocity: graph.sub(v, value),
          height: null,
          solve: null,
          line,
          label: `${name}' = …`,
        });
      }
    } else if (this.rows.length > 0 || this.driven.size > 0 || model.inputs.length > 0) {
      throw new DescriptionError(
        'constraints, drives and inputs need bodies or energies to act on',
        this.rows[0]?.row.line ?? 0,
      );
    } else {
      model.coordinates.forEach(({ name }, i) => {
        if (!model.rates.has(i))
          throw new DescriptionError(
            `${name} has no equation: write ${name}' = …, or give the system energies or bodies`,
            model.lines[i]!,
          );
      });
      // Of a plain equation nothing says that it is about lengths.
      for (const coordinate of this.unitless) coordinate.pure = true;
    }
    this.fillSets();
    this.addClock();
    return model;
  }

  /** Bodies weigh by `gravity`: a parameter `g` that nothing uses was meant to be it. */
  private refuseIdleGravity(): void {
    const { model, graph, rows } = this;
    const at = model.parameters.findIndex(({ name }) => /^(g|grav|Gravity)$/.test(name));
    if (at < 0 || this.values.has('gravity') || !model.bodies.some(({ mass }) => mass !== null)) return;
    const used = new Set([model.p[at]!]);
    const all = [model.kinetic, model.potential, model.loss, ...model.forces.filter((f) => f !== undefined)];
    if ([...all, ...rows.map(({ row }) => row.velocity)].some((id) => graph.depends(id, used))) return;
    const { name } = model.parameters[at]!;
    throw new DescriptionError(
      `nothing uses ${name}; bodies weigh by a parameter of the name gravity: parameter gravity [m/s²] = ${model.parameters[at]!.default}`,
      model.names.get(name)!.line,
    );
  }

  private addEnergies(): void {
    const { model, graph } = this;
    model.kineticLines = model.kinetic;
    const g = this.values.get('gravity');
    const half = graph.number(0.5);
    for (const { mass, inertia, position, frame, line } of model.bodies) {
      graph.work = `the energy of the body of line ${line}`;
      if (mass !== null) {
        const speed = graph.sum(this.rate(position).map((x) => graph.square(x)));
        model.kinetic = graph.add(model.kinetic, graph.mul(graph.mul(half, mass), speed));
        if (g?.kind === 'scalar')
          model.potential = graph.add(model.potential, graph.mul(graph.mul(mass, g.id), position[2]));
      }
      if (inertia !== null) {
        const [x, y, z] = frame.spin;
        const squares = graph.sum([x, y, z].map((w, k) => graph.mul(inertia[k]!, graph.square(w))));
        const products =
          inertia.length < 6
            ? []
            : [graph.mul(x, y), graph.mul(x, z), graph.mul(y, z)].map((w, k) => graph.mul(inertia[3 + k]!, w));
        model.kinetic = graph.add(model.kinetic, graph.add(graph.mul(half, squares), graph.sum(products)));
      }
    }
  }

  private fillSets(): void {
    const { model } = this;
    const always = [...this.driven.values()];
    if (model.sets.length === 0 && this.rows.length + always.length > 0)
      this.addSet(
        'constrained',
        this.rows.length > 0 ? 'Constrained' : 'Driven',
        (this.rows[0]?.row ?? always[0]!).line,
      );
    for (const { row, sets } of this.rows)
      for (const set of model.sets) if (sets.length === 0 || sets.includes(set.id)) set.rows.push(row);
    for (const set of model.sets) set.rows = [...set.rows, ...always].map((row) => this.homogeneous(row));
    if (always.length === 0 && model.sets.every((set) => set.rows.length > 0))
      model.sets.push(freeSet(model.sets.length > 0));
  }

  /** A velocity row with a part that no rate multiplies: that part goes with the rate of the clock, which is 1. */
  private homogeneous(row: Row): Row {
    const { graph } = this;
    const still = new Map([...this.vIds].map((v) => [v, graph.zero]));
    const [constant] = graph.replace([row.velocity], still);
    if (constant === graph.zero) return row;
    const { v } = this.time();
    return { ...row, velocity: graph.sub(row.velocity, graph.mul(constant!, graph.sub(graph.one, v))) };
  }

  private addClock(): void {
    const { model, graph, clock } = this;
    if (!clock) return;
    model.clock = model.coordinates.length;
    model.coordinates.push({
      name: 'clock',
      symbol: 't',
      label: 'clock, by which what is driven goes (s)',
      kind: 'length',
      pure: true,
      role: 'neutral',
    });
    model.lines.push(0);
    model.q.push(clock.q);
    model.v.push(clock.v);
    if (model.mechanical) model.inertia = graph.add(model.inertia, graph.mul(graph.number(0.5), graph.square(clock.v)));
    else model.rates.set(model.clock, { value: graph.one, line: 0 });
  }
}

const freeSet = (others: boolean): SetModel => ({
  id: 'none',
  label: others ? 'None: free' : 'None: there are no constraints',
  rows: [],
  line: 0,
});
