import type { ConstrainedSystem } from '../mechanics/constrainedSystem.ts';
import type { Scenario } from '../scenario/types.ts';
import { singularMassWords } from '../mechanics/singularMass.ts';
import { dependentWords, type System } from '../model/system.ts';

/** Constraints whose smallest scaled eigenvalue is below this magnify rounding more than a hundredfold. */
const NEARLY_DEPENDENT = 1e-4;

/**
 * What happened where a run stops before its end, and what to do.
 *
 * @param reason permanent id
 * @param t s
 * @param q coordinates where it stopped, n
 * @param v velocities, n
 * @param system that the run is of
 * @param dynamics of the run; looks at this state
 * @param method of the run: what is advised is another
 */
export function failureMessage(
  reason: string,
  t: number,
  q: Float64Array,
  v: Float64Array,
  system: System,
  dynamics: ConstrainedSystem,
  method: Scenario['method'],
): string {
  const others = (...names: string[]): string => names.filter((name) => name !== method.name).join(', ');
  const [rtol, atol] = [round(100 * method.rtol), round(100 * method.atol)];
  const dependent = dependentWords(system.meta, dynamics.constraints?.id);
  const at = `at t = ${t.toFixed(3)} s`;
  const known: Record<string, string> = {
    'step-too-small':
      `the step shrank to nothing ${at}: the motion is too abrupt for this tolerance or method; ` +
      `take a larger rtol and atol, or an implicit method (${others('gauss', 'radau')}) where the motion is stiff`,
    newton:
      `the equations of a step could not be solved ${at}, however short it was: take a larger rtol and atol ` +
      `(below about 1e-12 rounding stands in the way), another method (${others('dop853', 'gauss')}), or for a fixed step a shorter one`,
    'non-finite':
      `the equations gave a number that is not finite ${at}: check parameters and inputs, and for a fixed step ` +
      'take a shorter one or a method that chooses its steps',
    'constraint-singular': `the constraints became dependent ${at}${dependent}`,
    'mass-matrix-singular': `the mass matrix became singular ${at}: ${reason === 'mass-matrix-singular' ? singularMassWords(system, dynamics.parameters, q, dynamics.held) : ''}`,
  };
  if (reason === 'newton' || reason === 'step-too-small') {
    const independence = independenceAt(dynamics, t, q, v);
    if (independence < NEARLY_DEPENDENT)
      return (
        `${reason}: the steps shrank to nothing ${at}, where the constraints are nearly dependent: ` +
        `smallest eigenvalue ${independence.toExponential(1)}, 0 where they are${dependent}. That magnifies rounding beyond ` +
        `so small a tolerance: take rtol ${rtol} and atol ${atol}, or ${others('dop853', 'dopri5').split(',')[0]}, which solves no equations in a step`
      );
  }
  return `${reason}: ${known[reason] ?? `the method stopped ${at}`}`;
}

/** Without the last digits of a product. */
const round = (x: number): number => Number(x.toPrecision(3));

/** Smallest scaled eigenvalue of the constraints at a state; Infinity without any. */
function independenceAt(dynamics: ConstrainedSystem, t: number, q: Float64Array, v: Float64Array): number {
  dynamics.forget();
  dynamics.prepare(t, q, v);
  return dynamics.independence(t, q, v);
}
