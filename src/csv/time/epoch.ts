/**
 * Times since 1970 and other large numbers: the first is subtracted before anything is rounded. Nanoseconds since 1970
 * have 19 digits, a double holds 16.
 */

const PATTERN = /^([+-]?)(\d+)(?:[.,](\d*))?$/;
/** Digits of each half of the whole part: both, and their differences, are exact. */
const HALF = 1e9;

export class EpochClock {
  private baseHigh = 0;
  private baseLow = 0;
  private baseFraction = 0;
  private based = false;

  /** The time since the first one read, in the numbers' own unit; NaN for anything but plain digits. */
  since(text: string): number {
    const plain = text.trim();
    const match = PATTERN.exec(/[ed]/i.test(plain) ? withoutExponent(plain) : plain);
    if (!match || match[2]!.length > 24) return NaN;
    const digits = match[2]!;
    const sign = match[1] === '-' ? -1 : 1;
    const high = sign * +digits.slice(0, -9);
    const low = sign * +digits.slice(-9);
    const fraction = match[3] ? sign * +`0.${match[3]}` : 0;
    if (!this.based) {
      this.based = true;
      [this.baseHigh, this.baseLow, this.baseFraction] = [high, low, fraction];
    }
    return (high - this.baseHigh) * HALF + (low - this.baseLow) + (fraction - this.baseFraction);
  }
}

/** `1.744909208e+09` as plain digits: the point moved, nothing rounded. */
function withoutExponent(text: string): string {
  const match = /^([+-]?)(\d+)(?:[.,](\d*))?[ed]([+-]?\d{1,2})$/i.exec(text);
  if (!match) return text;
  const [, sign, whole = '', part = '', power] = match;
  const [digits, point] = [whole + part, whole.length + +power!];
  if (point <= 0 || point > 24) return text;
  return `${sign}${digits.padEnd(point, '0').slice(0, point)}.${digits.slice(point)}`;
}

/** Since 1970, in which unit? By size: years 1990 to 2100. Null where it is no such time. */
export function epochUnit(value: number): 's' | 'ms' | 'us' | 'ns' | null {
  const size = Math.abs(value);
  const [from, to] = [631152000, 4102444800];
  if (size >= from && size < to) return 's';
  if (size >= from * 1e3 && size < to * 1e3) return 'ms';
  if (size >= from * 1e6 && size < to * 1e6) return 'us';
  if (size >= from * 1e9 && size < to * 1e9) return 'ns';
  return null;
}
