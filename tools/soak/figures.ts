/** Lines of the table of large things in docs/robustness.md. */
import { mkdirSync, writeFileSync } from 'node:fs';
import { measured } from '../../tests/browser/helpers.ts';

export const MB = (bytes: number): string => `${(bytes / 1e6).toFixed(0)} MB`;

/** Written down for `npm run big`, which makes the table. */
export function keep(id: string, line: Record<string, string>): void {
  mkdirSync('.cache/big', { recursive: true });
  writeFileSync(`.cache/big/${id}.json`, JSON.stringify(line));
  measured(`${id}: ${JSON.stringify(line, null, 1)}`);
}

/** Tasks of more than 50 ms, longest first, in words. */
export const told = (tasks: readonly number[]): string =>
  tasks.length === 0 ? 'none' : `${tasks.length}, longest ${tasks[0]!.toFixed(0)} ms`;
