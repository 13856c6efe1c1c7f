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
  /** Of h, where the system was typed: what can be read, and how long the rest is. */
  forces?: readonly { row: string; latex?: string; operations?: number }[];
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
    /** Its entry of gamma, where the system was typed and it can be read. */
    gamma?: string;
  }[];
  heights: readonly string[];
}

const MARK = /\\s\{([^}]+)\}/g;

/**
 * Marked LaTeX with `set(name, letter)` in place of every mark.
 *
 * @param latex marked LaTeX
 * @param symbols of the system, by name
 * @param set gives the LaTeX of a mark
 */
export function setMarks(
  latex: string,
  symbols: Typeset['symbols'],
  set: (name: string, letter: string) => string = (_, letter) => letter,
): string {
  return latex.replace(MARK, (_, name: string) => set(name, symbols[name] ?? String.raw`\text{${name}}`));
}

/**
 * The marks of a formula, each once, in the order in which they stand.
 *
 * @param latex marked LaTeX
 */
export function marksOf(latex: string): string[] {
  return [...new Set([...latex.matchAll(MARK)].map((found) => found[1]!))];
}
