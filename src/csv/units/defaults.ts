import { valueOf, type Property } from '../layout/preamble.ts';
import { factorOf, type Kind } from './units.ts';

/** The unit that the lines above a table give to all columns of a kind, or ''. */
export function defaultUnit(properties: readonly Property[], kind: Kind): string {
  if (kind === 'time' || kind === 'plain') return '';
  const [base, rate] = kind.split(' ') as [Kind, string?];
  const found = base === 'angle' ? angleUnit(properties) : lengthUnit(properties);
  if (found === '' || factorOf(found, base) === undefined) return '';
  return rate ? `${found}/s` : found;
}

/** Qualisys writes millimetres and degrees without saying so. */
function isQualisys(properties: readonly Property[]): boolean {
  return (
    valueOf(properties, /^NO_OF_FRAMES$/i) !== null &&
    valueOf(properties, /^(?:DATA_INCLUDED|NO_OF_CAMERAS|NO_OF_BODIES)$/i) !== null
  );
}

function angleUnit(properties: readonly Property[]): string {
  const degrees = valueOf(properties, /^in ?degrees$/i);
  if (degrees !== null) return /^(?:yes|true|1)/i.test(degrees) ? 'deg' : 'rad';
  const said = valueOf(
    properties,
    /^(?:angles?|angular|rotation) ?units?$|^units? (?:of|for) (?:angles?|rotations?)$/i,
  );
  if (said !== null) return said;
  // Motive's angles, and Xsens's, are degrees.
  if (isQualisys(properties) || valueOf(properties, /^Rotation Type$/i) !== null) return 'deg';
  return valueOf(properties, /^Filter Profile$/i) !== null ? 'deg' : '';
}

function lengthUnit(properties: readonly Property[]): string {
  const said = valueOf(
    properties,
    /^(?:length|position|translation|distance|marker) ?units?$|^units? (?:of|for) (?:lengths?|positions?)$/i,
  );
  return said ?? (isQualisys(properties) ? 'mm' : '');
}
