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
