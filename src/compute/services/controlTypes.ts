import type { ControlAnalysis } from '../../core/control/analysis.ts';
import type { ComputerReport } from '../../core/control/sampled/computerReport.ts';
import type { RegulatorEffect } from '../../core/control/design/effect.ts';
import type { Responses, ResponsesRequest } from '../../core/control/responses.ts';
import type { TurnMap } from '../../core/control/path/turnMap.ts';
import type { CurvesRequest, DesignCurves } from '../../core/control/locus/designCurves.ts';
import type { LocusRequest, ScenarioLocus } from '../../core/control/locus/scenarioLocus.ts';
import type { Scenario } from '../../core/scenario/types.ts';
import type { Call } from '../remote/protocol.ts';

export interface ControlCalls {
  /** Linearization, modes and, with an lqr, the gain of a scenario. */
  'control.analyse': Call<Scenario, ControlAnalysis>;
  /** What it takes to run its regulator on a computer, and what comes of the one that it names. */
  'control.computer': Call<Scenario, ComputerReport>;
  /** What its regulator does in the run of the scenario. */
  'control.effect': Call<Scenario, RegulatorEffect>;
  /** Loop gain at an input and a step's answer; null where the regulator leaves every mode as it is. */
  'control.responses': Call<ResponsesRequest, Responses | null>;
  /** Steady turns over radius and speed. */
  'control.turns': Call<Scenario, TurnMap>;
  /** Eigenvalues along a range; tells its share (0 to 1). It does not look at its mailbox: end its worker to cancel it. */
  'control.locus': Call<{ scenario: Scenario; request: LocusRequest }, ScenarioLocus, number>;
  /** Its regulator designed anew along a range. As `control.locus`. */
  'control.curves': Call<{ scenario: Scenario; request: CurvesRequest }, DesignCurves, number>;
}
