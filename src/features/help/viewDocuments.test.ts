// `?` at the head of every view: a document that there is, and a place in it.
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { idOf } from '../../ui/glossaryText.ts';
import * as features from '../registry.ts';
import type { Feature } from '../../ui/feature.ts';

const all: Feature[] = Object.values(features);
/** Places that a view's own source names, as a dialog's does. */
const named = readdirSync('src/features', { recursive: true, encoding: 'utf8' })
  .filter((file) => file.endsWith('.tsx') && !file.endsWith('.test.tsx'))
  .flatMap((file) =>
    [...readFileSync(`src/features/${file}`, 'utf8').matchAll(/ document="([^"]+)"/g)].map(([, to]) => to!),
  );

test('every panel and every tool has a document', () => {
  const views = all.filter(({ panel, tool }) => panel || tool);
  expect(views.length).toBeGreaterThan(12);
  expect(views.filter(({ document }) => !document).map(({ id }) => id)).toEqual([]);
  // the gallery, the export, the ride
  expect(named.length).toBeGreaterThanOrEqual(3);
});

test.each([...all.flatMap(({ document }) => document ?? []), ...named])('%s is there', (to) => {
  const [file, place] = to.split('#');
  expect(existsSync(`docs/${file}`)).toBe(true);
  const places = [...readFileSync(`docs/${file}`, 'utf8').matchAll(/^#+ (.+)$/gm)].map(([, heading]) => idOf(heading!));
  if (place !== undefined) expect(places).toContain(place);
});
