import { curvesCsv, designCurves, type CurvesRequest, type DesignCurves } from '../core/control/locus/designCurves.ts';
import type { System, SystemMeta } from '../core/model/system.ts';
import type { Scenario } from '../core/scenario/types.ts';
import { openOutput } from './output.ts';
import { UsageError } from './usage.ts';

/** As typed; SI. */
export interface CurvesOptions {
  /** Where the same goes as CSV. */
  out: string | undefined;
  over: string | undefined;
  from: string | undefined;
  to: string | undefined;
  count: string | undefined;
}

/**
 * Growth, gain and delay margin of a scenario's regulator, designed anew over a range of speeds or of another number.
 *
 * @param name of the scenario's file, never written over
 * @throws UsageError for what is no number or no name
 * @throws ScenarioError as `designCurves`
 */
export function curves(scenario: Scenario, system: System, name: string, options: CurvesOptions): DesignCurves {
  const found = designCurves(scenario, system, requestOf(system.meta, options));
  if (options.out !== undefined) {
    const output = openOutput(options.out, name);
    try {
      output.write(curvesCsv(found));
      output.finish();
    } catch (error) {
      output.discard();
      throw error;
    }
  }
  return found;
}

function requestOf(meta: SystemMeta, { over, from, to, count }: CurvesOptions): CurvesRequest {
  const number = (option: string, text: string | undefined, otherwise: number): number => {
    const value = text === undefined ? otherwise : Number(text);
    if (text?.trim() === '' || !Number.isFinite(value)) throw new UsageError(`--${option} "${text}" is no number`);
    return value;
  };
  const name = over ?? meta.speed?.name ?? meta.forward?.along[0];
  if (name === undefined) throw new UsageError(`${meta.id} has no speed: name what varies with --over`);
  return {
    vary: meta.parameters.some((p) => p.name === name) ? 'parameter' : 'at',
    name,
    from: number('from', from, 0),
    to: number('to', to, 10),
    count: number('count', count, 41),
  };
}
