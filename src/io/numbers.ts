/**
 * A number as CSV text with 17 significant digits, which determine a double uniquely; trailing zeros are left
 * out where that changes nothing. Empty for values that are not finite.
 */
export function writeNumber(x: number): string {
  if (!Number.isFinite(x)) return '';
  if (x === 0) return Object.is(x, -0) ? '-0' : '0';
  const text = x.toPrecision(17);
  if (!text.includes('.')) return text;
  const [mantissa, exponent] = text.split('e') as [string, string?];
  const trimmed = mantissa.replace(/\.?0+$/, '');
  return exponent === undefined ? trimmed : `${trimmed}e${exponent}`;
}

const PLAIN = /^[+-]?(\d+(\.\d*)?|\.\d+)(e[+-]?\d+)?$/i;

/** Value of a cell, or NaN for anything that is not a plain decimal number. Accepts a minus sign as typeset. */
export function readNumber(text: string, decimalComma: boolean): number {
  // The quick way covers nearly every cell; Number() alone would also take blanks, 0x1f and Infinity.
  const first = text.charCodeAt(0);
  const second = text.charCodeAt(1) | 32;
  if (!decimalComma && first >= 43 && first <= 57 && second !== 120 && second !== 98 && second !== 111) {
    const value = +text;
    if (value - value === 0) return value;
  }
  let clean = text.trim().replace(/^[−–]/, '-');
  // In such a file a point would group thousands, or not: it is not guessed.
  if (decimalComma) clean = clean.includes('.') ? '' : clean.replace(',', '.');
  return PLAIN.test(clean) && Number.isFinite(+clean) ? +clean : NaN;
}
