/**
 * A system's equations as marked LaTeX, which the derivation writes (`derivation/typeset.py`): every symbol of the model
 * stands as `\s{name}`, its letter in `symbols`.
 */
export interface Typeset {
  system: string;
  symbols: Readonly<Record<string, string>>;
  /** Abbreviations and vectors that the formulas below use. */
  letters: readonly string[];
  contacts: readonly string[];
  frames: readonly { id: string; attitude: string; angular: string }[];
  bodies: readonly TypesetBody[];
  energies: { kinetic?: string; potential?: string; lagrangian?: string };
  /** The equations one by one, where they are small. */
  motion: readonly string[];
  /** What M, h, gamma and lambda are made of. */
  structure: readonly string[];
  losses: readonly string[];
  /** The upper triangle of a mass matrix too large for `motion`: what can be read, and how long the rest is. */
  mass: {
    entries: readonly { row: string; column: string; latex: string }[];
    left: readonly { row: string; column: string; operations: number }[];
  } | null;
  constraints: readonly TypesetConstraints[];
}

export interface TypesetBody {
  id: string;
  mass: string;
  inertia: string | null;
  attitude: string;
  position: string;
  velocity: string;
  angular?: string;
  kinetic?: string;
}

export interface TypesetConstraints {
  /** Of the constraint set. */
  id: string;
  rows: readonly {
    title: string;
    latex: string;
    entries: readonly { column: string; latex?: string; operations?: number }[];
  }[];
  heights: readonly string[];
}

/** One line per system here, as in `loaders.ts`. */
const loaders: Readonly<Record<string, () => Promise<{ default: unknown }>>> = {
  ripstik: () => import('./ripstik/typeset.generated.json'),
  'caster-rotation': () => import('./caster-rotation/typeset.generated.json'),
  'cart-pendulum': () => import('./cart-pendulum/typeset.generated.json'),
  'rolling-wheel': () => import('./rolling-wheel/typeset.generated.json'),
  'stiff-decay': () => import('./stiff-decay/typeset.generated.json'),
  'wheel-pendulum': () => import('./wheel-pendulum/typeset.generated.json'),
  'casterboard-robot': () => import('./casterboard-robot/typeset.generated.json'),
  'chaplygin-sleigh': () => import('./chaplygin-sleigh/typeset.generated.json'),
  bicycle: () => import('./bicycle/typeset.generated.json'),
};

/** A system's equations, or undefined where there is none of that name. */
export function loadTypeset(id: string): Promise<Typeset> | undefined {
  return Object.hasOwn(loaders, id) ? loaders[id]!().then((module) => module.default as Typeset) : undefined;
}

const MARK = /\\s\{([^}]+)\}/g;

/** Marked LaTeX with `set(name, letter)` in place of every mark. */
export function setMarks(
  latex: string,
  symbols: Typeset['symbols'],
  set: (name: string, letter: string) => string = (_, letter) => letter,
): string {
  return latex.replace(MARK, (_, name: string) => set(name, symbols[name] ?? String.raw`\text{${name}}`));
}

/** The marks of a formula, each once, in the order in which they stand. */
export function marksOf(latex: string): string[] {
  return [...new Set([...latex.matchAll(MARK)].map((found) => found[1]!))];
}
