import { StartError } from '../../mechanics/consistentStart.ts';
import { ScenarioError } from '../../scenario/types.ts';
import type { InputMeta, System } from '../../model/system.ts';
import { compareOrders, linearize, type OrderComparison } from './linearize.ts';
import { reachablePlant, type ReachablePlant } from '../design/lqr.ts';
import { ControlError } from './matrices.ts';
import { eigenvalues, modesOf, type Complex, type Mode } from './spectrum.ts';
import { steadyMotionAt, type Plant, type SteadyMotion } from './steadyMotion.ts';

/** How many are kept of each system: what a person goes back and forth between, and the points of a schedule. */
const KEPT = 24;

/**
 * Everything about a plant at a point that no weight changes, each part made when it is first asked for and kept: a
 * weight that is turned asks for a new Riccati solution and nothing else. Nothing of it may be written to.
 */
export class PreparedPlant {
  readonly motion: SteadyMotion;
  private readonly inputs: readonly InputMeta[];
  private madePlant: ReachablePlant | null = null;
  private madeOrders: OrderComparison | null = null;
  private madeSpectra: { plain: Complex[]; linearizeFirst: Complex[]; frozen: Complex[] } | null = null;
  private madeModes: Mode[] | null = null;

  constructor(motion: SteadyMotion, inputs: readonly InputMeta[]) {
    this.motion = motion;
    this.inputs = inputs;
  }

  /** @throws ControlError */
  get plant(): ReachablePlant {
    return (this.madePlant ??= reachablePlant(linearize(this.motion, this.inputs)));
  }

  get orders(): OrderComparison {
    return (this.madeOrders ??= compareOrders(this.motion, this.inputs));
  }

  /** Of the tangent space, and of the other two orders of linearization. */
  get spectra(): { plain: Complex[]; linearizeFirst: Complex[]; frozen: Complex[] } {
    return (this.madeSpectra ??= {
      plain: eigenvalues(this.plant.linearization.tangentA),
      linearizeFirst: eigenvalues(this.orders.linearizeFirst.tangentA),
      frozen: eigenvalues(this.orders.frozen.tangentA),
    });
  }

  /** Open-loop modes with what moves in them. */
  get modes(): Mode[] {
    const { tangentA, basis, states } = this.plant.linearization;
    return (this.madeModes ??= modesOf(tangentA, basis, states));
  }
}

const kept = new WeakMap<System, Map<string, PreparedPlant>>();

/**
 * The plant of a scenario at a point, linearized for some inputs; the same object as long as nothing of it changes.
 *
 * @param plant system, parameters (SI), constraint set and what is held
 * @param at coordinates and rates by name, SI
 * @param inputs the inputs, k
 * @param path of the point in the scenario, for the refusal
 * @throws ScenarioError where the point is no steady motion
 */
export function preparedPlant(
  plant: Plant,
  at: Readonly<Record<string, number>>,
  inputs: readonly InputMeta[],
  path: string,
): PreparedPlant {
  const { system, parameters, constraints, hold } = plant;
  const key = JSON.stringify([
    [...parameters],
    constraints,
    hold,
    Object.entries(at).sort(([a], [b]) => (a < b ? -1 : 1)),
    inputs.map((i) => i.name),
  ]);
  const mine = kept.get(system) ?? new Map<string, PreparedPlant>();
  kept.set(system, mine);
  const found =
    mine.get(key) ??
    new PreparedPlant(
      located(path, () => steadyMotionAt(plant, at)),
      inputs,
    );
  // Last used, last forgotten.
  mine.delete(key);
  mine.set(key, found);
  if (mine.size > KEPT) mine.delete(mine.keys().next().value!);
  return found;
}

/**
 * Says where in the scenario a refusal belongs.
 *
 * @param path of the point in the scenario
 * @param make what may refuse
 */
export function located<T>(path: string, make: () => T): T {
  try {
    return make();
  } catch (error) {
    if (error instanceof ControlError || error instanceof StartError) throw new ScenarioError(path, error.message);
    throw error;
  }
}
