import { analyse } from '../core/control/analysis.ts';
import { ScenarioError, type Scenario } from '../core/scenario/types.ts';
import { systems } from '../core/systems/registry.ts';
import type { System } from '../core/systems/types.ts';
import type { ControlReply, ControlRequest } from './controlProtocol.ts';

const post = (message: ControlReply): void => self.postMessage(message);

self.addEventListener('message', ({ data }: MessageEvent<ControlRequest>) => {
  try {
    const from = performance.now();
    const analysis = analyse(data.scenario, systemOf(data.scenario));
    post({ type: 'analysed', id: data.id, analysis, seconds: (performance.now() - from) / 1000 });
  } catch (error) {
    const path = error instanceof ScenarioError ? error.path : '';
    post({ type: 'refused', id: data.id, path, message: error instanceof Error ? error.message : String(error) });
  }
});

function systemOf(scenario: Scenario): System {
  const system = systems[scenario.system];
  if (!system) throw new ScenarioError('system', `unknown system "${scenario.system}"`);
  return system;
}
