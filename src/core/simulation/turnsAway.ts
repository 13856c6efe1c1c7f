import type { Feedback } from '../mechanics/forcing.ts';
import type { SystemMeta } from '../model/system.ts';

const TURN = 2 * Math.PI;
/** From here on the same attitude is nearer on another turn by far; half a turn is a start like any other. */
const MOST = 0.75 * TURN;
/** A difference from whole turns, in turns, up to which no "about" is said. */
const EXACT = 0.01;

/**
 * @param off how far an angle is from a regulator's point, rad
 * @returns whole turns between them, to the nearest; 0 up to three quarters of one
 */
export const turnsBetween = (off: number): number => (Math.abs(off) < MOST ? 0 : Math.round(off / TURN));

export interface TurnsAway {
  name: string;
  turns: number;
  /** Whether the start is off whole turns by more than is seen. */
  about: boolean;
}

/**
 * Angles that a run starts about a whole turn or more from a regulator's point and that the regulator feeds back: it drives the
 * state round by that turn, although the attitude is the same.
 *
 * @param meta of the system
 * @param q n coordinates at the start, rad and m
 * @param feedback of each input
 */
export function turnsAway(meta: SystemMeta, q: Float64Array, feedback: Iterable<Feedback>): TurnsAway[] {
  const n = q.length;
  const slopes = new Float64Array(2 * n);
  let point: Float64Array | undefined;
  const v = new Float64Array(n);
  for (const loop of feedback) {
    if (!loop.point) continue;
    point = loop.point;
    const row = new Float64Array(2 * n);
    loop.addSlopes(0, q, v, 1, 0, row.subarray(0, n), row.subarray(n));
    row.forEach((slope, i) => (slopes[i]! += Math.abs(slope)));
  }
  if (!point) return [];
  const at = point;
  return meta.coordinates.flatMap(({ name, kind }, i) => {
    const off = q[i]! - at[i]!;
    const turns = kind === 'angle' && slopes[i]! > 0 ? turnsBetween(off) : 0;
    return turns === 0 ? [] : [{ name, turns, about: Math.abs(off / TURN - turns) > EXACT }];
  });
}

/** The same as warnings of a run. */
export const turnWarnings = (away: readonly TurnsAway[]): string[] =>
  away.map(({ name, turns, about }) => {
    const count = Math.abs(turns) === 1 ? 'a full turn' : `${Math.abs(turns)} full turns`;
    const angle = `${360 * Math.abs(turns)}°`;
    return (
      `${name} starts ${about ? 'about ' : ''}${count} ${turns > 0 ? 'above' : 'below'} the regulator's point, which drives it all the way round: ` +
      `for the same attitude ${turns > 0 ? 'take' : 'add'} ${angle} ${turns > 0 ? 'from' : 'to'} it`
    );
  });
