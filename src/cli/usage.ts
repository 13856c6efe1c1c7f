import { isAbsolute, resolve } from 'node:path';

/** A call that can't be carried out, said in one line. */
export class UsageError extends Error {}

/** Paths mean what they mean where the person typed them, not in the package's own folder. */
export function pathOf(name: string): string {
  return isAbsolute(name) ? name : resolve(process.env['INIT_CWD'] ?? process.cwd(), name);
}
