import { Matrix } from 'ml-matrix';
import type { Scenario } from '../scenario/types.ts';
import type { System } from '../model/system.ts';
import { controlReport, type ControlReport } from './design/report.ts';
import { preparedOf } from './design/scenarioControl.ts';
import { distance, modesOf, type Complex, type Mode } from './linearization/spectrum.ts';

/** A report with a shape for each of its eigenvalues. */
export interface ControlAnalysis extends ControlReport {
  /** As `eigenvalues`, in the same order, each with what moves in it. */
  modes: Mode[];
  /** As `closedLoopEigenvalues`; null without an lqr. */
  closedLoopModes: Mode[] | null;
}

/**
 * What a view shows of a scenario's operating point and, where it has one, its lqr.
 *
 * @param scenario checked, SI
 * @param system that the scenario names
 * @throws ScenarioError as `controlReport`
 */
export function analyse(scenario: Scenario, system: System): ControlAnalysis {
  const report = controlReport(scenario, system);
  const [A, N] = [new Matrix(report.A), new Matrix(report.basis)];
  const modes = paired(report.eigenvalues, preparedOf(scenario, system).modes);
  if (!report.K) return { ...report, modes, closedLoopModes: null };
  const closed = Matrix.sub(A, new Matrix(report.B).mmul(new Matrix(report.K)));
  return {
    ...report,
    modes,
    closedLoopModes: paired(
      report.closedLoopEigenvalues!,
      modesOf(N.transpose().mmul(closed).mmul(N), N, report.states),
    ),
  };
}

/** Gives each eigenvalue the nearest shape that is left: a multiple zero scatters in a matrix that feedback has filled. */
function paired(values: readonly Complex[], shapes: readonly Mode[]): Mode[] {
  const left = [...shapes];
  return values.map((eigenvalue) => {
    let best = 0;
    left.forEach((mode, i) => {
      if (distance(mode.eigenvalue, eigenvalue) < distance(left[best]!.eigenvalue, eigenvalue)) best = i;
    });
    return { ...left.splice(best, 1)[0]!, eigenvalue };
  });
}
