/**
 * Times written as text. A date is a whole number of days since 1970, a clock is seconds since midnight: apart, no digit
 * of a fraction is lost.
 */

export interface Moment {
  /** Since 1970-01-01, or 0 where only a clock is given. */
  days: number;
  /** Of the day. */
  seconds: number;
}

/** Which of two numbers that could both be a month is the day. */
export type DateOrder = 'day first' | 'month first';

const LONGEST = 48;
/** Digits of `20250417`, the one date that is a number too. */
const COMPACT_LENGTH = 8;
const isPlainNumber = (text: string): boolean => !Number.isNaN(+text);
const CLOCK = /^([+-])?(?:(\d{1,5}):)?(\d{1,5}):(\d{1,2})(?:[.,:](\d{1,9}))?\s*([ap]\.?\s?m\.?)?$/i;
const DURATION =
  /^P?(?:(\d+(?:[.,]\d+)?)\s*d(?:ays?)?,?)?\s*T?(?:(\d+(?:[.,]\d+)?)\s*h)?\s*(?:(\d+(?:[.,]\d+)?)\s*m(?:in)?)?\s*(?:(\d+(?:[.,]\d+)?)\s*s(?:ec)?)?$/i;
const DAYS_AND_CLOCK = /^(\d+)\s*(?:d|days?)?,?\s+(\d+:\d+:\d+.*)$/i;
const ISO_DATE = /^(\d{4})[-/.](\d{1,2})[-/.](\d{1,2})$/;
const COMPACT_DATE = /^((?:19|20)\d{2})(\d{2})(\d{2})$/;
const OTHER_DATE = /^(\d{1,2})[-/.](\d{1,2})[-/.](\d{4}|\d{2})$/;
const NAMED_DATE = /^(\d{1,2})[-.\s]+(?:de\s+)?(\p{L}{3,10})[-.,\s]+(?:de\s+)?(\d{4})$/iu;
/** `Apr 17, 2025`, `April 17 2025`. */
const MONTH_FIRST = /^(\p{L}{3,10})\.?[-\s]+(\d{1,2})(?:st|nd|rd|th)?[-,\s]+(\d{4})$/iu;
const WEEKDAY = /^(?:mon|tue|wed|thu|fri|sat|sun)[a-z]*[.,]?\s+/i;
/** `Apr 17 10:30:20 2025`: the year stands behind the clock (C's `ctime`). */
const YEAR_LAST = /^([a-z]{3}\s+\d{1,2})\s+(\S+)(?:\s+[A-Z]{3,4})?\s+(\d{4})$/i;
/** `20250417T103020.5`. */
const COMPACT = /^((?:19|20)\d{6})[T_\s-]?(\d{2})(\d{2})(\d{2})(\d{3})?(?=[^\d]|$)/;
/** `10-30-20.5` behind a date. */
const HYPHENS = /^(\d{1,2})[.-](\d{2})[.-](\d{2})(?!\d)/;
/** Beginnings of the months' names in English, German, French, Spanish, Italian, Dutch and Portuguese. */
const MONTHS: readonly RegExp[] = [
  /^(?:jan|ene|gen)/,
  /^f[eé][bv]/,
  /^(?:mar|mär|maa|mrt)/,
  /^a[pbv]r/,
  /^(?:ma[yijg]|mei)/,
  /^(?:jun|juin|giu)/,
  /^(?:jul|juil|lug)/,
  /^(?:aug|ao[uû]|ago)/,
  /^se[pt]/,
  /^(?:o[ck]t|ott|out)/,
  /^nov/,
  /^d[eéi][cz]/,
];
const BOTH =
  /^(\S+(?:[\s-](?:de\s+)?\p{L}{3,10}\.?,?[\s-](?:de\s+)?\d{4})?|\p{L}{3,10}\.?\s+\d{1,2}\S*\s+\d{4})(?:T|,?\s+|_|-(?=\d\d:))([+-]?\d{1,2}[:.-]\d{2}.*)$/iu;
const ZONE = /\s*(?:Z|UTC|GMT|([+-])(\d{2}):?(\d{2})?)$/i;

/** `[h:]m:s[.f]` (also with am, pm), `1h 2m 3s`, `PT1.5S`, `2 days 01:02:03`: in seconds, or null. */
export function clockSeconds(text: string): number | null {
  if (text.length > LONGEST || isPlainNumber(text)) return null;
  const clock = CLOCK.exec(text);
  if (clock) {
    const [, sign, hours = '0', minutes, seconds, fraction, half] = clock;
    if (+seconds! >= 61 || (clock[2] !== undefined && +minutes! >= 60)) return null;
    let h = +hours;
    if (half) h = (h % 12) + (/^p/i.test(half) ? 12 : 0);
    const whole = 3600 * h + 60 * +minutes! + +seconds!;
    const value = fraction === undefined ? whole : Number(`${whole}.${fraction}`);
    return sign === '-' ? -value : value;
  }
  const days = DAYS_AND_CLOCK.exec(text);
  if (days) {
    const rest = clockSeconds(days[2]!);
    return rest === null ? null : 86400 * +days[1]! + rest;
  }
  if (!/[a-z]/i.test(text) || !/\d/.test(text)) return null;
  const duration = DURATION.exec(text);
  if (!duration) return null;
  const [d, h, m, s] = duration.slice(1).map((part) => (part === undefined ? 0 : +part.replace(',', '.')));
  return 86400 * d! + 3600 * h! + 60 * m! + s!;
}

/** A date in days since 1970, or null. Where a day and a month could be either, `order` decides. */
export function dateDays(text: string, order: DateOrder = 'day first'): number | null {
  if (text.length > LONGEST || (isPlainNumber(text) && text.length !== COMPACT_LENGTH)) return null;
  const iso = ISO_DATE.exec(text) ?? COMPACT_DATE.exec(text);
  if (iso) return days(+iso[1]!, +iso[2]!, +iso[3]!);
  const named = NAMED_DATE.exec(text);
  if (named) {
    const month = monthOf(named[2]!);
    return month < 0 ? null : days(+named[3]!, month + 1, +named[1]!);
  }
  const american = MONTH_FIRST.exec(text);
  if (american) {
    const month = monthOf(american[1]!);
    return month < 0 ? null : days(+american[3]!, month + 1, +american[2]!);
  }
  const other = OTHER_DATE.exec(text);
  if (!other) return null;
  const [a, b] = [+other[1]!, +other[2]!];
  const year = other[3]!.length === 2 ? 2000 + +other[3]! : +other[3]!;
  const monthFirst = b > 12 || (a <= 12 && order === 'month first');
  return monthFirst ? days(year, a, b) : days(year, b, a);
}

/** Whether day and month of a date could be exchanged. */
export function isAmbiguousDate(text: string): boolean {
  const date = BOTH.exec(text.trim())?.[1] ?? text.trim();
  const match = OTHER_DATE.exec(date);
  return match !== null && +match[1]! <= 12 && +match[2]! <= 12 && match[1] !== match[2] && !date.includes('.');
}

/** `20250417103020.5`: a number, and yet a date with a clock. */
export function isStamp(text: string): boolean {
  return /^(?:19|20)\d{12}(?:\d{3})?(?:[.,]\d+)?$/.test(text) && moment(text) !== null;
}

/** A date with a clock, `2025-04-17T17:00:08.020Z`, or one of the two; null for anything else. */
export function moment(text: string, order: DateOrder = 'day first'): Moment | null {
  // Nearly all that comes here are names and numbers.
  if (text.length > LONGEST || text.length < 3 || !/\d/.test(text)) return null;
  const plain = text
    .trim()
    .replace(WEEKDAY, '')
    .replace(YEAR_LAST, '$1 $3 $2')
    .replace(
      COMPACT,
      (_, date: string, h: string, m: string, s: string, ms?: string) => `${date} ${h}:${m}:${s}${ms ? `.${ms}` : ''}`,
    );
  const match = BOTH.exec(plain);
  if (match) {
    const date = dateDays(match[1]!, order);
    if (date !== null) {
      const zone = ZONE.exec(match[2]!);
      let clock = zone ? match[2]!.slice(0, zone.index) : match[2]!;
      // Motion capture writes `06.23.40.000`; a day's minute may stand without seconds.
      clock = clock.replace(HYPHENS, '$1:$2:$3');
      if (/^\d{1,2}:\d{2}$/.test(clock)) clock += ':00';
      const seconds = clockSeconds(clock.trim());
      if (seconds === null) return null;
      const shift = zone?.[1] ? (zone[1] === '-' ? 1 : -1) * (3600 * +zone[2]! + 60 * +(zone[3] ?? 0)) : 0;
      return { days: date, seconds: seconds + shift };
    }
  }
  const date = dateDays(plain, order);
  if (date !== null) return { days: date, seconds: 0 };
  const seconds = clockSeconds(plain);
  return seconds === null ? null : { days: 0, seconds };
}

const monthOf = (name: string): number => MONTHS.findIndex((month) => month.test(name.toLowerCase()));

function days(year: number, month: number, day: number): number | null {
  const time = Date.UTC(year, month - 1, day);
  const back = new Date(time);
  if (back.getUTCMonth() !== month - 1 || back.getUTCDate() !== day) return null;
  return time / 86400000;
}
