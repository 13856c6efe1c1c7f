import type { Gait } from '../../core/gait/gait.ts';
import type { GaitReport, GaitRun } from '../../core/gait/measureGait.ts';
import type { Search, SearchState } from '../../core/gait/optimiseGait.ts';
import type { Call } from '../remote/protocol.ts';

export interface GaitRequest extends GaitRun {
  /** Id, of one whose meta has feet. */
  system: string;
  gait: Gait;
  /** Left out: only the amplitude is looked for that holds the speed. */
  search?: Search;
}

export interface GaitCalls {
  /** Tells how many gaits were tried and the cheapest so far. Aborted, it answers with the cheapest so far, if there is one. */
  'gait.find': Call<GaitRequest, GaitReport | null, SearchState>;
}
