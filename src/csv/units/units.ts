import { remembered } from '../names/remembered.ts';

/** What a column measures; decides which units it may have. */
export type Kind = 'time' | 'length' | 'angle' | 'length rate' | 'angle rate' | 'plain';

const degree = Math.PI / 180;
const TIMES = new Map([
  ['s', 1],
  ['ms', 1e-3],
  ['us', 1e-6],
  ['µs', 1e-6],
  ['ns', 1e-9],
  ['min', 60],
  ['h', 3600],
  ['d', 86400],
]);
const LENGTHS = new Map([
  ['m', 1],
  ['mm', 1e-3],
  ['cm', 1e-2],
  ['dm', 0.1],
  ['km', 1e3],
  ['in', 0.0254],
  ['ft', 0.3048],
  ['µm', 1e-6],
  ['um', 1e-6],
]);
const ANGLES = new Map([
  ['rad', 1],
  ['mrad', 1e-3],
  ['deg', degree],
  ['°', degree],
  ['rev', 2 * Math.PI],
  ['turn', 2 * Math.PI],
  ['gon', Math.PI / 200],
]);
/** Of what no coordinate measures: known as units, so that a row or the end of a title is seen to be one. */
const OTHERS = new Set(
  'kg g mg lb v mv a ma w kw hz khz k °c °f % pa kpa bar t µt ut gauss px counts count m/s2 m/s^2 m/s² mm/s2 mm/s^2 mm/s² rad/s2 rad/s^2 rad/s² deg/s2 deg/s^2 deg/s² °/s2 °/s² nm/rad ns n·s kn lbf quat frames'.split(
    ' ',
  ),
);
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

/** What a number without a unit is. */
export const SI_UNITS: Record<Kind, string> = {
  time: 's',
  length: 'm',
  angle: 'rad',
  'length rate': 'm/s',
  'angle rate': 'rad/s',
  plain: '',
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

/** Accents away: a word's end is then told by letters alone. */
const unaccented = (text: string): string => text.normalize('NFD').replace(/[\u0300-\u036f]/g, '');
const words = (unit: string, spelled: string): [string, string][] =>
  spelled.split(' ').map((word) => [unaccented(word), unit]);
/** Units as other languages spell them. */
const WORDS = new Map([
  ...words('deg', 'graus graden grader stopnie stopni stupně stupne astetta derece град градусы градусов 度 °'),
  ...words('rad', 'radianos radialen radiany radianer рад радианы радиан 弧度 ラジアン'),
  ...words('m', 'м метр метры метров metr metry metrów metrar 米 公尺 メートル'),
  ...words('mm', 'мм milímetros milimetros millimetri millimètres millimètre milimetry 毫米 ミリメートル'),
  ...words('cm', 'см centímetros centimetros centimetri centimètres centymetry 厘米 センチメートル'),
  ...words('km', 'км quilómetros quilômetros chilometri kilomètres 公里'),
  ...words('s', 'с сек секунд секунды seconden sekunder sekundy sekund saniye 秒'),
  ...words('ms', 'мс милисекунд milisegundos millisecondi milliseconden millisecondes milisekundy 毫秒 ミリ秒'),
  ...words('us', 'мкс microsegundos microsecondi microseconden microsecondes mikrosekunden 微秒 マイクロ秒'),
  ...words('ns', 'нс nanosegundos nanosecondi nanosecondes nanosekunden 纳秒'),
  ...words('min', 'мин minuti minutos minuty 分 分钟'),
  // Signs that a wrong character set made of a degree, and an inch's.
  ...words('deg', 'â° ¡ ø ﾟ \ufffd ï¿½'),
  ...words('in', '" ″ ”'),
  ...words('h', 'ч час godziny horas heures ore uren 时 時 小时'),
]);

const spelledPlainly = remembered(spelledOut);

function spelledOut(unit: string): string {
  return (
    unaccented(unit)
      .trim()
      // The German degree; in lower case it may be a gon.
      .replace(/^Grad\b/, 'deg')
      .toLowerCase()
      .replace(/μ/g, 'µ')
      .replace(/\s*(?:[·*]|\s)\s*s(?:\^?-1|⁻¹)$/, '/s')
      .replace(/\s*(?:\/|\bper\b)\s*/, '/')
      .replace(/degrees?|grados?|gradi|º/g, 'deg')
      .replace(/radians?|radiant|radiants?|radianes|radianti/g, 'rad')
      .replace(/\b(?:seconds?|secs?|sekunden?|secondes?|segundos?|secondi)\b/g, 's')
      .replace(/\b(?:milliseconds?|millis|msecs?|millisekunden?)\b/g, 'ms')
      .replace(/\b(?:microseconds?|micros|usecs?)\b/g, 'us')
      .replace(/\b(?:nanoseconds?|nanos|nsecs?)\b/g, 'ns')
      .replace(/\b(?:minutes?|mins|minuten)\b/g, 'min')
      .replace(/\b(?:hours?|hrs?|stunden?)\b/g, 'h')
      .replace(/\bdays?\b/g, 'd')
      .replace(/\b(?:millimet(?:re|er)s?)\b/g, 'mm')
      .replace(/\b(?:centimet(?:re|er)s?)\b/g, 'cm')
      .replace(/\b(?:kilomet(?:re|er)s?)\b/g, 'km')
      .replace(/\b(?:metres?|meters?|metros?|metri)\b/g, 'm')
      .replace(/\b(?:inch(?:es)?)\b/g, 'in')
      .replace(/\b(?:foot|feet)\b/g, 'ft')
      .replace(/\b(?:turns|revs?|revolutions?|umdrehung(?:en)?)\b/g, 'rev')
      .split('/')
      .map((part) => WORDS.get(part) ?? part)
      .join('/')
  );
}

/** Whether text is the unit of anything. */
export function isUnit(text: string): boolean {
  if (text.length > 40) return false;
  const plain = spelledPlainly(text.replace(/^[[({<](.*)[\])}>]$/, '$1'));
  if (plain === '' || plain.length > 12) return false;
  if (OTHERS.has(plain)) return true;
  return KINDS.some((kind) => plain !== '-' && plain !== '1' && factorOf(plain, kind) !== undefined);
}

const KINDS: readonly Kind[] = ['time', 'length', 'angle', 'length rate', 'angle rate', 'plain'];

/** What a unit measures, or null for one that no coordinate has. */
export function kindOf(unit: string): Kind | null {
  return KINDS.find((kind) => factorOf(unit, kind) !== undefined) ?? null;
}
