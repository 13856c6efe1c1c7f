import type { ImportChoices, TimePlan } from '../plan.ts';
import { readNumber } from '../reading/numbers.ts';
import { moment, type Moment } from './clock.ts';
import { EpochClock } from './epoch.ts';

/** The time of a row from its cells, in seconds from the first one; NaN where there is none. */
export type TimeReader = (cells: readonly string[]) => number;

const HALF_DAY = 43200;

/** For times that are no plain numbers; null where a number times a factor is the time. */
export function timeReaderOf(time: TimePlan, choices: ImportChoices, comma: boolean): TimeReader | null {
  const [first = -1, second = -1] = time.columns;
  switch (time.form) {
    case 'number':
    case 'counted':
      return null;
    case 'frame': {
      let base: number | null = null;
      return (cells) => {
        const frame = readNumber(cells[first] ?? '', comma);
        if (Number.isNaN(frame)) return NaN;
        base ??= frame;
        return (frame - base) * time.factor;
      };
    }
    case 'steps': {
      let sum: number | null = null;
      return (cells) => {
        const step = readNumber(cells[first] ?? '', comma) * time.factor;
        if (step === step) sum = sum === null ? 0 : sum + step;
        return step === step ? sum! : NaN;
      };
    }
    case 'compact clock': {
      let [base, last, days]: [number | null, number, number] = [null, -Infinity, 0];
      return (cells) => {
        const x = readNumber(cells[first] ?? '', comma);
        const clock = 3600 * Math.floor(x / 10000) + 60 * (Math.floor(x / 100) % 100) + (x % 100);
        base ??= Number.isNaN(clock) ? null : clock;
        let since = clock - (base ?? 0) + 86400 * days;
        if (since < last - HALF_DAY) {
          days++;
          since += 86400;
        }
        if (since === since) last = since;
        return Math.round(since * 1e6) / 1e6;
      };
    }
    case 'parts': {
      let [base, last, days]: [number | null, number, number] = [null, -Infinity, 0];
      const dated = time.columns.length === 6;
      return (cells) => {
        const parts = time.columns.map((column) => readNumber(cells[column] ?? '', comma));
        const [second = NaN, minute = NaN, hour = 0] = parts.slice(-3).reverse();
        const day = dated ? Date.UTC(parts[0]!, parts[1]! - 1, parts[2]) / 86400000 : 0;
        const clock = 86400 * day + 3600 * hour + 60 * minute + second;
        base ??= Number.isNaN(clock) ? null : clock;
        let since = clock - (base ?? 0) + 86400 * days;
        // Hours begin again at midnight, minutes alone after an hour.
        const around = dated ? Infinity : time.columns.length === 3 ? 86400 : 3600;
        if (since < last - around / 2) {
          days += around / 86400;
          since += around;
        }
        if (since === since) last = since;
        return Math.round(since * 1e9) / 1e9;
      };
    }
    case 'epoch': {
      const clock = new EpochClock();
      // Seconds in one column, the digits behind the point in the next: 17 and 5 are 17.000000005.
      const digits = time.unit === 'us' ? 6 : 9;
      return (cells) => {
        const part = second < 0 ? '' : (cells[second] ?? '').trim().padStart(digits, '0');
        if (second >= 0 && part.length > digits) return NaN;
        const text = `${(cells[first] ?? '').trim()}${part}`;
        const since = clock.since(comma ? text.replace(',', '.') : text);
        return since * time.factor;
      };
    }
    default: {
      let [base, last, days]: [Moment | null, number, number] = [null, -Infinity, 0];
      return (cells) => {
        const text =
          second >= 0 ? `${(cells[first] ?? '').trim()} ${(cells[second] ?? '').trim()}` : (cells[first] ?? '');
        const now = moment(text, choices.dateOrder);
        if (!now) return NaN;
        base ??= now;
        let since = (now.days - base.days) * 86400 + (now.seconds - base.seconds);
        // A clock without a date begins again at midnight.
        if (time.form === 'clock') {
          since += 86400 * days;
          if (since < last - HALF_DAY) {
            days++;
            since += 86400;
          }
          last = since;
        }
        // Text has nine decimals at the most; the rest is what subtracting left.
        return Math.round(since * 1e9) / 1e9;
      };
    }
  }
}
