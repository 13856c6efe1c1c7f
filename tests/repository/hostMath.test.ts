// What acts in a run computes with the project's own elementary functions: those of two browsers differ in the last bit.
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test } from 'vitest';

/** Steps, and controllers between them. */
const ACTING = ['integrators', 'simulation', 'control/ride', 'control/path', 'control/sampled'];
const FILES = ['control/design/scheduledFeedback.ts', 'control/locus/families.ts'];

/** Says how far a run is to be trusted, and changes nothing of it. */
const JUDGING = ['simulation/trust.ts'];

test('no step and no controller asks the host for a sine', () => {
  const folders = ACTING.flatMap((folder) =>
    readdirSync(join('src/core', folder), { recursive: true, encoding: 'utf8' }).map((name) => join(folder, name)),
  );
  const files = [...folders, ...FILES].filter((name) => name.endsWith('.ts') && !JUDGING.includes(name));
  expect(files.length).toBeGreaterThan(40);
  const found = files.filter((name) =>
    /Math\.(sin|cos|tan|a?sinh|a?cosh|a?tanh|exp|expm1|log|log1p|log10|pow|atan2?|asin|acos)\(/.test(
      readFileSync(join('src/core', name), 'utf8'),
    ),
  );
  expect(found).toEqual([]);
});
