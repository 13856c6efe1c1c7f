/**
 * The statements of a description, one a line: each is read by one function below and changes the model at once, so that a name
 * has to be defined above the line that uses it. docs/own-systems.md teaches the language.
 */
import { several, unary } from '../scenario/expressions/functions.ts';
import { checkUnit, isAngleUnit } from './units.ts';
import { dot, turned, type Frame, type Reader, type Vector } from './expression.ts';
import type { Id } from './graph.ts';
import type { Builder } from './builder.ts';
import type { ShapeKind } from './model.ts';
import type { LineToken } from './tokens.ts';

export interface Statement {
  /** How it is written, for messages and completion. */
  example: string;
  /** Words that it knows behind its first. */
  words?: readonly string[];
  read(r: Reader, b: Builder): void;
}

const NAME = /^[A-Za-z_]\w*$/;
/** Names that mean one thing everywhere; `tau` and `e` are what a description declares, where it does. */
const RESERVED = new Map([
  ['t', 'is the time'],
  ['clock', 'is the time, as a coordinate'],
  ['world', 'is the frame that stands still'],
  ['pi', 'is 3.14159… in every formula; leave this line out'],
  ['deg', 'is a unit in every formula'],
  ['rad', 'is a unit in every formula'],
]);

/** A name that is new here. */
function newName(r: Reader, b: Builder, what: string): LineToken {
  const token = r.takeKind('name') ?? r.fail(`the name of the ${what} is expected here`);
  if (!NAME.test(token.text)) r.fail(`"${token.text}" is no name: letters, digits and _`, token);
  if (token.text.length > 40) r.fail('a name has at most 40 characters', token);
  if (token.text.endsWith('_dot')) r.fail(`"${token.text}" is the rate of ${token.text.slice(0, -4)}`, token);
  const isFunction = unary.has(token.text) || several.has(token.text) || token.text in {};
  const meaning = RESERVED.get(token.text) ?? (isFunction ? 'is a function' : null);
  if (meaning) r.fail(`"${token.text}" ${meaning}${meaning.includes(';') ? '' : '; take another name'}`, token);
  const known = b.model.names.get(token.text);
  if (known) r.fail(`"${token.text}" is already the ${known.kind} of line ${known.line}`, token);
  return token;
}

const label = (r: Reader): string | undefined => r.takeKind('text')?.text.slice(0, 120);

/** Names of coordinates, as numbers. */
function coordinate(r: Reader, b: Builder): number {
  const token = r.takeKind('name') ?? r.fail('the name of a coordinate is expected here');
  const at = b.model.coordinates.findIndex(({ name }) => name === token.text);
  return at < 0 ? r.fail(`"${token.text}" is no coordinate`, token) : at;
}

function setNames(r: Reader): string[] {
  const ids: string[] = [];
  do ids.push((r.takeKind('name') ?? r.fail('the name of constraints is expected here')).text);
  while (r.take(','));
  return ids;
}

function words(r: Reader, all: readonly string[], one: (word: string) => void): void {
  for (let word = all.find((w) => r.take(w)); word; word = all.find((w) => r.take(w))) one(word);
}

const AXES = ['x', 'y', 'z'] as const;
function axis(r: Reader): 'x' | 'y' | 'z' {
  return AXES.find((name) => r.take(name)) ?? r.fail('an axis is expected here: x, y or z');
}

const COORDINATE_WORDS = ['rest', 'first', 'second', 'held'];
const PARAMETER_WORDS = ['positive', 'from', 'to', 'group', 'note'];
const BODY_WORDS = ['mass', 'inertia', 'at', 'in', 'origin', 'first', 'second'];
const SHAPES: readonly ShapeKind[] = ['box', 'cylinder', 'sphere', 'disc', 'rod', 'path', 'model'];

export const statements: Readonly<Record<string, Statement>> = {
  system: {
    example: 'system "Rolling wheel"',
    read(r, b) {
      b.model.title = label(r) ?? r.fail('the title is expected here, in quotes');
    },
  },
  coordinate: {
    example: 'coordinate theta [rad] = 0.1 "heading"',
    words: COORDINATE_WORDS,
    read(r, b) {
      const names: LineToken[] = [];
      do names.push(newName(r, b, 'coordinate'));
      while (r.take(','));
      const unit = r.takeKind('unit');
      const scale = unit?.text === 'deg' ? Math.PI / 180 : 1;
      const rest = r.take('=') ? b.constant(r, ...COORDINATE_WORDS) * scale : 0;
      let role: 'neutral' | 'first' | 'second' = 'neutral';
      let text = label(r);
      let held = false;
      words(r, ['first', 'second', 'held'], (word) => {
        if (word === 'held') held = true;
        else role = word as 'first';
      });
      text ??= label(r);
      for (const name of names) b.addCoordinate(name, r.line, { unit: unit?.text, rest, label: text, role });
      if (held) b.model.held.push(...names.map((name) => name.text));
    },
  },
  parameter: {
    example: 'parameter m [kg] = 2 positive "mass"',
    words: PARAMETER_WORDS,
    read(r, b) {
      const name = newName(r, b, 'parameter');
      const unit = r.takeKind('unit');
      if (unit) checkUnit(r, unit);
      const angle = isAngleUnit(unit?.text);
      const scale = unit?.text === 'deg' ? Math.PI / 180 : 1;
      r.expect('=', unit ? 'parameter m [kg] = 2' : 'parameter m = 2, and with a unit parameter m [kg] = 2');
      const value = b.constant(r, ...PARAMETER_WORDS) * scale;
      let text = label(r);
      const meta: { positive?: true; min?: number; max?: number; group?: string; note?: string } = {};
      words(r, PARAMETER_WORDS, (word) => {
        if (word === 'positive') meta.positive = true;
        if (word === 'from') meta.min = b.constant(r, ...PARAMETER_WORDS) * scale;
        if (word === 'to') meta.max = b.constant(r, ...PARAMETER_WORDS) * scale;
        if (word === 'group') meta.group = label(r) ?? r.fail('the name of the group is expected here, in quotes');
        if (word === 'note') meta.note = label(r) ?? r.fail('the note is expected here, in quotes');
        text ??= label(r);
      });
      if ((meta.positive && !(value > 0)) || value < (meta.min ?? -Infinity) || value > (meta.max ?? Infinity))
        r.fail(`the default of ${name.text} is outside its own range`, name);
      b.addParameter(name, r.line, { unit: angle ? 'rad' : (unit?.text ?? '1'), angle, value, label: text, ...meta });
    },
  },
  preset: {
    example: 'preset heavy m = 5, l = 2',
    read(r, b) {
      const id = (r.takeKind('name') ?? r.fail('the name of the set of parameters is expected here')).text;
      const values: Record<string, number> = {};
      do {
        const token = r.takeKind('name') ?? r.fail('the name of a parameter is expected here');
        const meta = b.model.parameters.find(({ name }) => name === token.text);
        if (!meta) r.fail(`"${token.text}" is no parameter`, token);
        r.expect('=', this.example);
        values[token.text] = b.constant(r);
      } while (r.take(','));
      b.model.presets[id] = values;
    },
  },
  frame: {
    example: 'frame rod = world turned z theta, y psi, x alpha',
    words: ['turned'],
    read(r, b) {
      const name = newName(r, b, 'frame');
      r.expect('=', this.example);
      let frame: Frame = r.frame();
      while (r.take('turned')) {
        do frame = b.turn(frame, axis(r), r.scalar('turned'), r);
        while (r.take(','));
      }
      b.define(name, r.line, 'frame', { kind: 'frame', frame: { ...frame, name: name.text } });
    },
  },
  point: {
    example: 'point P = O + rod(l, 0, 0)',
    read(r, b) {
      const name = newName(r, b, 'point');
      r.expect('=', this.example);
      b.define(name, r.line, 'point', { kind: 'vector', ids: r.vector() });
    },
  },
  body: {
    example: 'body rod mass m inertia (Ixx, Iyy, Izz) at P in rod "label"',
    words: BODY_WORDS,
    read(r, b) {
      const name = r.takeKind('name') ?? r.fail('the name of the body is expected here');
      if (!NAME.test(name.text) || name.text in {}) r.fail(`"${name.text}" is no name: letters, digits and _`, name);
      if (b.model.bodies.some(({ id }) => id === name.text)) r.fail(`there is already a body "${name.text}"`, name);
      let mass: Id | null = null;
      let inertia: Id[] | null = null;
      let position: Vector | null = null;
      let origin: Vector | null = null;
      let frame: Frame = b.world;
      let role: 'neutral' | 'first' | 'second' = 'neutral';
      let text = label(r);
      const named = b.frameOf(name.text);
      if (named) frame = named;
      words(r, BODY_WORDS, (word) => {
        if (word === 'mass') mass = r.scalar(...BODY_WORDS);
        if (word === 'inertia') inertia = inertias(r);
        if (word === 'at') position = place(r, b, ...BODY_WORDS);
        if (word === 'origin') origin = place(r, b, ...BODY_WORDS);
        if (word === 'in') frame = r.frame();
        if (word === 'first' || word === 'second') role = word;
        text ??= label(r);
      });
      const at = position ?? r.fail('where it is, is missing: at P, its centre of mass', name);
      b.addBody(
        {
          id: name.text,
          label: text ?? name.text,
          position: at,
          origin: origin ?? at,
          frame,
          mass,
          inertia,
          line: r.line,
        },
        role,
      );
    },
  },
  kinetic: {
    example: "kinetic 1/2*m*x'^2",
    read(r, b) {
      const energy = b.ofMotion(
        r,
        r.scalar(),
        'what has none belongs to the line that has, or with the other sign to potential',
      );
      b.model.kinetic = b.graph.add(b.model.kinetic, energy);
      b.model.mechanical = true;
    },
  },
  potential: {
    example: 'potential m*gravity*z',
    read(r, b) {
      b.model.potential = b.graph.add(b.model.potential, b.ofPlace(r, r.scalar()));
      b.model.mechanical = true;
    },
  },
  spring: {
    example: 'spring k on theta free 0.1',
    words: ['on', 'free'],
    read(r, b) {
      const { graph, model } = b;
      const stiffness = r.scalar('on');
      r.expect('on', this.example);
      let stretch = b.ofPlace(r, r.scalar('free'));
      if (r.take('free')) stretch = graph.sub(stretch, r.scalar());
      model.potential = graph.add(
        model.potential,
        graph.mul(graph.mul(graph.number(0.5), stiffness), graph.square(stretch)),
      );
    },
  },
  damper: {
    example: 'damper c on theta',
    words: ['on'],
    read(r, b) {
      const { graph, model } = b;
      const strength = r.scalar('on');
      r.expect('on', this.example);
      const rate = b.rateAt(r, r.scalar());
      model.loss = graph.add(model.loss, graph.mul(graph.mul(graph.number(0.5), strength), graph.square(rate)));
    },
  },
  loss: {
    example: "loss 1/2*c*x'^2",
    read(r, b) {
      b.model.loss = b.graph.add(b.model.loss, b.ofMotion(r, r.scalar(), 'without rates nothing is lost'));
    },
  },
  force: {
    example: 'force F at P along rod.x, or: force F on x',
    words: ['at', 'along', 'on'],
    read(r, b) {
      const force = r.scalar('at', 'on');
      if (r.take('on')) return b.addForce(force, b.rateAt(r, r.scalar()));
      r.expect('at', this.example);
      const velocity = b.ratesAt(r, r.vector('along')) as unknown as Vector;
      r.expect('along', this.example);
      b.addForce(force, dot(b.graph, r.vector(), velocity));
    },
  },
  torque: {
    example: 'torque T on rod along rod.z',
    words: ['on', 'along'],
    read(r, b) {
      const torque = r.scalar('on');
      r.expect('on', this.example);
      const frame = r.frame();
      r.expect('along', this.example);
      b.addForce(torque, dot(b.graph, r.vector(), turned(b.graph, frame.R, frame.spin)));
    },
  },
  input: {
    example: 'input tau [N·m] on alpha + alpha_fp "foot"',
    words: ['on', 'tracks'],
    read(r, b) {
      const name = newName(r, b, 'input');
      const unit = r.takeKind('unit');
      r.expect('on', this.example);
      const column = b.weights(r, r.scalar('tracks'));
      let text = label(r);
      const tracks = r.take('tracks') ? Object.keys(b.weights(r, r.scalar())) : undefined;
      text ??= label(r);
      b.addInput(name, r.line, { unit: unit?.text, column, label: text, tracks });
    },
  },
  constraints: {
    example: 'constraints rolling "Rolling: no slip"',
    read(r, b) {
      const id = r.takeKind('name') ?? r.fail('the name of the constraints is expected here');
      if (id.text === 'none') r.fail('"none" is the name of the system without constraints; take another', id);
      if (!NAME.test(id.text)) r.fail(`"${id.text}" is no name: letters, digits and _`, id);
      if (b.model.sets.some((set) => set.id === id.text)) r.fail(`there are already constraints "${id.text}"`, id);
      b.addSet(id.text, label(r) ?? id.text, r.line);
    },
  },
  velocity: {
    example: 'velocity dot(velocity(P), wheel.y) = 0 in rolling',
    words: ['in'],
    read(r, b) {
      const value = b.ofMotion(r, difference(r, b, 'in'), 'what stays in place is a height: height x = 0');
      const sets = r.take('in') ? setNames(r) : [];
      b.addRow(r, sets, { velocity: value, height: null, solve: null, line: r.line, label: label(r) ?? '' });
    },
  },
  height: {
    example: 'height P.z = 0 in rolling solve z',
    words: ['in', 'solve'],
    read(r, b) {
      const height = b.ofPlace(r, difference(r, b, 'in', 'solve'));
      let sets: string[] = [];
      let solve: number | null = null;
      let text = label(r);
      words(r, ['in', 'solve'], (word) => {
        if (word === 'in') sets = setNames(r);
        else solve = coordinate(r, b);
        text ??= label(r);
      });
      b.addRow(r, sets, { velocity: b.rateAt(r, height), height, solve, line: r.line, label: text ?? '' });
    },
  },
  drive: {
    example: 'drive phi = 0.3*sin(t)',
    read(r, b) {
      const token = r.next;
      const at = coordinate(r, b);
      r.expect('=', this.example);
      const from = r.next;
      b.addDrive(r, token!, at, b.ofTime(r, r.scalar(), from));
    },
  },
  event: {
    example: 'event fallen "it lies on its side" cos(roll) - 0.1',
    words: ['in'],
    read(r, b) {
      const token = r.takeKind('name') ?? r.fail('the name of the event is expected here');
      if (!NAME.test(token.text) || token.text in {})
        r.fail(`"${token.text}" is no name: letters, digits and _`, token);
      if (b.model.events.some(({ id }) => id === token.text))
        r.fail(`there is already an event "${token.text}"`, token);
      let text = label(r);
      const value = r.scalar('in');
      text ??= label(r);
      const sets = r.take('in') ? setNames(r) : [];
      b.model.events.push({ id: token.text, label: text ?? token.text, value, sets, line: r.line });
    },
  },
  shape: {
    example: 'shape rod box (l, w, h) at (0, 0, 0)',
    words: [...SHAPES, 'along', 'at'],
    read(r, b) {
      const token = r.takeKind('name') ?? r.fail('the name of a body is expected here');
      const body = b.model.bodies.findIndex(({ id }) => id === token.text);
      if (body < 0) r.fail(`"${token.text}" is no body`, token);
      const kind = SHAPES.find((name) => r.take(name)) ?? r.fail(`a shape is expected here: ${SHAPES.join(', ')}`);
      const sizes: Id[] = [];
      let along: 'x' | 'y' | 'z' = kind === 'disc' ? 'y' : 'x';
      let at: Vector = [b.graph.zero, b.graph.zero, b.graph.zero];
      const model = kind === 'model' ? (label(r) ?? r.fail('the name of the model is expected here, in quotes')) : null;
      if (kind === 'box') sizes.push(...r.vector('at', 'along'));
      else if (kind === 'path') {
        do sizes.push(...r.vector('at', 'along'));
        while (r.take(','));
      } else if (kind !== 'model') {
        do sizes.push(r.scalar('at', 'along'));
        while (r.take(','));
      }
      words(r, ['along', 'at'], (word) => {
        if (word === 'along') along = axis(r);
        else at = r.vector('along', 'at');
      });
      const wanted = { box: 3, cylinder: 2, sphere: 1, disc: 2, rod: 2, path: null, model: 0 }[kind];
      if (wanted !== null && sizes.length !== wanted)
        r.fail(
          `a ${kind} has ${kind === 'sphere' ? 'a radius' : 'a radius and a length'}: ${wanted} number${wanted === 1 ? '' : 's'}, not ${sizes.length}`,
          token,
        );
      b.addShape(r, { body, kind, sizes, at, axis: along, model, line: r.line });
    },
  },
  track: {
    example: 'track P "front wheel"',
    read(r, b) {
      const token = r.next;
      const name = token?.kind === 'name' ? token.text : '';
      const body = b.model.bodies.findIndex(({ id }) => id === name);
      const whole = [undefined, 'text'].includes(r.tokens[r.at + 1]?.kind);
      if (body >= 0 && whole) {
        r.at++;
        b.model.tracks.push({ body, label: label(r) ?? b.model.bodies[body]!.label });
        return;
      }
      const position = place(r, b);
      b.addTrack(name, position, label(r), r);
    },
  },
  show: {
    example: 'show x, m',
    read(r, b) {
      do {
        const token = r.takeKind('name') ?? r.fail('the name of a coordinate, parameter or input is expected here');
        if (!b.model.names.has(token.text.replace(/(_dot|')$/, ''))) r.fail(`"${token.text}" is not known`, token);
        b.model.shown.push(token.text);
      } while (r.take(','));
    },
  },
  speed: {
    example: 'speed along x, y heading yaw',
    words: ['along', 'heading'],
    read: (r, b) => void (b.model.speed = way(r, b)),
  },
  forward: {
    example: 'forward along x, y heading yaw',
    words: ['along', 'heading'],
    read: (r, b) => void (b.model.forward = way(r, b)),
  },
};

function way(r: Reader, b: Builder): { along: [string, string]; heading: string } {
  const example = 'speed along x, y heading yaw';
  const named = (): string => b.model.coordinates[coordinate(r, b)]!.name;
  r.expect('along', example);
  const first = named();
  r.expect(',', example);
  const second = named();
  r.expect('heading', example);
  return { along: [`${first}_dot`, `${second}_dot`], heading: named() };
}

/** A place: a vector without rates in it. */
function place(r: Reader, b: Builder, ...stops: string[]): Vector {
  const ids = r.vector(...stops);
  for (const id of ids) b.ofPlace(r, id);
  return ids;
}

/** `a = b` as a - b. */
function difference(r: Reader, b: Builder, ...stops: string[]): Id {
  const left = r.scalar(...stops);
  r.expect('=', 'what vanishes ends with "= 0"');
  return b.graph.sub(left, r.scalar(...stops));
}

/** Three about the frame's axes, or xx, yy, zz, xy, xz, yz. */
function inertias(r: Reader): Id[] {
  const open = r.next;
  r.expect('(', 'inertia (Ixx, Iyy, Izz)');
  const parts: Id[] = [];
  do parts.push(r.scalar());
  while (r.take(','));
  r.expect(')', 'inertia (Ixx, Iyy, Izz)');
  if (parts.length !== 3 && parts.length !== 6)
    r.fail(
      `an inertia has three numbers, or six with its products (xx, yy, zz, xy, xz, yz), not ${parts.length}`,
      open,
    );
  return parts;
}

/**
 * `name = …`
 *
 * @param r reads the statement
 * @param b is told what it says
 */
export function readDefinition(r: Reader, b: Builder): void {
  const name = newName(r, b, 'definition');
  r.expect('=', 'J = m*l^2/3');
  const value = r.expression([]);
  b.define(name, r.line, 'definition', value);
}

/**
 * `y' = …`
 *
 * @param r reads the statement
 * @param b is told what it says
 */
export function readRate(r: Reader, b: Builder): void {
  const token = r.takeKind('name')!;
  const name = token.text.replace(/('|_dot)$/, '');
  const at = b.model.coordinates.findIndex((c) => c.name === name);
  if (at < 0) r.fail(`"${name}" is no coordinate: write "coordinate ${name}" on a line above`, token);
  r.expect('=', "y' = -15*y");
  b.addRate(r, token, at, r.scalar());
}
