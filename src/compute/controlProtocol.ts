import type { ControlAnalysis } from '../core/control/analysis.ts';
import type { LocusRequest, ScenarioLocus } from '../core/control/locus/scenarioLocus.ts';
import type { Scenario } from '../core/scenario/types.ts';

/** Page to worker: one question at a time, each with a number that its answer repeats. */
export type ControlRequest =
  | { type: 'analyse'; id: number; scenario: Scenario }
  | { type: 'locus'; id: number; scenario: Scenario; request: LocusRequest };

/** Worker to page. A refusal names the key of the scenario that it is about (empty where it is none of them). */
export type ControlReply =
  | { type: 'analysed'; id: number; analysis: ControlAnalysis; seconds: number }
  | { type: 'progress'; id: number; share: number }
  | { type: 'locus'; id: number; locus: ScenarioLocus; seconds: number }
  | { type: 'refused'; id: number; path: string; message: string };
