/** Columns of an attitude as a quaternion, by their names. */
export interface Quaternion {
  /** Columns of x, y, z and w, the scalar. */
  columns: readonly [number, number, number, number];
  /** Which number is the scalar was not said by the names. */
  doubtful: boolean;
}

const WORDS = '(?:q|quat|quaternion|orientation|rotation|rot|attitude|att)';
const LETTER_LAST = new RegExp(`^(.*?)${WORDS}[\\s._:/-]*([wxyzijkr])$`, 'i');
const LETTER_FIRST = new RegExp(`^(.*?)([wxyz])[\\s._-]*${WORDS}$`, 'i');
const DIGIT = new RegExp(`^(.*?)${WORDS}[\\s._:/-]*(?:q|e)?[[(]?([0-4])[\\])]?$`, 'i');
const LETTERS: Record<string, 'x' | 'y' | 'z' | 'w'> = {
  i: 'x',
  j: 'y',
  k: 'z',
  r: 'w',
  x: 'x',
  y: 'y',
  z: 'z',
  w: 'w',
};

/** @param names without units; those of a group as `Rotation.X` */
export function quaternionsIn(names: readonly string[]): Quaternion[] {
  const lettered = new Map<string, Map<string, number>>();
  const numbered = new Map<string, Map<number, number>>();
  const put = <K>(to: Map<string, Map<K, number>>, key: string, part: K, column: number): void => {
    const group = to.get(key) ?? new Map<K, number>();
    to.set(key, group);
    if (!group.has(part)) group.set(part, column);
  };
  for (const [column, name] of names.entries()) {
    if (name.length > 80) continue;
    const letter = LETTER_LAST.exec(name) ?? LETTER_FIRST.exec(name);
    if (letter) put(lettered, letter[1]!.toLowerCase(), LETTERS[letter[2]!.toLowerCase()]!, column);
    const digit = DIGIT.exec(name);
    if (digit) put(numbered, digit[1]!.toLowerCase(), +digit[2]!, column);
  }
  const found: Quaternion[] = [];
  for (const group of lettered.values()) {
    const columns = ['x', 'y', 'z', 'w'].map((part) => group.get(part));
    if (columns.every((column) => column !== undefined))
      found.push({ columns: columns as [number, number, number, number], doubtful: false });
  }
  for (const group of numbered.values()) {
    const at = (k: number): number | undefined => group.get(k);
    // q0 is the scalar wherever there is one; of q1 to q4 the last, in the books that count so.
    const order = at(0) !== undefined && at(4) === undefined ? [1, 2, 3, 0] : at(0) === undefined ? [1, 2, 3, 4] : null;
    const columns = order?.map(at);
    if (columns?.every((column) => column !== undefined))
      found.push({ columns: columns as [number, number, number, number], doubtful: order![3] === 4 });
  }
  return found;
}
