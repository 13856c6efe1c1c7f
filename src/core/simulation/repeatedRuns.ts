import type { System } from '../model/system.ts';
import type { Scenario } from '../scenario/types.ts';
import { Simulation, type RunOptions } from './simulation.ts';

/** Runs one after another, as a sweep makes them: what the last one was built of serves the next where that can be. */
export class RepeatedRuns {
  private last: { simulation: Simulation; system: System; extras: string } | null = null;

  /**
   * A run at its start; the one before is over.
   * @throws ScenarioError, StartError
   */
  next(scenario: Scenario, system: System, { extras = scenario.columns, feedback = null }: RunOptions): Simulation {
    const { last } = this;
    const wanted = extras.join();
    // Forgotten until it has begun: a start that is refused leaves it half way.
    this.last = null;
    const same = last && !feedback && last.system === system && last.extras === wanted;
    const simulation =
      same && last.simulation.again(scenario)
        ? last.simulation
        : new Simulation(scenario, system, { extras, feedback });
    this.last = { simulation, system, extras: wanted };
    return simulation;
  }
}
