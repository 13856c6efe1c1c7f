/** The tests that a person wrote, by system, as they are kept in the browser. */
import { signal } from '@preact/signals';
import { browserStorage } from '../../app/persistence/browserStorage.ts';

const NAME = 'tests';
/** An own system's are kept under its name, and no browser keeps thousands. */
const MOST_SYSTEMS = 50;

function stored(): Record<string, string> {
  try {
    const raw: unknown = JSON.parse(browserStorage.text(NAME) ?? '{}');
    if (typeof raw !== 'object' || raw === null) return {};
    return Object.fromEntries(
      Object.entries(raw).filter((entry): entry is [string, string] => typeof entry[1] === 'string'),
    );
  } catch {
    return {};
  }
}

const own = signal<Record<string, string>>(stored());

/** Text of a system's tests; undefined where those that come with it stand. */
export const writtenFor = (system: string): string | undefined =>
  Object.hasOwn(own.value, system) ? own.value[system] : undefined;

/** @param text undefined: those that come with the system */
export function write(system: string, text: string | undefined): void {
  const { [system]: _, ...others } = own.peek();
  const kept = Object.fromEntries(Object.entries(others).slice(1 - MOST_SYSTEMS));
  own.value = text === undefined ? kept : { ...kept, [system]: text };
  browserStorage.putText(NAME, JSON.stringify(own.peek()));
}
