/** What a column measures; decides which units it may have. */
export type Kind = 'time' | 'length' | 'angle' | 'length rate' | 'angle rate' | 'plain';

const degree = Math.PI / 180;
const TIMES = new Map([
  ['s', 1],
  ['ms', 1e-3],
  ['us', 1e-6],
  ['µs', 1e-6],
  ['min', 60],
  ['h', 3600],
]);
const LENGTHS = new Map([
  ['m', 1],
  ['mm', 1e-3],
  ['cm', 1e-2],
  ['dm', 0.1],
  ['km', 1e3],
  ['in', 0.0254],
  ['ft', 0.3048],
]);
const ANGLES = new Map([
  ['rad', 1],
  ['mrad', 1e-3],
  ['deg', degree],
  ['°', degree],
  ['rev', 2 * Math.PI],
]);
/** Forces, torques and energies: SI only, there is nothing to convert. */
const PLAIN = new Map([
  ['n', 1],
  ['nm', 1],
  ['n·m', 1],
  ['n*m', 1],
  ['j', 1],
  ['m/s', 1],
]);

/** Units to offer in a message. */
export const RIGHT_UNITS: Record<Kind, string> = {
  time: 's, ms, min',
  length: 'm, mm, cm, km',
  angle: 'rad, deg',
  'length rate': 'm/s, mm/s, cm/s, km/h',
  'angle rate': 'rad/s, deg/s, rpm',
  plain: 'N, N·m, J',
};

/** Factor to SI and radians, or undefined for a unit that is unknown or measures something else. */
export function factorOf(unit: string, kind: Kind): number | undefined {
  const plain = spelledPlainly(unit);
  if (plain === '' || plain === '-' || plain === '1') return 1;
  switch (kind) {
    case 'time':
      return TIMES.get(plain);
    case 'length':
      return LENGTHS.get(plain);
    case 'angle':
      return ANGLES.get(plain);
    case 'plain':
      return PLAIN.get(plain);
    case 'length rate':
    case 'angle rate': {
      if (plain === 'rpm') return kind === 'angle rate' ? Math.PI / 30 : undefined;
      const [above = '', below = '', more] = plain.split('/');
      const [top, bottom] = [(kind === 'angle rate' ? ANGLES : LENGTHS).get(above), TIMES.get(below)];
      return top === undefined || bottom === undefined || more !== undefined ? undefined : top / bottom;
    }
  }
}

function spelledPlainly(unit: string): string {
  return unit
    .trim()
    .toLowerCase()
    .replace(/μ/g, 'µ')
    .replace(/\s*(?:[·*]|\s)\s*s(?:\^?-1|⁻¹)$/, '/s')
    .replace(/\s*(?:\/|\bper\b)\s*/, '/')
    .replace(/degrees?|º/g, 'deg')
    .replace(/radians?/g, 'rad')
    .replace(/\b(?:seconds?|secs?)\b/g, 's')
    .replace(/\b(?:metres?|meters?)\b/g, 'm');
}
