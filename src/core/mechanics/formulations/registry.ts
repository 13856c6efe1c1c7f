import type { ConstrainedSystem } from '../constrainedSystem.ts';
import { BlockTriangular } from './blockTriangular.ts';
import type { Formulation } from './contract.ts';
import type { FormulationId } from './formulations.ts';
import { Multipliers } from './multipliers.ts';
import { NullSpace } from './nullSpace.ts';

/** How each formulation of `formulations.ts` is made. */
const makers: Readonly<Record<FormulationId, (dynamics: ConstrainedSystem) => Formulation>> = {
  multipliers: (dynamics) => new Multipliers(dynamics),
  'nullspace-qr': (dynamics) => new NullSpace(dynamics),
  blt: (dynamics) => new BlockTriangular(dynamics),
};

/**
 * A formulation by its permanent id, or undefined where there is none of that name.
 *
 * @param id permanent id, of `formulations.ts`
 * @param dynamics the constrained system that is to be advanced
 */
export function createFormulation(id: string, dynamics: ConstrainedSystem): Formulation | undefined {
  return Object.hasOwn(makers, id) ? makers[id as FormulationId](dynamics) : undefined;
}
