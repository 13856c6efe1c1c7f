import { readFileSync } from 'node:fs';
import { resolve } from 'node:path';

/** A call that can't be carried out, said in one line. */
export class UsageError extends Error {}

/** Paths mean what they mean where the command runs; `npm run ripstik` runs it where the person typed it (`scripts/ripstik.mjs`). */
export function pathOf(name: string): string {
  return resolve(name);
}

/** What stands in a file. @param name as typed, `-` for standard input @throws UsageError */
export function readText(name: string): string {
  try {
    return readFileSync(name === '-' ? 0 : pathOf(name), 'utf8');
  } catch (error) {
    const { code, message } = error as NodeJS.ErrnoException;
    throw new UsageError(`${name} can't be read: ${code === 'ENOENT' ? 'there is no such file' : message}`);
  }
}

/**
 * `alpha=deg,x=mm` as names and what is said of them.
 *
 * @param option that it was given with, for the error
 * @param right an example
 * @throws UsageError
 */
export function pairsOf(option: string, text: string, right: string): Record<string, string> {
  const parts = text.split(',').map((part) => part.trim());
  return Object.fromEntries(
    parts.map((part): [string, string] => {
      const [, name, value] = /^([^=]+)=(.+)$/.exec(part) ?? [];
      if (name === undefined || value === undefined)
        throw new UsageError(`${option}: "${part}" is not understood; right would be ${right}`);
      return [name.trim(), value.trim()];
    }),
  );
}
