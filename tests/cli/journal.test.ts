import { appendFileSync, mkdtempSync, readFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { expect, test } from 'vitest';
import { Journal } from '../../src/cli/journal.ts';
import type { StudyRow } from '../../src/core/sweep/runOne.ts';

const FACTS = { study: { version: 1 }, shard: '1/1' };
const row = (index: number, message = ''): StudyRow => ({
  index,
  values: [-0, 'rk4'],
  measures: [NaN, -0, 0.1],
  time: NaN,
  reason: 'refused',
  engine: '',
  message,
});

function place(): { path: string; open: (resume?: boolean) => Journal } {
  const out = join(mkdtempSync(join(tmpdir(), 'journal-')), 'out.csv');
  return { path: `${out}.unfinished`, open: (resume = true) => new Journal(out, 'out.csv', FACTS, resume) };
}

/** What a sweep that goes on later finds. */
function found(open: () => Journal): StudyRow[] {
  const journal = open();
  journal.close();
  return [...journal.rows.values()];
}

test('rows come back as they were, to the sign of a zero', () => {
  const { open } = place();
  const journal = open(false);
  journal.add(row(3, 'with "quotes"\nand two lines'));
  journal.close();
  expect(found(open)).toEqual([row(3, 'with "quotes"\nand two lines')]);
});

test('two processes that go on with the same sweep at once leave every row of both', () => {
  const { open } = place();
  open(false).close();
  const [first, second] = [open(), open()];
  first.add(row(0));
  second.add(row(1, 'longer than the line of the other, and not to be cut by it'));
  first.add(row(2));
  second.add(row(0));
  first.close();
  second.close();
  expect(found(open)).toEqual([row(0), row(1, 'longer than the line of the other, and not to be cut by it'), row(2)]);
});

test('a line that was cut off, at the end or within, is not counted, and what follows is', () => {
  const { path, open } = place();
  const journal = open(false);
  journal.add(row(0));
  journal.close();
  const whole = readFileSync(path, 'utf8').split('\n')[1]!;
  for (let length = 1; length < whole.length; length++) appendFileSync(path, `${whole.slice(0, length)}\n`);
  appendFileSync(path, whole.slice(0, -3));
  const after = open();
  after.add(row(1));
  after.close();
  expect(found(open)).toEqual([row(0), row(1)]);
});

test('a journal whose very first line was cut off begins anew', () => {
  const { path, open } = place();
  appendFileSync(path, '{"study":');
  const journal = open();
  journal.add(row(0));
  journal.close();
  expect(found(open)).toEqual([row(0)]);
});
