/**
 * The equations of a described system as marked LaTeX, as the derivation writes them for the built-in ones: energies, bodies,
 * the equations one by one where they are short, the entries of M, h, Omega and gamma, with named parts where they are long.
 */
import type { Typeset, TypesetBody, TypesetConstraints } from '../model/typeset.ts';
import { equationsOf, type Equations } from './derive.ts';
import { GrowthError, type Id } from './graph.ts';
import { latexOf } from './latex.ts';
import type { BodyModel, Model } from './model.ts';
import { Polynomials, sizeOf, type AtomKind } from './polynomial.ts';
import { latexName } from './symbols.ts';

/** Operations up to which an entry is printed, and symbols up to which all equations of motion are. */
const MOST_PRINTED = 150;
const MOST_IN_EQUATION = 160;
const MOST_IN_ENERGY = 240;
/** Nodes that typesetting may add: it is done while a person looks on. */
const MOST_TYPESET = 300_000;

const MOTION = String.raw`M(q)\, \ddot q = h(q, \dot q) + B\, u`;
const CONSTRAINED = String.raw` + \Omega(q)^{\mathsf T} \lambda`;
const FORCES = String.raw`h = \dfrac{\partial L}{\partial q} - \dfrac{\partial^2 L}{\partial \dot q\, \partial q}\, \dot q - \dfrac{\partial R}{\partial \dot q} + Q`;
const ROWS = String.raw`\Omega(q)\, \dot q = 0, \qquad \Omega\, \ddot q + \gamma = 0, \qquad \gamma = \dot\Omega\, \dot q`;
const MULTIPLIERS = String.raw`\left( \Omega\, M^{-1} \Omega^{\mathsf T} \right) \lambda = - \gamma - \Omega\, M^{-1} (h + B\, u)`;

class Writer {
  readonly symbols: Record<string, string> = {};
  readonly a: readonly Id[];
  readonly lambda: readonly Id[];
  readonly forces: readonly Id[];
  readonly polynomials: Polynomials;
  private readonly coordinates: readonly string[];

  constructor(private readonly model: Model) {
    const { graph, q, v, p, coordinates, parameters } = model;
    const inputs = new Map<Id, { name: string; kind: AtomKind }>();
    const put = (id: Id, name: string, kind: AtomKind, letter: string): Id => {
      inputs.set(id, { name, kind });
      this.symbols[name] = letter;
      return id;
    };
    this.coordinates = coordinates.map(({ name }) => name);
    const letters = coordinates.map(({ name }, i) => (i === model.clock ? 't' : latexName(name)));
    q.forEach((id, i) => put(id, coordinates[i]!.name, 'coordinate', letters[i]!));
    v.forEach((id, i) => put(id, `${coordinates[i]!.name}_dot`, 'rate', dotted('dot', letters[i]!)));
    const g = parameters.some(({ name }) => name === 'g') ? '\\mathrm{gravity}' : 'g';
    p.forEach((id, i) => {
      const { name } = parameters[i]!;
      put(id, name, 'parameter', name === 'gravity' ? g : latexName(name));
    });
    this.a = letters.map((letter, i) =>
      put(graph.input(), `${coordinates[i]!.name}_ddot`, 'rate', dotted('ddot', letter)),
    );
    this.forces = letters.map((letter, i) => put(graph.input(), `Q.${coordinates[i]!.name}`, 'rate', `Q_{${letter}}`));
    const most = Math.max(0, ...model.sets.map(({ rows }) => rows.length));
    this.lambda = Array.from({ length: most }, (_, r) =>
      put(graph.input(), `lambda_${r + 1}`, 'rate', `\\lambda_{${r + 1}}`),
    );
    const given = new Set(p);
    const moving = new Set([...q, ...v]);
    const named = new Map([...model.defined].filter(([id]) => graph.depends(id, given) && !graph.depends(id, moving)));
    for (const name of named.values()) this.symbols[name] = latexName(name);
    this.polynomials = new Polynomials(graph, inputs, named);
  }

  print(id: Id): string {
    return latexOf(this.polynomials.of(id));
  }

  size(id: Id): number {
    return sizeOf(this.polynomials.of(id));
  }

  operations(id: Id): number {
    return this.model.graph.reach([id]).length;
  }

  vector(ids: readonly Id[]): string {
    return `\\begin{pmatrix} ${ids.map((id) => this.print(id)).join(' \\\\ ')} \\end{pmatrix}`;
  }

  matrix(ids: readonly Id[]): string {
    const rows = [0, 3, 6].map((k) => ids.slice(k, k + 3).map((id) => this.print(id)));
    return `\\begin{pmatrix} ${rows.map((row) => row.join(' & ')).join(' \\\\ ')} \\end{pmatrix}`;
  }

  mark(i: number): string {
    return `\\s{${this.coordinates[i]!}}`;
  }

  /** The parts that were needed, each after those that it is made of. */
  letters(): string[] {
    const { parts } = this.polynomials;
    let count = 0;
    const out: string[] = [];
    for (const [mark, p] of parts) {
      if (mark.startsWith('part.')) this.symbols[mark] = `\\zeta_{${++count}}`;
      out.push(`\\s{${mark}} = ${latexOf(p)}`);
    }
    return out;
  }
}

const dotted = (accent: string, letter: string): string => {
  // The accent stands on the letter, not on its index.
  const [, base, index] = /^([^_]*)(_.*)?$/.exec(letter)!;
  return `\\${accent}{${base}}${index ?? ''}`;
};

/**
 * The equations of a model.
 *
 * @param model what was read of a description, whose graph grows by what is derived here
 * @param id of the system
 */
export function typesetOf(model: Model, id: string): Typeset {
  const w = new Writer(model);
  model.graph.most = Math.min(model.graph.most, model.graph.size + MOST_TYPESET);
  const empty: Typeset = {
    system: id,
    symbols: w.symbols,
    letters: [],
    contacts: [],
    frames: [],
    bodies: [],
    energies: {},
    motion: [],
    structure: [],
    losses: [],
    mass: null,
    constraints: [],
  };
  if (!model.mechanical) {
    const motion = [...model.rates].map(
      ([i, { value }]) => `\\s{${model.coordinates[i]!.name}_dot} = ${w.print(value)}`,
    );
    return { ...empty, motion, letters: w.letters() };
  }
  const bodies = bodiesOf(model, w);
  const constrained = model.sets.some(({ rows }) => rows.length > 0);
  const structure = [MOTION + (constrained ? CONSTRAINED : ''), FORCES, ...(constrained ? [ROWS, MULTIPLIERS] : [])];
  const energies = energiesOf(model, w);
  const losses = model.loss === model.graph.zero ? [] : [`R = ${w.print(model.loss)}`];
  let equations: Equations;
  try {
    equations = equationsOf(model);
  } catch (error) {
    if (!(error instanceof GrowthError)) throw error;
    return { ...empty, bodies, energies, structure, losses, letters: w.letters() };
  }
  const parts = {
    bodies,
    energies,
    losses,
    motion: motionOf(model, equations, w),
    structure,
    ...entriesOf(model, equations, w),
    constraints: constraintsOf(model, equations, w),
  };
  return { ...empty, ...parts, letters: w.letters() };
}

/** Bodies that have a mass, an inertia or a place; what is only drawn has none. */
function bodiesOf(model: Model, w: Writer): TypesetBody[] {
  return model.bodies
    .filter(({ mass, inertia }) => mass !== null || inertia !== null)
    .map((body, k) => bodyOf(model, w, body, k + 1));
}

function bodyOf(model: Model, w: Writer, body: BodyModel, k: number): TypesetBody {
  const { graph, q, v } = model;
  const { id, mass, inertia, position, frame } = body;
  const letter = (kind: string, latex: string): string => {
    w.symbols[`${kind}.${id}`] = latex;
    return `\\s{${kind}.${id}}`;
  };
  const R = letter('R', `R_{${k}}`);
  const r = letter('r', `\\mathbf r_{${k}}`);
  const speed = letter('v', `\\dot{\\mathbf r}_{${k}}`);
  const spin = letter('omega', `\\boldsymbol{\\omega}_{${k}}`);
  const I = letter('I', `I_{${k}}`);
  const T = letter('T', `T_{${k}}`);
  const velocity = graph.forward(position, new Map(q.map((x, i) => [x, v[i]!])));
  const turns = frame.spin.some((x) => x !== graph.zero);
  const m = mass === null ? '0' : w.print(mass);
  const energies = [
    ...(mass === null ? [] : [`\\tfrac12\\, ${/ [+-] /.test(m) ? `\\left(${m}\\right)` : m}\\, |${speed}|^2`]),
    ...(inertia === null ? [] : [`\\tfrac12\\, ${spin}^{\\mathsf T} ${I}\\, ${spin}`]),
  ];
  return {
    id,
    mass: m,
    inertia: inertia === null ? null : `${I} = ${inertiaLatex(inertia, w)}`,
    attitude: `${R} = ${turns ? w.matrix(frame.R) : '\\mathbf 1'}`,
    position: `${r} = ${w.vector(position)}`,
    velocity: `${speed} = ${w.vector(velocity)}`,
    ...(turns ? { angular: `${spin} = ${w.vector(frame.spin)}` } : {}),
    kinetic: `${T} = ${energies.join(' + ')}`,
  };
}

function inertiaLatex(inertia: readonly Id[], w: Writer): string {
  if (inertia.length < 6) return `\\operatorname{diag}(${inertia.map((x) => w.print(x)).join(',\\ ')})`;
  const [xx, yy, zz, xy, xz, yz] = inertia as [Id, Id, Id, Id, Id, Id];
  return w.matrix([xx, xy, xz, xy, yy, yz, xz, yz, zz]);
}

function energiesOf(model: Model, w: Writer): Typeset['energies'] {
  const { graph, kinetic, potential } = model;
  const L = graph.sub(kinetic, potential);
  return {
    kinetic: `T = ${w.print(kinetic)}`,
    potential: `V = ${w.print(potential)}`,
    lagrangian: `L = T - V${w.size(L) <= MOST_IN_ENERGY ? ` = ${w.print(L)}` : ''}`,
  };
}

/** Coordinates that have an equation of motion: not the clock, and not what has one of first order. */
const moving = ({ q, rates, clock }: Model): number[] => [...q.keys()].filter((i) => i !== clock && !rates.has(i));

/** One equation a coordinate, and those of first order; none where one of them is too long to be read. */
function motionOf(model: Model, { M, h, sets }: Equations, w: Writer): string[] {
  const { graph, q } = model;
  const n = q.length;
  const set = sets.find((one) => one.id === model.sets[0]?.id);
  const rows = moving(model);
  const sides = rows.map((i) => ({
    left: [...w.a.map((a, j) => graph.mul(M[i * n + j]!, a)), graph.neg(h[i]!)],
    right: [w.forces[i]!, ...(set ? set.rows.map((_, r) => graph.mul(set.omega[r * n + i]!, w.lambda[r]!)) : [])],
  }));
  if (sides.some(({ left, right }) => [...left, ...right].some((x) => w.operations(x) > MOST_PRINTED))) return [];
  const equations = sides.map(({ left, right }) => [graph.sum(left), graph.sum(right)] as const);
  if (equations.some(([left, right]) => w.size(left) + w.size(right) > MOST_IN_EQUATION)) return [];
  return [
    ...equations.map(([left, right]) => `${w.print(left)} = ${w.print(right)}`),
    ...[...model.rates].map(([i, { value }]) => `\\s{${model.coordinates[i]!.name}_dot} = ${w.print(value)}`),
  ];
}

/** The upper triangle of M, and h. */
function entriesOf(model: Model, { M, h }: Equations, w: Writer): Pick<Typeset, 'mass' | 'forces'> {
  const { graph, coordinates } = model;
  const n = coordinates.length;
  const rows = moving(model);
  const entries: { row: string; column: string; latex: string }[] = [];
  const left: { row: string; column: string; operations: number }[] = [];
  for (const i of rows)
    for (const j of rows) {
      const x = M[i * n + j]!;
      if (j < i || x === graph.zero) continue;
      const at = { row: coordinates[i]!.name, column: coordinates[j]!.name };
      const operations = w.operations(x);
      if (operations > MOST_PRINTED) left.push({ ...at, operations });
      else entries.push({ ...at, latex: `M_{${w.mark(i)},\\, ${w.mark(j)}} = ${w.print(x)}` });
    }
  const forces = rows.map((i) => {
    const row = coordinates[i]!.name;
    const operations = w.operations(h[i]!);
    return operations > MOST_PRINTED ? { row, operations } : { row, latex: `h_{${w.mark(i)}} = ${w.print(h[i]!)}` };
  });
  return { mass: { entries, left }, forces };
}

function constraintsOf(model: Model, { sets }: Equations, w: Writer): TypesetConstraints[] {
  const { graph, coordinates } = model;
  const n = coordinates.length;
  return sets.map(({ id, rows, omega, gamma }) => ({
    id,
    rows: rows.map((row, r) => ({
      title: row.label || `line ${row.line}`,
      latex:
        w.operations(row.velocity) > MOST_PRINTED
          ? `\\Omega_{${r + 1}}\\, \\dot q = 0`
          : `${w.print(row.velocity)} = 0`,
      entries: coordinates.flatMap<TypesetConstraints['rows'][number]['entries'][number]>(({ name }, i) => {
        const x = omega[r * n + i]!;
        if (x === graph.zero) return [];
        const operations = w.operations(x);
        return operations > MOST_PRINTED
          ? [{ column: name, operations }]
          : [{ column: name, latex: `\\Omega_{${r + 1},\\, ${w.mark(i)}} = ${w.print(x)}` }];
      }),
      ...(w.operations(gamma[r]!) > MOST_PRINTED ? {} : { gamma: `\\gamma_{${r + 1}} = ${w.print(gamma[r]!)}` }),
    })),
    heights: rows.flatMap(({ height }) => (height === null ? [] : [`${w.print(height)} = 0`])),
  }));
}
