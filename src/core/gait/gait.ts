/**
 * Pumping gaits: what the feet do over a stroke, as the targets of two feet that follow them (`control: track`). A gait
 * is periodic, so a board that pumps settles to a speed; how it gets there is `measureGait.ts`, how cheap it can be
 * `optimiseGait.ts`.
 */
import { heldOf, holdingOf } from '../scenario/held.ts';
import type { SystemMeta } from '../model/system.ts';
import type { ScenarioFile } from '../scenario/types.ts';

/** A higher harmonic of both feet, as a share of the amplitude: `cosine` cos(k w t) + `sine` sin(k w t). */
export interface Harmonic {
  /** k, 2 and up. */
  order: number;
  cosine: number;
  sine: number;
}

export interface Gait {
  /** Of each foot's own roll, rad. */
  amplitude: number;
  /** Hz. */
  frequency: number;
  /** Of the back foot before the front foot, rad: 0 together, pi opposed. */
  phase: number;
  /** What both feet sway about, rad: it leans the board. */
  bias: number;
  /** What the front foot sways about beside that, and the back foot with the other sign, rad: it turns the board. */
  twist: number;
  harmonics: readonly Harmonic[];
}

/** Together, once a second: the cheapest that is found without harmonics at 1 m/s. */
export const plainGait: Gait = { amplitude: 0.25, frequency: 1, phase: 0, bias: 0, twist: 0, harmonics: [] };

/** What wheels are taken to have where nothing is said of them, N·s/m each. */
export const USUAL_DRAG = 0.5;

/** Stiffness (N·m/rad) and damping (N·m·s/rad) of feet that follow, as the cases of pumping have them. */
export const FEET = { kp: 60, kd: 3 } as const;

/**
 * The targets of both feet, as expressions of t.
 *
 * @param gait of both feet; rad, Hz
 * @returns front, back, rad
 */
export function targetsOf(gait: Gait): [front: string, back: string] {
  const { bias, twist, phase } = gait;
  return [wave(gait, bias + twist, 0), wave(gait, bias - twist, phase)];
}

function wave({ amplitude, frequency, harmonics }: Gait, mean: number, ahead: number): string {
  const angle = (k: number): string => `2*pi*${k * frequency}*t${ahead === 0 ? '' : ` + ${k * ahead}`}`;
  const terms = [`sin(${angle(1)})`];
  for (const { order, cosine, sine } of harmonics) {
    if (cosine !== 0) terms.push(`(${cosine})*cos(${angle(order)})`);
    if (sine !== 0) terms.push(`(${sine})*sin(${angle(order)})`);
  }
  const sum = terms.length > 1 ? `(${terms.join(' + ')})` : terms[0]!;
  return `${mean === 0 ? '' : `${mean} + `}${amplitude}*${sum}`;
}

/**
 * One foot's target at a share of a stroke.
 *
 * @param gait of both feet; rad, Hz
 * @param foot whose target
 * @param share 0 to 1
 * @returns rad
 */
export function targetAt(gait: Gait, foot: 'front' | 'back', share: number): number {
  const ahead = foot === 'front' ? 0 : gait.phase;
  const angle = 2 * Math.PI * share + ahead;
  let sum = Math.sin(angle);
  for (const { order, cosine, sine } of gait.harmonics)
    sum += cosine * Math.cos(order * angle) + sine * Math.sin(order * angle);
  return gait.bias + (foot === 'front' ? gait.twist : -gait.twist) + gait.amplitude * sum;
}

/**
 * Initial values straight ahead at a speed.
 *
 * @param meta of a system that has a forward direction
 * @param speed m/s
 */
export const startAt = (meta: SystemMeta, speed: number): Record<string, number> => ({
  [meta.speed?.name ?? meta.forward!.along[0]]: speed,
});

/**
 * A scenario in which the feet do this.
 *
 * @param meta of a system whose meta says what its feet are (`gait`)
 * @param gait of both feet; rad, Hz
 * @param base what else holds: parameters, start, duration
 * @throws Error where the system has no feet
 */
export function gaitScenario(meta: SystemMeta, gait: Gait, base: Partial<ScenarioFile> = {}): ScenarioFile {
  if (!meta.gait) throw new Error(`${meta.id} has no feet that pump`);
  const [front, back] = targetsOf(gait);
  const { feet, hold = [] } = meta.gait;
  return {
    ...base,
    version: 1,
    system: meta.id,
    ...both(meta, base, hold),
    control: { type: 'track', reference: { [feet[0]]: front, [feet[1]]: back }, ...FEET },
  };
}

/** What the gait holds beside what the base does, whatever is free there. */
function both(
  meta: SystemMeta,
  base: Partial<ScenarioFile>,
  hold: readonly string[],
): Pick<ScenarioFile, 'hold' | 'release'> {
  const { hold: held = [], release } = holdingOf(meta, [...heldOf(meta, base), ...hold]);
  return { hold: held, ...(release ? { release } : {}) };
}
