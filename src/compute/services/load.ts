import type { Feedback } from '../../core/mechanics/forcing.ts';
import { ScenarioError, type Scenario } from '../../core/scenario/types.ts';
import { loadSystem } from '../../core/systems/registry.ts';
import type { System } from '../../core/model/system.ts';

/** The equations of the system that a scenario names, and of no other. @throws ScenarioError */
export async function systemOf({ system: id }: Pick<Scenario, 'system'>): Promise<System> {
  const system = await loadSystem(id);
  if (!system) throw new ScenarioError('system', `unknown system "${id}"`);
  return system;
}

/** The state feedback that a scenario asks for; what designs it is loaded only where there is one. */
export async function feedbackFor(scenario: Scenario, system: System): Promise<ReadonlyMap<string, Feedback> | null> {
  if (scenario.control?.type !== 'lqr') return null;
  const { feedbackOf } = await import('../../core/control/design/feedback.ts');
  return feedbackOf(scenario, system);
}
