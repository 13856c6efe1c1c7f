/**
 * A table in JSON as CSV text: an array of records, a record of arrays, `{columns, data}` (pandas, "split"), or one
 * record a line. What is nested gets dotted names. Null for JSON that is no table.
 */
export function jsonTable(text: string): string | null {
  const records = recordsOf(text.replace(/^\ufeff/, '').trim());
  if (!records || records.length === 0) return null;
  const names = new Map<string, number>();
  const rows = records.map((record) => {
    const flat = new Map<string, unknown>();
    flatten(record, '', flat, 0);
    for (const name of flat.keys()) if (!names.has(name)) names.set(name, names.size);
    return flat;
  });
  if (names.size === 0 || names.size > MOST_NAMES) return null;
  const order = [...names.keys()];
  const lines = rows.map((row) => order.map((name) => cell(row.get(name))).join(','));
  return [order.map(quoted).join(','), ...lines].join('\n') + '\n';
}

type Json = Record<string, unknown>;
const isRecord = (value: unknown): value is Json =>
  typeof value === 'object' && value !== null && !Array.isArray(value);
/** More would be lists inside records: no columns of a motion. */
const MOST_NAMES = 2000;
const LONGEST_LIST = 40;
/** Deeper records are no row of a table. */
const DEEPEST = 6;

function recordsOf(text: string): unknown[] | null {
  let value: unknown;
  try {
    value = JSON.parse(text);
  } catch {
    return linesOf(text);
  }
  if (Array.isArray(value)) {
    if (value.every(Array.isArray)) return namedRows(value);
    return value.every((row) => isRecord(row) || Array.isArray(row)) ? value : null;
  }
  if (!isRecord(value)) return null;
  const { columns, data } = value as { columns?: unknown; data?: unknown };
  if (Array.isArray(columns) && Array.isArray(data))
    return data.map((row) => Object.fromEntries(columns.map((name, i) => [String(name), (row as unknown[])?.[i]])));
  const arrays = arraysIn(value, '', 0);
  const [first] = arrays;
  if (!first) return byIndex(value);
  if (arrays.length === 1 && first[1].every(isRecord)) return first[1];
  const length = first[1].length;
  if (arrays.some(([, values]) => values.length !== length)) return null;
  return Array.from({ length }, (_, i) => Object.fromEntries(arrays.map(([name, values]) => [name, values[i]])));
}

/** Arrays at any depth, by dotted names: `{time: […], signals: {x: […]}}`. */
function arraysIn(value: Json, name: string, depth: number): [string, unknown[]][] {
  return Object.entries(value).flatMap(([key, inner]): [string, unknown[]][] => {
    const own = name ? `${name}.${key}` : key;
    if (Array.isArray(inner)) return [[own, inner]];
    return isRecord(inner) && depth < DEEPEST ? arraysIn(inner, own, depth + 1) : [];
  });
}

/** Arrays whose first one holds the names. */
function namedRows(rows: readonly unknown[][]): unknown[] {
  const [names, ...others] = rows;
  if (!names || names.length === 0 || !names.every((name) => typeof name === 'string')) return [...rows];
  return others.map((row) => Object.fromEntries(names.map((name, i) => [name, row[i]])));
}

/** Columns as records by row (pandas, "columns"), or rows as records by name (pandas, "index"). */
function byIndex(value: Json): unknown[] | null {
  const entries = Object.entries(value);
  if (entries.length === 0 || !entries.every(([, inner]) => isRecord(inner))) return null;
  const keys = Object.keys(entries[0]![1] as Json);
  const counted = (names: readonly string[]): boolean => names.length > 1 && names.every((name) => /^\d+$/.test(name));
  if (counted(entries.map(([name]) => name))) return entries.map(([, row]) => row);
  if (!counted(keys)) return null;
  return keys.map((key) => Object.fromEntries(entries.map(([name, inner]) => [name, (inner as Json)[key]])));
}

/** JSON lines; a last line that is cut off is left out. */
function linesOf(text: string): unknown[] | null {
  const records: unknown[] = [];
  const lines = text.split(/\r?\n/).filter((line) => line.trim() !== '');
  for (const [i, line] of lines.entries()) {
    try {
      const value: unknown = JSON.parse(line);
      if (!isRecord(value) && !Array.isArray(value)) return null;
      records.push(value);
    } catch {
      if (i < lines.length - 1 || i === 0) return null;
    }
  }
  return records;
}

function flatten(value: unknown, name: string, into: Map<string, unknown>, depth: number): void {
  if (typeof value !== 'object' || value === null || depth > DEEPEST) {
    into.set(name || 'value', value);
    return;
  }
  if (Array.isArray(value) && value.length > LONGEST_LIST) return;
  for (const [key, inner] of Object.entries(value)) flatten(inner, name ? `${name}.${key}` : key, into, depth + 1);
}

function cell(value: unknown): string {
  if (typeof value === 'number') return String(value);
  if (typeof value === 'boolean') return value ? '1' : '0';
  if (value === undefined || value === null) return '';
  return quoted(typeof value === 'string' ? value : JSON.stringify(value));
}

function quoted(text: string): string {
  const line = text.replace(/[\r\n]+/g, ' ');
  return /[",#]|^\s|\s$/.test(line) ? `"${line.replace(/"/g, '""')}"` : line;
}

/** Why there is no table: where the JSON is none, or that it has another form. */
export function whyNoTable(text: string): string {
  try {
    JSON.parse(text.replace(/^\ufeff/, ''));
  } catch (error) {
    const comma = /,\s*[\]}]\s*$/.test(text.slice(-200)) ? '; a comma stands before the last bracket' : '';
    return `this JSON can't be read: ${(error as Error).message}${comma}`;
  }
  return 'this JSON holds no table; right would be an array of records, [{"t": 0, "x": 0}, …], one record a line, or arrays by name';
}
