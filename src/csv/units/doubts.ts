import type { Question } from '../plan.ts';
import { extentOf } from '../reading/extent.ts';

/** A column whose unit nothing says. */
export interface Unsaid {
  name: string;
  kind: 'length' | 'angle';
  data: Float64Array;
}

/** Wheels turn on and on: their angles are large in radians too. */
const SPINS = /spin|^phi$|^theta_c|wheel/i;
/** More than half a turn, where a path does not show the heading. */
const HALF_TURN = Math.PI;
/** A plate or a rod that swings beyond this lies on its back. */
const UPSIDE_DOWN = 1.6;
/** m/s, typical over a file: no board and no bicycle is so fast. */
const FASTEST = 60;
/** m within which one moves in a laboratory. */
const FARTHEST = 20;

/**
 * Angles and lengths without a unit are radians and metres; where their numbers look like degrees or millimetres, that
 * is asked. A heading that follows the path decides by itself: turned along it, its numbers are radians, or 57 times so.
 */
export function doubtsOf(columns: readonly Unsaid[], t: Float64Array): Question[] {
  const questions: Question[] = [];
  const angles = columns.filter(({ kind, name }) => kind === 'angle' && !SPINS.test(name));
  const position = (axis: RegExp): Unsaid | undefined =>
    columns.find(({ kind, name }) => kind === 'length' && axis.test(name));
  const [x, y] = [position(/^x$/i), position(/^y$/i)];
  const heading = angles.find(({ name }) => name === 'theta' || name === 'yaw');
  const ratio = x && y && heading ? headingRatio(x.data, y.data, heading.data) : null;
  const inRadians = ratio !== null && ratio > 0.4 && ratio < 2.5;
  const inDegrees = ratio !== null && ratio > 0.4 / 57.3 && ratio < 2.5 / 57.3;
  const large = angles.filter((angle) => {
    if (angle === heading && inRadians) return false;
    const size = extent(angle.data).largest;
    if (size > 2 * 360 * 20) return false;
    return size > HALF_TURN || (size > UPSIDE_DOWN && swings(angle.data));
  });
  if (inDegrees || large.length > 0) {
    const shown = large[0] ?? heading!;
    questions.push({
      id: 'degrees',
      text: `The angles have no unit, and ${shown.name} reaches ${+extent(shown.data).largest.toPrecision(4)}: are these degrees?`,
      answers: [
        { label: 'radians', choices: { angles: 'rad' } },
        { label: 'degrees', choices: { angles: 'deg' } },
      ],
      safest: 0,
      first: false,
    });
  }
  if (x && y) {
    const speed = typicalSpeed(x.data, y.data, t);
    const far = (): number => Math.max(extent(x.data).range, extent(y.data).range);
    if (speed > FASTEST && far() > FARTHEST)
      questions.push({
        id: 'lengths',
        text: `The lengths have no unit, and metres would make it ${+speed.toPrecision(3)} m/s fast: are these millimetres?`,
        answers: [
          { label: 'metres', choices: { lengths: 'm' } },
          { label: 'centimetres', choices: { lengths: 'cm' } },
          { label: 'millimetres', choices: { lengths: 'mm' } },
        ],
        safest: 0,
        first: false,
      });
  }
  return questions;
}

/** Largest size, and the way from the least to the most. */
function extent(data: Float64Array): { largest: number; range: number } {
  const { low, high } = extentOf(data);
  return { largest: Math.max(0, -low, high), range: high - low };
}

/** Whether a column goes to and fro: its way is longer than twice its range. */
function swings(data: Float64Array): boolean {
  let way = 0;
  for (let i = 1; i < data.length; i++) {
    const step = Math.abs(data[i]! - data[i - 1]!);
    if (step - step === 0) way += step;
  }
  return way > 2 * extent(data).range;
}

/** Rows of a path that are looked at: hundreds for each of its pieces. */
const MOST_POINTS = 20000;
/** Pieces, and squares of their turns (rad²), that are enough to know the ratio. */
const ENOUGH_PIECES = 200;
const ENOUGH_TURNED = 1;

/** Turning of the path per unit of turning of the heading (least squares), or null where too little turns or moves. */
function headingRatio(x: Float64Array, y: Float64Array, heading: Float64Array): number | null {
  // Points a hundredth of the path apart: noise turns short pieces anyhow.
  const far = Math.hypot(extent(x).range, extent(y).range) / 100;
  if (!(far > 0)) return null;
  const stride = Math.max(1, Math.floor(x.length / MOST_POINTS));
  let [last, turned, product, square, pieces] = [0, NaN, 0, 0, 0];
  let before = 0;
  for (let i = stride; i < x.length; i += stride) {
    const dx = x[i]! - x[last]!;
    const dy = y[i]! - y[last]!;
    if (!(dx * dx + dy * dy >= far * far)) continue;
    const direction = Math.atan2(dy, dx);
    const middle = heading[(i + last) >> 1]!;
    if (turned === turned) {
      const turn = direction - turned;
      const path = turn - 2 * Math.PI * Math.round(turn / (2 * Math.PI));
      const head = middle - before;
      product += path * head;
      square += head * head;
      pieces++;
      // Degrees for radians would have turned 3000 times as much.
      if (pieces >= ENOUGH_PIECES && square > ENOUGH_TURNED) break;
    }
    [turned, before, last] = [direction, middle, i];
  }
  return pieces >= 5 && square > 1e-4 ? product / square : null;
}

function typicalSpeed(x: Float64Array, y: Float64Array, t: Float64Array): number {
  const speeds: number[] = [];
  const stride = Math.max(1, Math.floor(x.length / 2000));
  for (let i = 1; i < x.length; i += stride) {
    const dt = t[i]! - t[i - 1]!;
    if (dt > 0) speeds.push(Math.hypot(x[i]! - x[i - 1]!, y[i]! - y[i - 1]!) / dt);
  }
  speeds.sort((a, b) => a - b);
  return speeds[speeds.length >> 1] ?? 0;
}
