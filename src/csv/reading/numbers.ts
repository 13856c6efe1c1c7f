import { ungrouped } from './grouped.ts';

/**
 * A number as CSV text with 17 significant digits, which determine a double uniquely; trailing zeros are left
 * out where that changes nothing. Empty for values that are not finite.
 */
export function writeNumber(x: number): string {
  if (!Number.isFinite(x)) return '';
  // Whole numbers of up to 15 digits are exact as they are.
  if (Number.isInteger(x) && Math.abs(x) < 1e15) return Object.is(x, -0) ? '-0' : String(x);
  const text = x.toPrecision(17);
  const exponent = text.indexOf('e');
  let end = exponent < 0 ? text.length : exponent;
  if (text.lastIndexOf('.', end) < 0) return text;
  while (text.charCodeAt(end - 1) === 48) end--;
  if (text.charCodeAt(end - 1) === 46) end--;
  return exponent < 0 ? text.slice(0, end) : text.slice(0, end) + text.slice(exponent);
}

const PLAIN = /^[+-]?(\d+(\.\d*)?|\.\d+)([ed][+-]?\d+)?$/i;

/**
 * Value of a cell, or NaN for anything that is not a finite decimal number (blank, hexadecimal, infinite, units). Accepts a
 * minus sign as typeset, Fortran's `D` before the exponent, its exponents of three digits without a letter, powers of ten
 * as computer algebra writes them (`1.5*^-3`, `1.5×10^-3`), and groups of thousands that have one meaning.
 */
export function readNumber(text: string, decimalComma: boolean): number {
  const value = +text;
  // The quick way covers nearly every cell: a digit, sign or point first; no 0x10, 0b1, 0o7 (a letter second).
  const first = text.charCodeAt(0);
  if (value - value === 0 && !decimalComma && first >= 43 && first <= 57) {
    const second = text.charCodeAt(1);
    if (!(second > 57) || second === 101 || second === 69) return value;
  }
  let clean = text.trim().replace(/^[−–]/, '-');
  const cell = clean;
  if (decimalComma) clean = clean.includes('.') ? '' : clean.replace(',', '.');
  const careful = PLAIN.test(clean) ? +clean.replace(/d/i, 'e') : unusual(cell, decimalComma);
  return careful - careful === 0 ? careful : NaN;
}

const POWER = /^([+-]?[\d.]+)(?:\*\^|\s*[×x*·]\s*10\^?)\{?([+\-−]?\d+)\}?$/;
const NO_LETTER = /^([+-]?\d*\.\d*)([+-]\d{3})$/;

function unusual(text: string, decimalComma: boolean): number {
  const last = text.charCodeAt(text.length - 1);
  // Nearly all that comes here are words.
  if (last !== 125 && last !== 46 && last !== 44 && !(last >= 48 && last <= 57)) return NaN;
  const plain = ungrouped(text, decimalComma);
  if (plain !== null) return +plain;
  const point = decimalComma ? text.replace(',', '.') : text;
  const power = POWER.exec(point) ?? NO_LETTER.exec(point);
  return power ? +`${power[1]}e${power[2]!.replace('−', '-')}` : NaN;
}
