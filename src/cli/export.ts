import { EXCHANGE_FORMATS, exportScenario, type ExchangeFormat } from '../core/exchange/index.ts';
import type { System } from '../core/model/system.ts';
import type { Scenario } from '../core/scenario/types.ts';
import '../core/simulation/everyMotion.ts';
import { openOutput } from './output.ts';
import { UsageError } from './usage.ts';

export interface ExportOptions {
  name: string;
  format: string | undefined;
  out: string | undefined;
}

/**
 * Writes the system for another tool; what the format cannot say goes to standard error.
 *
 * @throws UsageError; ScenarioError where the system cannot be said in that format
 */
export async function exportAs(
  scenario: Scenario,
  system: System,
  { name, format, out }: ExportOptions,
): Promise<number> {
  const known = EXCHANGE_FORMATS.find((one) => one === format) as ExchangeFormat | undefined;
  if (!known)
    throw new UsageError(
      `${format === undefined ? 'export needs --as' : `--as ${format} is not understood`}: right would be ${EXCHANGE_FORMATS.join(', ')}`,
    );
  const { text, notes } = await exportScenario(scenario, system, known);
  const output = openOutput(out, name);
  try {
    output.write(text);
    output.finish();
  } catch (error) {
    output.discard();
    throw error;
  }
  for (const note of notes) process.stderr.write(`ripstik: note: ${note}\n`);
  return 0;
}
