/** What a learner types: a number or a formula, with a unit or without. */
import { evaluateNumber } from '../scenario/expressions.ts';
import { ExpressionError } from '../scenario/expressions/expressionError.ts';

/** Units that mean the same kind of thing, in the first of them. */
const KINDS: readonly Readonly<Record<string, number>>[] = [
  { m: 1, km: 1000, cm: 0.01, mm: 0.001 },
  { 'm/s': 1, 'km/h': 1 / 3.6, 'cm/s': 0.01 },
  { s: 1, ms: 0.001, min: 60 },
  { N: 1, kN: 1000, mN: 0.001 },
  { rad: 1, deg: Math.PI / 180, '°': Math.PI / 180 },
  { 'rad/s': 1, 'deg/s': Math.PI / 180, '°/s': Math.PI / 180 },
  { '1/s': 1, 'rad/s': 1 },
  { kg: 1, g: 0.001 },
  { J: 1, kJ: 1000 },
];

/**
 * A typed answer in the unit of its question; null with the reason where it is none.
 *
 * @param text as typed: `pi/8`, `22.5 deg`, `30 cm`, `0,3`
 * @param unit of the question
 */
export function readTyped(text: string, unit: string): { value: number } | { fault: string } {
  const given = text
    .trim()
    .replace(/^(-?\d+),(\d+)/, '$1.$2')
    .replace('−', '-');
  if (given === '') return { fault: 'type a number' };
  const kind = KINDS.find((units) => units[unit] === 1);
  const units = Object.entries(kind ?? { [unit]: 1 }).sort(([a], [b]) => b.length - a.length);
  for (const [name, factor] of [...units, ['', 1] as const]) {
    if (!given.endsWith(name)) continue;
    const formula = given.slice(0, given.length - name.length).trim();
    if (formula === '') continue;
    try {
      const value = evaluateNumber(formula) * factor;
      if (Number.isFinite(value)) return { value };
    } catch (error) {
      if (!(error instanceof ExpressionError)) throw error;
    }
  }
  return { fault: `this is no number${unit === '1' ? '' : ` in ${unit}`}` };
}

/**
 * @param value in the question's unit
 * @param answer that was computed
 * @param tolerance relative
 */
export const isRight = (value: number, answer: number, tolerance: number): boolean =>
  Math.abs(value - answer) <= tolerance * Math.max(Math.abs(answer), 1e-9);
