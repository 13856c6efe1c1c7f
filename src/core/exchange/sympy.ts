/**
 * A Python script that needs SymPy alone and derives the equations again from what the system is made of: bodies by Kane's method
 * (T. R. Kane, D. A. Levinson, Dynamics, McGraw-Hill 1985, section 6.1), energies by Lagrange's equations, constraint rows by
 * their derivatives. It shares no derivative with the program, so that agreement says something.
 */
import type { Id, OpName } from '../description/graph.ts';
import type { Source, TestVector } from './source.ts';
import { straightLine, type Syntax } from './straightLine.ts';

const NAMES: Partial<Record<OpName, string>> = { abs: 'Abs', ceil: 'ceiling' };

const PYTHON: Syntax = {
  number: (x) => (Number.isFinite(x) ? String(x) : Number.isNaN(x) ? 'sm.nan' : x < 0 ? '-sm.oo' : 'sm.oo'),
  call(name, operands) {
    if (name === 'log10' || name === 'log2') return `sm.log(${operands[0]}, ${name.slice(3)})`;
    if (name === 'cbrt') return `sm.sign(${operands[0]})*sm.Abs(${operands[0]})**sm.Rational(1, 3)`;
    if (name === 'pow') return `sm.Pow(${operands.join(', ')})`;
    return `sm.${NAMES[name] ?? name}(${operands.join(', ')})`;
  },
  truth: (condition) => `sm.Piecewise((1, ${relation(condition)}), (0, True))`,
  select: (condition, yes, no) => `sm.Piecewise((${yes}, ${relation(condition)}), (${no}, True))`,
  isTrue: (x) => `sm.Ne(${x}, 0)`,
};

/** `a == b` of SymPy's expressions asks whether they are written alike. */
const relation = (condition: string): string => condition.replace(/^(.*) == (.*)$/, 'sm.Eq($1, $2)');

/** Words that a script cannot name a variable by, and those that this one uses. */
const TAKEN = new Set(
  (
    'False None True and as assert async await break class continue def del elif else except finally for from global if import in ' +
    'is lambda nonlocal not or pass raise return try while with yield match case type print float list map zip max abs range len ' +
    'sum sm sys q v p u n M h B Omega gamma bodies rows held body column mass inertia position spin energies kinetic potential ' +
    'loss forces rate rates system solve tests jacobian function compare worst values'
  ).split(' '),
);

/** An identifier of Python for every symbol. */
function identifiers(names: readonly string[]): string[] {
  const used = new Set(TAKEN);
  return names.map((name) => {
    let id = name.normalize('NFKC');
    while (used.has(id) || /^w\d+$/.test(id)) id += '_';
    used.add(id);
    return id;
  });
}

/**
 * The script.
 *
 * @param source what is exported
 * @param about lines of what it is
 */
export function sympyOf(source: Source, about: readonly string[]): string {
  const { model, set, held, tests, id } = source;
  const { graph, coordinates, parameters, inputs, bodies } = model;
  const n = coordinates.length;
  const symbols = identifiers([
    ...coordinates.map(({ name }) => name),
    ...coordinates.map(({ name }) => `${name}_dot`),
    ...parameters.map(({ name }) => name),
  ]);
  const of = { q: symbols.slice(0, n), v: symbols.slice(n, 2 * n), p: symbols.slice(2 * n) };
  const given = new Map<Id, string>();
  model.q.forEach((node, i) => given.set(node, of.q[i]!));
  model.v.forEach((node, i) => given.set(node, of.v[i]!));
  model.p.forEach((node, i) => given.set(node, of.p[i]!));
  const heavy = bodies.filter(({ mass, inertia }) => mass !== null || inertia !== null);
  const rows = set?.rows ?? [];
  const rates = model.mechanical ? [] : model.q.map((_, i) => model.rates.get(i)!.value);
  const extra = graph.add(model.kineticLines, model.inertia);
  const forces = model.q.map((_, i) => model.forces[i] ?? graph.zero);
  const wanted = model.mechanical
    ? [
        ...heavy.flatMap(({ mass, inertia, position, frame }) => [
          ...(mass === null ? [] : [mass]),
          ...(inertia ?? []),
          ...position,
          ...frame.spin,
        ]),
        extra,
        model.potential,
        model.loss,
        ...forces,
        ...rows.map(({ velocity }) => velocity),
      ]
    : rates;
  const { lines, of: text } = straightLine(graph, wanted, given, 'w', PYTHON);
  const list = (ids: readonly Id[]): string => ids.map(text).join(', ');
  const declare = (variable: string, names: readonly string[], ids: readonly string[]): string =>
    names.length === 0
      ? `${variable} = []`
      : names.length === 1
        ? `${variable} = [${ids[0]}] = [sm.Symbol("${names[0]}", real=True)]`
        : `${variable} = ${wrapList(ids)} = sm.symbols("${names.join(' ')}", real=True)`;
  const head = [
    `"""${about.join('\n')}\n\nRuns with SymPy alone:  python3 ${id}.py\n"""`,
    'import sys\n\nimport sympy as sm',
    [
      '# Coordinates, their rates, parameters.',
      declare(
        'q',
        coordinates.map(({ name }) => name),
        of.q,
      ),
      declare(
        'v',
        coordinates.map(({ name }) => `${name}_dot`),
        of.v,
      ),
      declare(
        'p',
        parameters.map(({ name }) => name),
        of.p,
      ),
    ].join('\n'),
    ...(lines.length > 0
      ? [`# What is used more than once.\n${lines.map(({ name, text: line }) => `${name} = ${line}`).join('\n')}`]
      : []),
  ];
  const vectors = `# States of RipStik Lab: what it computes there.\nparameters = ${numbers(source.p)}\ntests = [\n${tests.map((t) => vector(t, model.mechanical)).join('\n')}\n]`;
  if (!model.mechanical)
    return `${[...head, `# The rates of the coordinates.\nrates = [${list(rates)}]`, vectors, FIRST_ORDER].join('\n\n')}\n`;
  const bodyLines = heavy.map(({ id: name, mass, inertia, position, frame }) => {
    const [xx, yy, zz, xy, xz, yz] = inertia ?? Array<Id>(6).fill(graph.zero);
    const zero = graph.zero;
    const matrix = [xx, xy, xz, xy, yy, yz, xz, yz, zz].map((x) => x ?? zero);
    const row = (k: number): string => `[${list(matrix.slice(k, k + 3))}]`;
    return `    # ${name}\n    (${mass === null ? '0' : text(mass)}, [${row(0)}, ${row(3)}, ${row(6)}],\n     [${list(position)}],\n     [${list(frame.spin)}]),`;
  });
  const columns = inputs.map(
    ({ name, column }) =>
      `    # ${name}\n    {${Object.entries(column)
        .map(([coordinate, weight]) => `${coordinates.findIndex((c) => c.name === coordinate)}: ${weight}`)
        .join(', ')}},`,
  );
  return `${[
    ...head,
    `# Bodies: mass, inertia in the body's axes, centre of mass, angular velocity in the body's axes.\nbodies = [\n${bodyLines.join('\n')}\n]`,
    [
      "# Energies beside those of the bodies, the potential of all, Rayleigh's function, generalized forces.",
      `kinetic = sm.sympify(${text(extra)})`,
      `potential = sm.sympify(${text(model.potential)})`,
      `loss = sm.sympify(${text(model.loss)})`,
      `forces = [${list(forces)}]`,
    ].join('\n'),
    `# Constraints, ${set ? set.id : 'none'}: velocities that vanish.\nrows = [\n${rows.map(({ velocity, label, line }) => `    # ${label || `line ${line}`}\n    ${text(velocity)},`).join('\n')}\n]`,
    `# Inputs: what they act on, by place, with which weight.\ninputs = [\n${columns.join('\n')}\n]`,
    `# Coordinates that do not move, by place.\nheld = [${held.join(', ')}]`,
    DERIVATION,
    vectors,
    COMPARISON,
  ].join('\n\n')}\n`;
}

function wrapList(ids: readonly string[]): string {
  return ids.join(', ');
}

const numbers = (values: ArrayLike<number>): string => `[${Array.from(values, PYTHON.number).join(', ')}]`;

function vector({ what, q, v, u, acceleration, lambda }: TestVector, mechanical: boolean): string {
  const parts = mechanical ? [q, v, u, acceleration, lambda] : [q, acceleration];
  return `    # ${what}\n    (${parts.map(numbers).join(',\n     ')}),`;
}

const DERIVATION = `# Equations of motion: M a = h + B u + Omega^T lambda, Omega a + gamma = 0.
n = len(q)
vector = sm.Matrix(v)


def jacobian(values, variables):
    return sm.Matrix([[sm.diff(x, y) for y in variables] for x in values]) if values else sm.zeros(0, len(variables))


def bias(velocity):
    """What an acceleration has beside its part that is linear in the accelerations of the coordinates."""
    return jacobian(list(velocity), q) * vector


M = sm.zeros(n, n)
h = sm.zeros(n, 1)
for mass, inertia, position, spin in bodies:
    # Kane: partial velocities, and inertia forces.
    J = jacobian(position, q)
    M += mass * J.T * J
    h -= mass * J.T * bias(J * vector)
    W = jacobian(spin, v)
    omega = sm.Matrix(spin)
    inertia = sm.Matrix(inertia)
    M += W.T * inertia * W
    h -= W.T * (inertia * bias(W * vector) + omega.cross(inertia * omega))
# Lagrange.
momentum = [sm.diff(kinetic, x) for x in v]
M += jacobian(momentum, v)
h += sm.Matrix([sm.diff(kinetic - potential, x) for x in q]) - bias(momentum)
h += sm.Matrix([f - sm.diff(loss, x) for f, x in zip(forces, v)])
Omega = jacobian(rows, v)
gamma = bias(rows)`;

const COMPARISON = `function = sm.lambdify([*q, *v, *p], [M.tolist(), list(h), Omega.tolist(), list(gamma)], modules="math", cse=True)


def solve(q, v, u):
    """Accelerations and multipliers, in numbers."""
    M, h, Omega, gamma = map(sm.Matrix, function(*q, *v, *parameters)) if rows else (
        *map(sm.Matrix, function(*q, *v, *parameters)[:2]), sm.zeros(0, n), sm.zeros(0, 1))
    for column, value in zip(inputs, u):
        for at, weight in column.items():
            h[at] += weight * value
    for at in held:
        M[at, :], M[:, at], Omega[:, at] = sm.zeros(1, n), sm.zeros(n, 1), sm.zeros(Omega.rows, 1)
        M[at, at], h[at] = 1, 0
    saddle = sm.Matrix(sm.BlockMatrix([[M, -Omega.T], [Omega, sm.zeros(Omega.rows, Omega.rows)]])) if rows else M
    x = list(saddle.LUsolve(sm.Matrix([*h, *(-gamma)])))
    return x[:n], x[n:]


def compare(ours, theirs):
    return max([abs(x - y) for x, y in zip(ours, theirs)], default=0) / max(1, *map(abs, theirs), 1)


worst = 0
for at, speed, u, expected, multipliers in tests:
    a, lambdas = solve(at, speed, u)
    for symbol, x, y in zip(q, a, expected):
        print(f"{symbol}_ddot = {float(x):.12g}  (RipStik Lab: {y:.12g})")
    worst = max(worst, compare(a, expected), compare(lambdas, multipliers))
print(f"largest relative difference {float(worst):.3g}")
sys.exit(0 if worst < 1e-9 else 1)`;

const FIRST_ORDER = `worst = 0
for at, expected in tests:
    values = [float(sm.sympify(x).subs(dict(zip([*q, *p], [*at, *parameters])))) for x in rates]
    for symbol, x, y in zip(q, values, expected):
        print(f"{symbol}_dot = {x:.12g}  (RipStik Lab: {y:.12g})")
    worst = max([worst, *[abs(x - y) / max(1, abs(y)) for x, y in zip(values, expected)]])
print(f"largest relative difference {worst:.3g}")
sys.exit(0 if worst < 1e-9 else 1)`;
