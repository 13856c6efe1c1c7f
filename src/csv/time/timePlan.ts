import type { Layout } from '../layout/layout.ts';
import { formOf } from '../layout/cells.ts';
import { stepOf } from '../layout/preamble.ts';
import type { ImportChoices, Question, TimeForm, TimePlan } from '../plan.ts';
import { isMeant, type Source } from '../source.ts';
import { factorOf, RIGHT_UNITS } from '../units/units.ts';
import { unitBehind } from '../units/titles.ts';
import { readNumber } from '../reading/numbers.ts';
import { clockSeconds, dateDays, isAmbiguousDate, isStamp, moment } from './clock.ts';
import { epochUnit } from './epoch.ts';
import {
  CALENDAR,
  calendarPart,
  isDateName,
  isFrameName,
  isIndexName,
  isRestOfSecond,
  isStepName,
  timeRank,
  unitInTimeName,
} from './timeNames.ts';
import { typicalStep } from './order.ts';

export interface TimeFinding {
  time: TimePlan;
  questions: Question[];
  notes: string[];
}

/** Rows a second that the report's player drew. */
export const OFFERED_STEP = 1 / 60;

interface Column {
  source: Source;
  rank: number;
  /** Shares of its filled cells. */
  numbers: number;
  moments: number;
  dates: number;
  clocks: number;
  cells: string[];
}

/** Finds the time of a table by names, units and cells. A text says what is wrong with it. */
export function timeOf(layout: Layout, sources: readonly Source[], choices: ImportChoices): TimeFinding | string {
  const rows = layout.rows;
  const comma = layout.decimal === ',';
  const column = (source: Source): Column => {
    const cells = rows
      .map((row) => (row[source.index] ?? '').trim())
      .filter((cell) => formOf(cell, comma) !== 'missing');
    const share = (is: (cell: string) => boolean): number =>
      cells.length ? cells.filter(is).length / cells.length : 0;
    const clocks = share((cell) => Number.isNaN(readNumber(cell, comma)) && clockSeconds(cell) !== null);
    const dates = share((cell) => dateDays(cell) !== null);
    return {
      source,
      rank: rankOf(source),
      numbers: share((cell) => !Number.isNaN(readNumber(cell, comma)) && !isStamp(cell)),
      moments: share((cell) => (Number.isNaN(readNumber(cell, comma)) && moment(cell) !== null) || isStamp(cell)),
      dates,
      clocks,
      cells,
    };
  };
  if (choices.time === null) return counted(layout, choices, null);
  if (typeof choices.time === 'string') {
    const wanted = choices.time;
    const parts = sources.some((source) => isMeant(source, wanted)) ? [wanted] : wanted.split(/[+,]/);
    const found = parts.map((part) => sources.find((source) => isMeant(source, part)));
    if (found.some((source) => !source))
      return `there is no column "${wanted}" to take the time from; there are ${sources
        .map((s) => s.name)
        .slice(0, 12)
        .join(', ')}`;
    const columns = found.map((source) => column(source!));
    if (columns.length === 2) return dated(columns[0]!, columns[1]!, choices);
    if (isFrameName(columns[0]!.source.name) && choices.step) return counted(layout, choices, columns[0]!.source);
    return single(columns[0]!, choices, comma);
  }
  const named = sources.filter((s) => rankOf(s) < 9 || isDateName(s.name)).map(column);
  const parts = calendarColumns(sources, (source) => column(source).numbers > 0.9);
  if (parts) return finding(parts, 'parts', '', 1, []);
  const date =
    named.find((c) => isDateName(c.source.name) && c.dates > 0.5) ??
    named.find((c) => c.dates > 0.8 && c.numbers < 0.5);
  const clock = date && named.filter((c) => c !== date && c.clocks > 0.5).sort((a, b) => a.rank - b.rank)[0];
  if (date && clock) return dated(date, clock, choices);
  const usable = named
    .filter((c) => c.rank < 9 && c.numbers + c.moments > 0.5)
    .sort((a, b) => a.rank - b.rank || a.source.index - b.source.index);
  const dates = named.find((c) => isDateName(c.source.name) && c.moments > 0.5);
  if (usable[0]) {
    const rest = sources.find((s) => isRestOfSecond(usable[0]!.source.plain, s.plain));
    return rest ? parted(usable[0].source, rest) : single(usable[0], choices, comma);
  }
  if (dates) return single(dates, choices, comma);
  const count = named.find(
    (c) => isDateName(c.source.name) && c.numbers > 0.5 && (countsDays(c.cells, comma) || sinceEpoch(c.cells, comma)),
  );
  if (count) return single(count, choices, comma);
  const others = sources.map(column).find((c) => c.moments > 0.8 && (c.clocks > 0.8 || c.dates < 0.5));
  if (others) return single(others, choices, comma);
  // Named a time, but without a number that shows it: the rows will say why.
  const empty = named.find((c) => c.rank <= 1);
  if (empty && (empty.cells.length > 0 || stepOf(layout.properties) === null)) return single(empty, choices, comma);
  const steps = choices.step === undefined ? sources.find((s) => isStepName(s.name)) : undefined;
  if (steps && column(steps).numbers > 0.9) {
    const found = single(column(steps), choices, comma);
    if (typeof found === 'string') return found;
    const { unit, factor } = found.time;
    const each = finding([steps.index], 'steps', unit, factor, []);
    each.notes.push(`"${steps.title}" holds the time since the row before: it is summed`);
    return each;
  }
  const rising = choices.step === undefined ? unnamedTime(layout, sources, comma) : null;
  if (rising) {
    const found = single(column(rising), choices, comma);
    if (typeof found !== 'string')
      found.notes.push(
        `${rising.title === '' ? 'the first column has no name and' : `"${rising.title}"`} rises evenly: it is taken for the time`,
      );
    return found;
  }
  return counted(layout, choices, sources.find((s) => isFrameName(s.name) && column(s).numbers > 0.5) ?? null);
}

/** A column each for year, month, day, hour, minute and second, or for the last three or two of them. */
function calendarColumns(sources: readonly Source[], isNumeric: (source: Source) => boolean): number[] | null {
  const found = CALENDAR.map((_, part) => sources.findIndex((s) => calendarPart(s.plain) === part));
  for (const from of [0, 3, 4]) {
    const columns = found.slice(from);
    const together = columns.every((column, i) => column >= 0 && (i === 0 || column === columns[i - 1]! + 1));
    if (together && columns.every((column) => isNumeric(sources[column]!))) return columns;
  }
  return null;
}

/** A first column without a name that rises evenly, though not by whole rows: numpy's and pandas' times. */
function unnamedTime({ rows, titles }: Layout, [first, second]: readonly Source[], comma: boolean): Source | null {
  if (!first || !second || (titles && !isIndexName(first.plain) && first.title !== '')) return null;
  const t = rows.map((row) => readNumber(row[first.index] ?? '', comma)).filter((x) => x === x);
  if (t.length < 3 || t.length < 0.9 * rows.length) return null;
  const step = typicalStep(t);
  const uneven = t.some((x, i) => i > 0 && !(x > t[i - 1]! && Math.abs(x - t[i - 1]! - step) < 0.5 * step));
  return uneven || step === 1 ? null : first;
}

/** Seconds and what is behind their point, in two columns (ROS). */
function parted(seconds: Source, rest: Source): TimeFinding {
  const unit = /^(?:n|na)/i.test(rest.plain.split(/[./_]/).at(-1)!) ? 'ns' : 'us';
  return finding([seconds.index, rest.index], 'epoch', unit, factorOf(unit, 'time')!, []);
}

/** The surer, the lower; 9 where nothing tells of time. */
function rankOf(source: Source): number {
  if (isStepName(source.name)) return 9;
  const { name, unit, rowUnit } = source;
  const last = name.split('.').at(-1)!;
  const rank =
    timeRank(name) ??
    timeRank(unitBehind(name)?.name ?? '') ??
    (last !== name ? timeRank(last) : null) ??
    timeRank(last.split(/[/:\s]/).at(-1)!);
  if (rank !== null) return rank;
  const measured = unit || rowUnit;
  return measured !== '' && /^\s*(?:n|µ|u|m)?s(?:ec(?:onds?)?)?\s*$/i.test(measured) ? 5 : 9;
}

function dated(date: Column, clock: Column, choices: ImportChoices): TimeFinding {
  return finding([date.source.index, clock.source.index], 'date and clock', '', 1, dateQuestions(date.cells, choices));
}

function single(column: Column, choices: ImportChoices, comma: boolean): TimeFinding | string {
  const { source, cells } = column;
  const { index } = source;
  if (column.moments > column.numbers)
    return finding([index], column.clocks > 0.5 ? 'clock' : 'date-time', '', 1, dateQuestions(cells, choices));
  const behind = unitBehind(source.name);
  const unit =
    choices.units?.['t'] ??
    choices.units?.[source.name] ??
    choices.timeUnit ??
    (source.unit ||
      (behind && timeRank(behind.name) !== null ? behind.unit : '') ||
      source.rowUnit ||
      unitInTimeName(source.name));
  const factor = factorOf(unit, 'time');
  if (factor === undefined)
    return `column ${index + 1}, "${source.title}": the unit "${unit}" is not understood for t; right would be ${RIGHT_UNITS.time}`;
  const values = cells.map((cell) => readNumber(cell, comma)).filter((x) => !Number.isNaN(x));
  const middle = [...values].sort((a, b) => a - b)[values.length >> 1] ?? 0;
  const since = epochUnit(middle);
  if (since && (unit === '' || factorOf(since, 'time') === factor)) {
    const taken = finding([index], 'epoch', since, factorOf(since, 'time')!, []);
    if (unit === '') taken.notes.push(`times are ${since} since 1970, as their size says; the first is 0`);
    return taken;
  }
  if (unit === '' && isDayCount(middle, typicalStep(values), isDateName(source.name))) {
    const days = finding([index], 'epoch', 'd', 86400, []);
    days.notes.push('times are days of a calendar, as their size says; the first is 0');
    return days;
  }
  if (unit === '' && isCompactClock(values, /utc|gps|gmt|hhmmss|nmea/i.test(source.title)))
    return finding([index], 'compact clock', '', 1, []);
  const questions = unit === '' && typicalStep(values) > 1 ? [unitQuestion(source, typicalStep(values))] : [];
  return finding([index], 'number', unit, factor, questions);
}

function sinceEpoch(cells: readonly string[], comma: boolean): boolean {
  const values = cells.map((cell) => readNumber(cell, comma)).filter((x) => x === x);
  return values.length > 1 && values.every((x) => epochUnit(x) !== null);
}

function countsDays(cells: readonly string[], comma: boolean): boolean {
  const values = cells.map((cell) => readNumber(cell, comma)).filter((x) => x === x);
  return values.length > 1 && values.every((x) => isDayCount(x, 0, true)) && typicalStep(values) < 1;
}

/** A spreadsheet's or MATLAB's count of days: no clock in seconds starts so high and steps so finely. */
function isDayCount(value: number, step: number, named: boolean): boolean {
  const calendar = (value > 20000 && value < 80000) || (value > 700000 && value < 800000);
  return calendar && (named || (step > 0 && step < 2e-5));
}

/** `103059.5`: ten thirty and 59.5 seconds, as receivers of satellites write. Seen by a minute that begins at 60. */
function isCompactClock(values: readonly number[], named: boolean): boolean {
  const within = (x: number): boolean => x >= 0 && x < 240000 && x % 100 < 60 && Math.floor(x / 100) % 100 < 60;
  const turns = values.filter((x, i) => i > 0 && x > values[i - 1]! && x % 100 < values[i - 1]! % 100).length;
  const clock = values.length > 1 && values.every(within);
  return clock && (named ? values.some((x) => x >= 10000) : turns > 0 && values[0]! >= 10000);
}

function counted(layout: Layout, choices: ImportChoices, frames: Source | null): TimeFinding {
  const given = stepOf(layout.properties);
  const step = choices.step ?? given;
  const form: TimeForm = frames ? 'frame' : 'counted';
  const time: TimePlan = {
    columns: frames ? [frames.index] : [],
    form,
    unit: '',
    factor: step ?? OFFERED_STEP,
    step: step ?? OFFERED_STEP,
  };
  const notes = [];
  if (choices.step !== undefined) notes.push(`no time column: ${frames ? 'frames' : 'rows'} ${choices.step} s apart`);
  else if (given !== null)
    notes.push(
      `no time column: ${frames ? 'frames' : 'rows'} ${+given.toPrecision(6)} s apart, as the lines above the table say`,
    );
  const rows = frames ? 'frames' : 'rows';
  const questions: Question[] =
    step === null || step === undefined
      ? [
          {
            id: 'time-step',
            text: `There is no time column: how far apart are the ${rows}?`,
            answers: [60, 30, 50, 100, 200, 1000].map((rate) => ({
              label: `1/${rate} s`,
              choices: { step: 1 / rate },
            })),
            safest: 0,
            first: true,
          },
        ]
      : [];
  return { time, questions, notes };
}

function finding(columns: number[], form: TimeForm, unit: string, factor: number, questions: Question[]): TimeFinding {
  return { time: { columns, form, unit, factor, step: null }, questions, notes: [] };
}

function unitQuestion(source: Source, step: number): Question {
  return {
    id: 'time-unit',
    text: `The times in "${source.title}" have no unit and rows are ${+step.toPrecision(4)} apart: which unit is it?`,
    answers: [
      { label: 'seconds', choices: { timeUnit: 's' } },
      { label: 'milliseconds', choices: { timeUnit: 'ms' } },
      { label: 'microseconds', choices: { timeUnit: 'us' } },
      { label: 'nanoseconds', choices: { timeUnit: 'ns' } },
    ],
    safest: 0,
    first: false,
  };
}

function dateQuestions(cells: readonly string[], { dateOrder }: ImportChoices): Question[] {
  if (dateOrder) return [];
  const different = new Set(cells.map((cell) => cell.split(/[T\s]/)[0]));
  if (different.size < 2 || !cells.every(isAmbiguousDate)) return [];
  return [
    {
      id: 'date-order',
      text: `Is ${[...different][0]!} day/month or month/day?`,
      answers: [
        { label: 'day/month', choices: { dateOrder: 'day first' } },
        { label: 'month/day', choices: { dateOrder: 'month first' } },
      ],
      safest: 0,
      first: false,
    },
  ];
}
