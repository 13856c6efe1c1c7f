import type { SweepMeasure } from '../../core/motion/sweepMeasures.ts';
import type { Written } from '../../core/scenario/own.ts';
import type { ScenarioFile } from '../../core/scenario/types.ts';
import type { Reduced } from '../../core/sweep/reduceRun.ts';
import type { Call } from '../remote/protocol.ts';

export interface SweepCalls {
  /** One run reduced to its measures; tells its share (0 to 1). The scenario is checked in the worker. */
  'sweep.measure': Call<MeasureRequest, Reduced, number>;
}

export interface MeasureRequest {
  /** As it is written: an own system by its description. */
  file: Written<ScenarioFile>;
  measures: readonly SweepMeasure[];
}
