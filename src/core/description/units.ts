import type { Reader } from './expression.ts';
import type { LineToken } from './tokens.ts';

const UNIT = /^[A-Za-z0-9µμΩΩ·.*/^⁻¹²³⁴°%() -]{0,24}$/;

export const isAngleUnit = (unit: string | undefined): boolean => unit === 'deg' || unit === 'rad';

/**
 * A unit is shown, not computed with.
 *
 * @param r reads the statement
 * @param unit its token
 */
export function checkUnit(r: Reader, unit: LineToken): void {
  if (!UNIT.test(unit.text))
    r.fail(`"${unit.text.slice(0, 24)}" is no unit: letters, digits and · / ^, such as N·m/rad`, unit);
}
