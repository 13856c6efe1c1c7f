import type { Scenario, ScenarioFile } from './types.ts';

/** One key that two scenarios do not share; `null` where one does not have it. */
export interface ScenarioDifference {
  path: string;
  first: string | null;
  second: string | null;
}

/** A scenario with defaults filled in, and as it was written. */
export interface WrittenScenario {
  checked: Scenario;
  written: ScenarioFile | null;
}

/**
 * Where two scenarios mean different things, by path, in the scenario's own order. What is told is what was written
 * (`10 deg`), or the default where nothing was.
 *
 * @param a the scenario that is compared
 * @param b with which
 */
export function scenarioDifferences(a: WrittenScenario, b: WrittenScenario): ScenarioDifference[] {
  const [first, second] = [leaves(a.checked), leaves(b.checked)];
  const paths = [...new Set([...first.keys(), ...second.keys()])];
  return paths
    .filter((path) => first.get(path) !== second.get(path))
    .map((path) => ({ path, first: told(a, first, path), second: told(b, second, path) }));
}

function told({ written }: WrittenScenario, checked: ReadonlyMap<string, string>, path: string): string | null {
  const value = path
    .split('.')
    .reduce<unknown>((at, key) => (at as Record<string, unknown> | undefined)?.[key], written ?? undefined);
  if (typeof value === 'string' || typeof value === 'number') return String(value);
  return checked.get(path) ?? null;
}

/** Every value by its path; lists are one value. */
function leaves(scenario: Scenario): Map<string, string> {
  const found = new Map<string, string>();
  const walk = (value: unknown, path: string): void => {
    if (value === null || value === undefined) return;
    if (Array.isArray(value)) found.set(path, value.join(', '));
    else if (typeof value === 'object')
      for (const [key, inner] of Object.entries(value)) walk(inner, path ? `${path}.${key}` : key);
    else found.set(path, String(value));
  };
  walk(scenario, '');
  return found;
}
