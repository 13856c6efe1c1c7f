// Descriptions that strangers typed from docs/own-systems.md alone, through everything; all of them: npm run strangers.
import { readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { strangers } from './strangers.ts';
import { walk } from './walk.ts';

test.each(['spring-pendulum', 'tautochrone', 'hoop', 'foucault', 'slider', 'predator-prey'])('%s', async (id) => {
  const text = readFileSync(new URL(`./strangers/${id}.system.txt`, import.meta.url), 'utf8');
  const { plan, known } = strangers[id]!;
  const walked = await walk(id, text, plan);
  expect(walked.wrong).toEqual([]);
  known!(walked);
});
