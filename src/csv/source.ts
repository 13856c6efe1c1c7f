import { unitInRow, type Layout } from './layout/layout.ts';
import { splitTitle, unitBehind } from './units/titles.ts';

/** A column of a file before it has a meaning. */
export interface Source {
  index: number;
  title: string;
  /** With the group it stands in, without the unit; unique. */
  name: string;
  /** The same, where it need not be unique. */
  plain: string;
  /** In its title, or ''. */
  unit: string;
  /** In a row of units, or ''. */
  rowUnit: string;
}

/** Words and numbers above columns that tell no two of them apart. */
const EMPTY_GROUP = /^(?:rigid ?body|bone|marker|rigid body marker|type|name|id|\d+|[0-9a-f]{16,})$/i;

const LONGEST_RUN = 100;
/** `x (m) Run #1`, `Run 1: x (m)`: a school's loggers name the run beside each column. */
function runIn(title: string): [run: string, rest: string] {
  if (title.length > LONGEST_RUN || !/run|trial|set|take|latest/i.test(title)) return ['', title];
  const behind = /^(.*\S)[\s,_-]+((?:run|trial|set|data ?set|take)\s*#?\s*\d+)$/i.exec(title);
  if (behind) return [behind[2]!, behind[1]!];
  const before = /^((?:run|trial|set|data ?set|take)\s*#?\s*\d+|latest)\s*[:.,_-]\s*(.+)$/i.exec(title);
  return before ? [before[1]!, before[2]!] : ['', title];
}

export function sourcesOf(layout: Layout): Source[] {
  const taken = new Set<string>();
  return Array.from({ length: layout.width }, (_, index) => {
    const title = (layout.titles?.[index] ?? '').trim();
    const [run, rest] = runIn(title);
    const split = splitTitle(rest);
    const own = split.name === '' && split.unit === '' ? `column ${index + 1}` : split.name;
    const group = layout.groups
      .map((names) => names[index] ?? '')
      .filter((name) => name !== '' && !EMPTY_GROUP.test(name));
    const plain = [...(run === '' ? [] : [run]), ...group, own].join('.');
    let name = plain;
    for (let k = 2; taken.has(name); k++) name = `${plain} (${k})`;
    taken.add(name);
    return { index, title, name, plain, unit: split.unit, rowUnit: unitInRow(layout.units?.[index] ?? '') };
  });
}

/** The title as a name is looked up by: with its group, and its unit in brackets. */
export function lookedUp(source: Source): string {
  return source.unit === '' ? source.plain : `${source.plain} [${source.unit}]`;
}

/** Whether words of a person mean a column: its name, its title, its name without a unit, or its number. */
export function isMeant(source: Source, words: string): boolean {
  const wanted = words.trim().toLowerCase();
  return (
    source.name.toLowerCase() === wanted ||
    source.title.toLowerCase() === wanted ||
    unitBehind(source.name)?.name.toLowerCase() === wanted ||
    `column ${source.index + 1}` === wanted
  );
}
