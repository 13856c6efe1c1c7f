import { exportScenario, type ExchangeFormat, type Exchanged } from '../../../src/core/exchange/index.ts';
import { templates } from '../../../src/core/description/templates.ts';
import { parseScenario } from '../../../src/core/scenario/schema.ts';
import type { System } from '../../../src/core/model/system.ts';
import type { Scenario } from '../../../src/core/scenario/types.ts';
import '../../../src/core/simulation/everyMotion.ts';
import { learnSystemIn, loadSystem, systemMetas } from '../../../src/core/systems/registry.ts';

/** A scenario as the command line reads it. */
export async function read(raw: object): Promise<{ scenario: Scenario; system: System }> {
  const text = JSON.stringify({ version: 1, ...raw });
  await learnSystemIn(text);
  const scenario = parseScenario(text, systemMetas);
  return { scenario, system: (await loadSystem(scenario.system))! };
}

export async function exported(raw: object, format: ExchangeFormat): Promise<Exchanged> {
  const { scenario, system } = await read(raw);
  return exportScenario(scenario, system, format);
}

/** A description that ships with the program, as a person would type it. */
export async function typed(id: string): Promise<{ system: { description: string } }> {
  const { default: description } = await templates.find((template) => template.id === id)!.load();
  return { system: { description } };
}
