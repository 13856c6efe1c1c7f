/** What the suites of this folder tried, counted. `npm run fuzz` makes them long and writes the counts into docs/robustness.md. */
import { mkdirSync, writeFileSync } from 'node:fs';
import { afterAll } from 'vitest';

/** How many times longer than in the tests of every day. */
export const LENGTH = Number(process.env['FUZZ'] ?? 1);
/** Every suite begins here; `FUZZ_SEED` looks elsewhere. */
export const SEED = Number(process.env['FUZZ_SEED'] ?? 20171208);

export const runs = (n: number): number => Math.ceil(n * LENGTH);

/** Counts by what happened, and the time that runs reached, s; kept for the table when the suite ends. */
export function tally(suite: string): (what: string, seconds?: number) => void {
  const counts: Record<string, number> = {};
  let [tried, simulated] = [0, 0];
  afterAll(() => {
    if (LENGTH <= 1) return;
    mkdirSync('.cache/fuzz', { recursive: true });
    writeFileSync(
      `.cache/fuzz/${suite}.json`,
      JSON.stringify({ suite, seed: SEED, length: LENGTH, tried, simulated, counts }, null, 1),
    );
  });
  return (what, seconds = 0) => {
    tried++;
    simulated += seconds;
    counts[what] = (counts[what] ?? 0) + 1;
  };
}
