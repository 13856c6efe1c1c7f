/**
 * A scenario's system for other tools: MJCF, a SymPy script, C. docs/exchange.md says what each of them holds,
 * docs/decisions/0026-exchange.md why.
 */
import type { System } from '../model/system.ts';
import { faultOf } from '../description/index.ts';
import { ScenarioError, type Scenario } from '../scenario/types.ts';
import { cOf } from './c.ts';
import { mjcfOf } from './mjcf.ts';
import { sourceOf, type Source } from './source.ts';
import { sympyOf } from './sympy.ts';
import { wrapped } from './wrapped.ts';

export const EXCHANGE_FORMATS = ['mjcf', 'sympy', 'c'] as const;
export type ExchangeFormat = (typeof EXCHANGE_FORMATS)[number];

const ENDINGS: Readonly<Record<ExchangeFormat, string>> = { mjcf: '.xml', sympy: '.py', c: '.c' };

export interface Exchanged {
  /** For a file. */
  name: string;
  text: string;
  /** What the format cannot say, or what was left out: sentences. */
  notes: readonly string[];
}

/**
 * Writes a scenario's system in a format of another tool: the parameters, constraints and held coordinates of the scenario, and
 * its start.
 *
 * @param scenario checked
 * @param system that the scenario names
 * @param format of the file
 * @throws ScenarioError where the system cannot be said in that format, with the reason
 */
export async function exportScenario(scenario: Scenario, system: System, format: ExchangeFormat): Promise<Exchanged> {
  const source = await sourceOf(scenario, system);
  try {
    return write(source, format);
  } catch (error) {
    const fault = faultOf(error);
    if (fault === null) throw error;
    throw new ScenarioError('system', fault);
  }
}

function write(source: Source, format: ExchangeFormat): Exchanged {
  const name = `${source.id}${ENDINGS[format]}`;
  if (format === 'mjcf') return { name, ...mjcfOf(source) };
  const notes = notesOf(source);
  const about = [`${source.model.title}, from RipStik Lab.`, ...notes.flatMap((note) => wrapped(note))];
  return { name, text: format === 'c' ? cOf(source, about) : sympyOf(source, about), notes };
}

function notesOf({ model, tests }: Source): string[] {
  const notes: string[] = [];
  if (model.clock !== null && model.mechanical) notes.push('The coordinate clock is the time; its rate is 1.');
  if (tests.length < 2 && model.mechanical)
    notes.push('At a state where the constraints are singular there is no test vector.');
  return notes;
}
