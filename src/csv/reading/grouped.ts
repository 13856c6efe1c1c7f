/**
 * Numbers with their thousands in groups. Read where there is one meaning: both marks stand in order (`1,234.5`), a mark
 * comes twice (`1,234,567`), or it is no decimal mark anywhere (`1'234`, `1 234`). `1,234` alone could be 1234 or 1.234.
 */

const LONGEST = 40;
const BLANK = "['’\\u0020\\u00a0\\u2009\\u202f]";
const patterns = (group: string, point: string) => ({
  /** The last of the groups has three digits, those before may have two (India). */
  sure: new RegExp(
    `^[+-]?(?:[1-9]\\d{0,2}(?:${group}\\d{2,3})*${group}\\d{3}${point}\\d*|[1-9]\\d{0,2}(?:${group}\\d{2,3})+${group}\\d{3}|[1-9]\\d{0,2}(?:${BLANK}\\d{3})+(?:${point}\\d*)?)$`,
  ),
  bare: new RegExp(`^[+-]?[1-9]\\d{0,2}${group}\\d{3}$`),
});
const BY_POINT = patterns(',', '\\.');
const BY_COMMA = patterns('\\.', ',');

/** @returns the number as plain text with a point, or null where it has no groups or could be another */
export function ungrouped(text: string, decimalComma: boolean, bare = false): string | null {
  if (text.length > LONGEST) return null;
  const { sure, bare: single } = decimalComma ? BY_COMMA : BY_POINT;
  if (!sure.test(text) && !(bare && single.test(text))) return null;
  const digits = text.replace(decimalComma ? /[^\d+,-]/g : /[^\d+.-]/g, '');
  return decimalComma ? digits.replace(',', '.') : digits;
}

/** `1,234`: a thousand and more, or a decimal comma. */
export function isBareGroup(text: string, decimalComma: boolean): boolean {
  return (decimalComma ? BY_COMMA : BY_POINT).bare.test(text);
}
