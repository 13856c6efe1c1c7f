import type { LqrControl } from '../../scenario/types.ts';
import type { SampledReport } from './computerReport.ts';

/**
 * Why a vehicle falls whatever it starts from: the loop of its regulator grows by itself, run so by its computer. Null where it does not.
 *
 * @param control the scenario's own
 * @param sampled what comes of it
 */
export function unstableLoop(
  control: Pick<LqrControl, 'sample' | 'delay'>,
  sampled: Pick<SampledReport, 'spectralRadius'> | null,
): string | null {
  if (!sampled || !(sampled.spectralRadius >= 1)) return null;
  const { sample = 0, delay = 0 } = control;
  const ms = (seconds: number): string => `${Number((1000 * seconds).toPrecision(3))} ms`;
  return (
    `No computer runs this regulator so: with a sample time of ${ms(sample)} and a delay of ${ms(delay)} any deviation grows ` +
    `${Number(sampled.spectralRadius.toPrecision(3))}-fold each sample. Take the design for held inputs (control.design "sampled"), or a shorter sample time or delay.`
  );
}
