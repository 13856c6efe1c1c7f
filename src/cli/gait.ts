import '../core/simulation/everyMotion.ts';
import { gaitScenario, plainGait, startAt, USUAL_DRAG, type Gait } from '../core/gait/gait.ts';
import { GaitError, holdSpeed, type GaitReport } from '../core/gait/measureGait.ts';
import { optimiseGait, SEARCH } from '../core/gait/optimiseGait.ts';
import type { System } from '../core/model/system.ts';
import { pairsOf, UsageError } from './usage.ts';

/** As typed; angles in degrees. */
export interface GaitOptions {
  speed?: string | undefined;
  frequency?: string | undefined;
  phase?: string | undefined;
  bias?: string | undefined;
  twist?: string | undefined;
  /** `wheelDrag=0.5,…`, SI. */
  parameters?: string | undefined;
  /** Orders that the search may use, `2,3`. */
  harmonics?: string | undefined;
  /** Searches from this gait on for the cheapest. */
  search: boolean;
}

const DEGREE = Math.PI / 180;

/**
 * The amplitude with which a gait holds a speed, or the cheapest gait that does, with what it costs and its scenario.
 *
 * @throws UsageError for what is no number, a system without feet, or a speed that no amplitude holds
 */
export function gaitReport(system: System, options: GaitOptions): GaitReport & { scenario: unknown } {
  const { meta } = system;
  if (!meta.gait) throw new UsageError(`${meta.id} has no feet that pump`);
  const parameters = parametersOf(options.parameters, system);
  const number = (name: keyof GaitOptions, otherwise: number): number => {
    const text = options[name];
    const value = text === undefined ? otherwise : Number(text);
    if (!Number.isFinite(value)) throw new UsageError(`--${name} "${String(text)}" is no number`);
    return value;
  };
  const speed = number('speed', 1);
  if (!(speed > 0)) throw new UsageError('--speed must be above 0 m/s');
  const gait: Gait = {
    ...plainGait,
    frequency: number('frequency', plainGait.frequency),
    phase: number('phase', 0) * DEGREE,
    bias: number('bias', 0) * DEGREE,
    twist: number('twist', 0) * DEGREE,
  };
  if (!(gait.frequency > 0)) throw new UsageError('--frequency must be above 0 Hz');
  const harmonics = options.harmonics?.split(',').map(Number) ?? [];
  if (!harmonics.every((order) => Number.isInteger(order) && order >= 2 && order <= 9))
    throw new UsageError(`--harmonics "${options.harmonics}": right would be orders from 2 to 9, as 2,3`);
  try {
    const run = { speed, parameters };
    const running = options.search
      ? optimiseGait(system, gait, run, { ...SEARCH, harmonics })
      : holdSpeed(system, gait, run);
    for (;;) {
      const next = running.next();
      if (!next.done) continue;
      const report = next.value;
      return {
        ...report,
        scenario: gaitScenario(meta, report.gait, { parameters, initial: startAt(meta, speed), duration: 20 }),
      };
    }
  } catch (error) {
    if (error instanceof GaitError) throw new UsageError(error.message);
    throw error;
  }
}

function parametersOf(text: string | undefined, { meta }: System): Record<string, number> {
  if (text === undefined) return meta.gait!.drag === undefined ? {} : { [meta.gait!.drag]: USUAL_DRAG };
  return Object.fromEntries(
    Object.entries(pairsOf('--parameters', text, 'wheelDrag=0.5,plateMass=1')).map(([name, value]) => {
      if (!meta.parameters.some((p) => p.name === name)) throw new UsageError(`${meta.id} has no parameter "${name}"`);
      if (!Number.isFinite(Number(value))) throw new UsageError(`--parameters ${name}: "${value}" is no number`);
      return [name, Number(value)];
    }),
  );
}
