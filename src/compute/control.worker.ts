import { analyse } from '../core/control/analysis.ts';
import { scenarioLocus } from '../core/control/locus/scenarioLocus.ts';
import { ScenarioError } from '../core/scenario/types.ts';
import { loadSystem } from '../core/systems/registry.ts';
import type { ControlReply, ControlRequest } from './controlProtocol.ts';

/** Progress is told about as often as a screen is drawn. */
const TELL_MS = 30;

const post = (message: ControlReply): void => self.postMessage(message);

self.addEventListener('message', ({ data }: MessageEvent<ControlRequest>) => void answer(data));

async function answer(data: ControlRequest): Promise<void> {
  try {
    const system = await loadSystem(data.scenario.system);
    if (!system) throw new ScenarioError('system', `unknown system "${data.scenario.system}"`);
    const from = performance.now();
    const seconds = (): number => (performance.now() - from) / 1000;
    switch (data.type) {
      case 'analyse':
        return post({ type: 'analysed', id: data.id, analysis: analyse(data.scenario, system), seconds: seconds() });
      case 'locus':
        return post({
          type: 'locus',
          id: data.id,
          locus: scenarioLocus(data.scenario, system, data.request, teller(data.id)),
          seconds: seconds(),
        });
    }
  } catch (error) {
    const path = error instanceof ScenarioError ? error.path : '';
    post({ type: 'refused', id: data.id, path, message: error instanceof Error ? error.message : String(error) });
  }
}

function teller(id: number): (share: number) => void {
  let told = performance.now();
  return (share) => {
    if (performance.now() - told < TELL_MS) return;
    told = performance.now();
    post({ type: 'progress', id, share });
  };
}
