/** Columns of an attitude, by their names. */
export interface Attitude {
  /** Of a quaternion x, y, z and w, the scalar; of Euler angles those about x, y and z. */
  columns: readonly number[];
  /** Order of the turns of Euler angles, each about the axes turned before (`XYZ`); null for a quaternion. */
  euler: string | null;
  /** Which number of a quaternion is the scalar was not said by the names. */
  doubtful: boolean;
}

const WORDS = '(?:q|quat|quaternion|orientation|rotation|rot|attitude|att)';
/** Frames may stand between, `q_RS_w`. */
const LETTER_LAST = new RegExp(`^(.*?)${WORDS}((?:_[a-z0-9]+){0,3}?)[\\s._:/-]*([wxyzijkr])$`, 'i');
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

/**
 * @param names without units; those of a group as `Rotation.X`
 * @param euler order of turns that the lines above the table give to three columns `Rotation.X`, or null
 */
export function attitudesIn(names: readonly string[], euler: string | null): Attitude[] {
  const lettered = new Map<string, Map<string, number>>();
  const numbered = new Map<string, Map<number, number>>();
  const indexed = new Set<string>();
  const put = <K>(to: Map<string, Map<K, number>>, key: string, part: K, column: number): void => {
    const group = to.get(key) ?? new Map<K, number>();
    to.set(key, group);
    if (!group.has(part)) group.set(part, column);
  };
  for (const [column, name] of names.entries()) {
    if (name.length > 80) continue;
    const last = LETTER_LAST.exec(name);
    const letter = last ?? LETTER_FIRST.exec(name);
    const key = last ? last[1]! + last[2]! : letter?.[1];
    if (letter) put(lettered, key!.toLowerCase(), LETTERS[letter.at(-1)!.toLowerCase()]!, column);
    const digit = DIGIT.exec(name);
    if (digit) put(numbered, digit[1]!.toLowerCase(), +digit[2]!, column);
    if (digit && /[.[]\d\]?$/.test(name)) indexed.add(digit[1]!.toLowerCase());
  }
  const found: Attitude[] = [];
  for (const group of lettered.values()) {
    const columns = ['x', 'y', 'z', 'w'].map((part) => group.get(part));
    if (columns.every((column) => column !== undefined)) found.push({ columns, euler: null, doubtful: false });
    else if (euler && columns.slice(0, 3).every((column) => column !== undefined))
      found.push({ columns: columns.slice(0, 3) as number[], euler, doubtful: false });
  }
  for (const [key, group] of numbered) {
    // q0 is the scalar wherever there is one; parts of an array and q1 to q4 have it first or last.
    const order = group.has(0) && !group.has(4) ? [1, 2, 3, 0] : group.has(0) ? [] : [1, 2, 3, 4];
    const doubtful = order[3] === 4 || indexed.has(key);
    const columns = (doubtful && order[3] === 0 ? [0, 1, 2, 3] : order).map((k) => group.get(k));
    if (columns.length === 4 && columns.every((column) => column !== undefined))
      found.push({ columns, euler: null, doubtful });
  }
  return found;
}

/**
 * The scalar first or last? By how upright the body then is: on wheels it seldom lies on its side.
 * @param rows of four numbers, in the order of their columns
 * @param up 1: the second axis of the file points up, 2: the third
 */
export function scalarFirst(rows: readonly (readonly number[])[], up: 1 | 2): boolean {
  const upright = (parts: readonly number[]): number => {
    let sum = 0;
    for (const row of rows) {
      const norm = row.reduce((s, q) => s + q * q, 0);
      // One minus twice the squares of the two horizontal parts: the upward axis's share of up.
      const [a, b] = [row[parts[0]!]!, row[parts[3 - up]!]!];
      if (norm > 0) sum += 1 - (2 * (a * a + b * b)) / norm;
    }
    return sum;
  };
  return upright([1, 2, 3]) > upright([0, 1, 2]) + 1e-9 * rows.length;
}
