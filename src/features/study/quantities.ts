/** The columns of a sweep's results as they are read: symbol, name, unit, and how a value is written. */
import { columnOf, shownFactor, shownUnit, symbolOf } from '../../core/motion/columns.ts';
import { placeSymbol } from '../../core/motion/placeSymbol.ts';
import { plainText, words as plain, type Text } from '../../core/motion/symbols.ts';
import type { SystemMeta } from '../../core/model/system.ts';
import { checkScenario } from '../../core/scenario/schema.ts';
import { sweepPaths, type SweepPath } from '../../core/scenario/sweepPaths.ts';
import type { StudyColumn, StudyResults } from '../../core/sweep/studyResults.ts';
import { formatScientific, formatShort, THIN } from '../../ui/kit/format.ts';
import { text } from '../../ui/words.ts';
import { words } from './words.ts';

export interface Quantity {
  /** Of the column. */
  id: string;
  /** With its unit, as it stands at an axis. */
  title: Text;
  symbol: Text;
  /** In words, without unit. */
  label: string;
  unit: string;
  /** From SI to what is shown. */
  factor: number;
  values: StudyColumn;
  /** Words of a column of words, in the order of their colours; null for numbers. */
  kinds: readonly string[] | null;
  /** In a sentence, with its unit. */
  say(row: number): string;
  /** In a table. */
  cell(row: number): string;
}

/** By the name of the column, in the order of the file. */
export type Quantities = ReadonlyMap<string, Quantity>;

interface Naming {
  symbol: Text;
  label: string;
  unit: string;
  factor: number;
}

const DEGREE = Math.PI / 180;

export function quantitiesOf(
  results: StudyResults,
  metas: Readonly<Record<string, SystemMeta>>,
  degrees: boolean,
): Quantities {
  const { study, columns } = results;
  const file = study?.scenario(0);
  const meta = file && metas[file.system];
  let paths: readonly SweepPath[] = [];
  try {
    if (meta) paths = sweepPaths(meta, file, checkScenario(file, metas));
  } catch {
    // A first run that is refused has its row; its places go by their names.
  }
  const naming = (id: string): Naming => {
    if (meta && study?.paths.includes(id)) return placeNaming(id, meta, paths, degrees);
    return (meta && measureNaming(id, meta, degrees)) ?? plainNaming(id);
  };
  return new Map([...columns].map(([id, values]) => [id, quantity(id, naming(id), values)]));
}

function placeNaming(id: string, meta: SystemMeta, paths: readonly SweepPath[], degrees: boolean): Naming {
  const first = id.split('+')[0]!;
  const found = paths.find(({ path }) => path === id) ?? paths.find(({ path }) => path.split('+')[0] === first);
  const turned = found?.angle && !degrees ? found.unit.replace('°', 'rad') : (found?.unit ?? '');
  const short = first.replace(/^(parameters|initial)\./, '');
  return {
    symbol: placeSymbol(id, short, meta),
    label: found?.label ?? short,
    unit: turned,
    factor: found?.angle && degrees ? 1 / DEGREE : 1,
  };
}

function measureNaming(id: string, meta: SystemMeta, degrees: boolean): Naming | null {
  const [, kind, name] = /^(final|max|min)\.(.+)$/.exec(id) ?? [];
  if (!kind || !name) return null;
  const of = columnOf(meta, name);
  const said = words.kinds[kind as keyof typeof words.kinds];
  return {
    symbol: [...plain(`${said} `), ...symbolOf(of)],
    label: `${said} ${of.label}`,
    unit: shownUnit(of, degrees),
    factor: shownFactor(of, degrees),
  };
}

function plainNaming(id: string): Naming {
  const known: Readonly<Record<string, readonly [string, string]>> = {
    ...words.facts,
    index: [words.index, ''],
    time: [words.time, 's'],
    reason: [words.reason, ''],
  };
  const [label, unit] = known[id] ?? [id, ''];
  return { symbol: plain(label), label, unit, factor: 1 };
}

function quantity(id: string, naming: Naming, values: StudyColumn): Quantity {
  const { symbol, unit, factor } = naming;
  const kinds = values instanceof Float64Array ? null : kindsOf(values);
  const word = (value: string): string =>
    id === 'reason' ? (value === 'refused' ? value : (text.status.reasons[value] ?? value)) : value;
  const cell = (row: number): string => {
    const value = values[row]!;
    return typeof value === 'string' ? word(value) : written(value * factor);
  };
  return {
    ...naming,
    id,
    title: unit === '' ? symbol : [...symbol, ...plain(`, ${unit}`)],
    values,
    kinds,
    cell,
    say: (row) => {
      const shown = kinds || unit === '' ? cell(row) : `${cell(row)}${THIN}${unit}`;
      return `${plainText(symbol)}${kinds ? ':' : ' ='} ${shown}`;
    },
  };
}

/** `end`, where there is one, first, the others by how often they come. */
function kindsOf(values: readonly string[]): string[] {
  const counts = new Map<string, number>();
  for (const value of values) counts.set(value, (counts.get(value) ?? 0) + 1);
  counts.set('end', counts.has('end') ? Infinity : 0);
  return [...counts]
    .filter(([, count]) => count > 0)
    .sort(([, a], [, b]) => b - a)
    .map(([kind]) => kind);
}

/** A number, as short as it is told apart from its neighbours. */
export const written = (x: number): string =>
  Number.isNaN(x)
    ? '–'
    : x !== 0 && (Math.abs(x) < 1e-3 || Math.abs(x) >= 1e6)
      ? formatScientific(x, 3)
      : formatShort(x, 5);

/** The name of a kind as it stands beside its colour. */
export const kindName = ({ id }: Quantity, kind: string): string =>
  id === 'reason' ? (text.status.reasons[kind] ?? kind) : kind;
