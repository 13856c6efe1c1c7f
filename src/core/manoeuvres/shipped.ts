import authors from './authors.json' with { type: 'json' };
import type { TestFile } from './testFile.ts';

const SHIPPED: Readonly<Record<string, unknown>> = { ripstik: authors };

/** The tests that come with a system; null where there are none. Checked as a person's own. */
export const shippedTests = (system: string): TestFile | null =>
  Object.hasOwn(SHIPPED, system) ? (SHIPPED[system] as TestFile) : null;
