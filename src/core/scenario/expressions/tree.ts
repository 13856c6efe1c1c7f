/**
 * An expression as a tree of what is done. Three readings of it stand in files of their own: numbers and rates
 * (`closures.ts`), numbers and rates beyond the range of doubles (`beyondRange.ts`), enclosures over an interval of t
 * (`enclosure.ts`).
 */
export interface Node {
  /** `number`, `t`, an operator's sign, `?` for a choice, or a function's name. */
  readonly op: string;
  readonly args: readonly Node[];
  /** Of a number. */
  readonly x: number;
  readonly constant: boolean;
  /**
   * What a switch (see `decide`) has decided for a stretch of t without switches, so that both its ends are seen from
   * within; NaN while it decides anew at every t.
   */
  decided: number;
}

export const number = (x: number): Node => ({ op: 'number', args: [], x, constant: true, decided: NaN });
/** One of several variables, by its place among them. */
export const named = (place: number): Node => ({ op: 'name', args: [], x: place, constant: false, decided: NaN });
export const variable: Node = { op: 't', args: [], x: NaN, constant: false, decided: NaN };

export const node = (op: string, ...args: Node[]): Node => ({
  op,
  args,
  x: NaN,
  constant: args.every((a) => a.constant),
  decided: NaN,
});

const holds = (test: boolean): number => (test ? 1 : 0);

/** Nodes whose value is smooth but where this number changes: a truth, a side, a whole number. Of their first two parts. */
const decisions: ReadonlyMap<string, (x: number, y: number) => number> = new Map([
  ['<', (x, y) => holds(x < y)],
  ['>', (x, y) => holds(x > y)],
  ['<=', (x, y) => holds(x <= y)],
  ['>=', (x, y) => holds(x >= y)],
  ['==', (x, y) => holds(x === y)],
  ['!=', (x, y) => holds(x !== y)],
  ['sign', (x) => Math.sign(x)],
  ['abs', (x) => (x < 0 ? -1 : 1)],
  ['floor', (x) => Math.floor(x)],
  ['ceil', (x) => Math.ceil(x)],
  ['round', (x) => Math.round(x)],
  // Floored: a remainder has the sign of the divisor, so that mod(t, 2) repeats for negative t as well.
  ['mod', (x, y) => Math.floor(x / y)],
  ['min', (x, y) => holds(y < x)],
  ['max', (x, y) => holds(y > x)],
  ['?', (x) => holds(x !== 0)],
]);

/** What a switch decides from the values of its parts; undefined for what is no switch. */
export const decide = (op: string): ((x: number, y: number) => number) | undefined => decisions.get(op);

/**
 * The switches of a tree, parts before what they are parts of.
 *
 * @param root of the formula's tree
 */
export function switchesOf(root: Node): Node[] {
  const found: Node[] = [];
  const look = (at: Node): void => {
    if (at.constant) return;
    at.args.forEach(look);
    if (decisions.has(at.op)) found.push(at);
  };
  look(root);
  return found;
}
