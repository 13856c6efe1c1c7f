import { compileExpression } from './expressions.ts';

const MOST_NAMES = 100;

/** Gathers every error of a raw value by path; helpers return undefined where the value is not right. */
export class Checker {
  readonly errors = new Map<string, string>();

  add(path: string, message: string): undefined {
    if (!this.errors.has(path)) this.errors.set(path, message);
    return undefined;
  }

  /** A plain object's own entries, or nothing. */
  entries(path: string, raw: unknown, known?: readonly string[]): [string, unknown][] {
    if (raw === undefined) return [];
    if (typeof raw !== 'object' || raw === null || Array.isArray(raw)) {
      this.add(path, `must be an object, not ${kindOf(raw)}`);
      return [];
    }
    return Object.entries(raw).filter(([key]) => {
      if (!known || known.includes(key)) return true;
      this.add(join(path, key), unknownName(key, known));
      return false;
    });
  }

  oneOf(path: string, raw: unknown, known: readonly string[]): string | undefined {
    if (raw === undefined) return this.add(path, `is missing; right would be ${known.join(', ')}`);
    if (typeof raw !== 'string') return this.add(path, `must be one of ${known.join(', ')}, not ${kindOf(raw)}`);
    return known.includes(raw) ? raw : this.add(path, unknownName(raw, known));
  }

  names(path: string, raw: unknown, known: readonly string[]): string[] {
    if (raw === undefined) return [];
    if (!Array.isArray(raw)) {
      this.add(path, `must be a list of names, not ${kindOf(raw)}`);
      return [];
    }
    if (raw.length > MOST_NAMES) {
      this.add(path, `${raw.length} names are more than the ${MOST_NAMES} allowed`);
      return [];
    }
    const list = raw.map((item, i) => this.oneOf(`${path}[${i}]`, item, known)).filter((name) => name !== undefined);
    return [...new Set(list)];
  }

  /** A plain finite number within bounds. */
  number(
    path: string,
    raw: unknown,
    rule: { above?: number; least?: number; most?: number; integer?: boolean },
  ): number | undefined {
    if (raw === undefined) return this.add(path, 'is missing; a number is needed');
    if (typeof raw !== 'number') return this.add(path, `must be a number, not ${kindOf(raw)}`);
    if (!Number.isFinite(raw)) return this.add(path, `must be a finite number, not ${raw}`);
    if (rule.above !== undefined && !(raw > rule.above))
      return this.add(path, `must be greater than ${rule.above}, not ${raw}`);
    if (rule.least !== undefined && raw < rule.least)
      return this.add(path, `must be at least ${rule.least}, not ${raw}`);
    if (rule.most !== undefined && raw > rule.most) return this.add(path, `must be at most ${rule.most}, not ${raw}`);
    if (rule.integer && !Number.isInteger(raw)) return this.add(path, `must be a whole number, not ${raw}`);
    return raw;
  }

  /** A number, or a text whose value does not depend on t, as a number. */
  constant(path: string, raw: unknown): number | undefined {
    return this.expression(path, raw, [])?.evaluate(0);
  }

  /** Checks a number or expression of the given variables. */
  expression(path: string, raw: unknown, variables: readonly string[]) {
    if (typeof raw !== 'number' && typeof raw !== 'string')
      return this.add(path, `must be a number or an expression, not ${kindOf(raw)}`);
    try {
      return compileExpression(raw, { variables });
    } catch (error) {
      return this.add(path, (error as Error).message);
    }
  }
}

/**
 * The path of a key, cut where it is too long to show.
 *
 * @param path of the object, '' for the whole
 * @param key within it
 */
export function join(path: string, key: string): string {
  const shown = key.length > 60 ? `${key.slice(0, 59)}…` : key;
  return path ? `${path}.${shown}` : shown;
}

/**
 * What a value is, for the words of an error.
 *
 * @param raw JSON as parsed
 */
export function kindOf(raw: unknown): string {
  if (raw === undefined) return 'missing';
  if (raw === null) return 'null';
  if (Array.isArray(raw)) return 'a list';
  if (typeof raw === 'string') return `the text "${raw.length > 30 ? `${raw.slice(0, 29)}…` : raw}"`;
  return typeof raw === 'object' ? 'an object' : `${typeof raw} ${String(raw)}`;
}

/**
 * Words for a name that is not known, with the nearest one that is.
 *
 * @param name as written
 * @param known names that would be right
 */
export function unknownName(name: string, known: readonly string[]): string {
  const shown = name.length > 40 ? `${name.slice(0, 39)}…` : name;
  const near = known
    .map((k) => [distance(name.slice(0, 40).toLowerCase(), k.toLowerCase()), k] as const)
    .sort((a, b) => a[0] - b[0])[0];
  const guess =
    near && near[0] < near[1].length && near[0] <= Math.max(1, Math.floor(near[1].length / 3))
      ? `did you mean "${near[1]}"? `
      : '';
  return `unknown name "${shown}"; ${guess}right would be ${known.join(', ')}`;
}

/** Edits between two short words; a swap of neighbours, the commonest slip, is one (optimal string alignment). */
function distance(a: string, b: string): number {
  let before: number[] = [];
  let row = Array.from({ length: b.length + 1 }, (_, j) => j);
  for (let i = 1; i <= a.length; i++) {
    const next = [i];
    for (let j = 1; j <= b.length; j++) {
      let least = Math.min(row[j]! + 1, next[j - 1]! + 1, row[j - 1]! + (a[i - 1] === b[j - 1] ? 0 : 1));
      if (i > 1 && j > 1 && a[i - 1] === b[j - 2] && a[i - 2] === b[j - 1]) least = Math.min(least, before[j - 2]! + 1);
      next.push(least);
    }
    [before, row] = [row, next];
  }
  return row[b.length]!;
}
