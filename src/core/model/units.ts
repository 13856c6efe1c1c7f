/** Units of coordinates as they are shown: angles in degrees, a pure number in none. */
import type { CoordinateMeta } from './system.ts';

type Measured = Pick<CoordinateMeta, 'kind' | 'pure'>;

/**
 * Unit of a coordinate.
 *
 * @param coordinate as its system has it
 */
export const coordinateUnit = ({ kind, pure }: Measured): string => (kind === 'angle' ? '°' : pure ? '' : 'm');

/**
 * Unit of a coordinate's rate.
 *
 * @param coordinate as its system has it
 */
export const rateUnit = (coordinate: Measured): string =>
  perSecond(coordinate.kind === 'angle' ? '°' : coordinateUnit(coordinate));

/**
 * Unit of what changes in a second.
 *
 * @param unit of the thing itself, empty for a pure number
 */
export const perSecond = (unit: string): string => `${unit || '1'}/s`;
