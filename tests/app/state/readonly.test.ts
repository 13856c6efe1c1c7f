// The state is written by its slices alone: no file outside them assigns to it, and the running state refuses.
import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { Signal } from '@preact/signals';
import { describe, expect, test } from 'vitest';
import type { App } from '../../../src/app/app.ts';
import { appOf } from '../appOf.ts';

describe('from outside, the state', () => {
  const app = appOf();

  test.each(Object.keys(app.state))('%s cannot be written', (name) => {
    const signal = app.state[name as keyof App['state']];
    expect(signal).toBeInstanceOf(Signal);
    const before = signal.peek();
    expect(() => {
      (signal as Signal<unknown>).value = 'another';
    }).toThrow(TypeError);
    expect(signal.peek()).toBe(before);
  });
});

/** An assignment to a signal of the state, however it is reached: `state.time.value = …`, `app.state.time.value += …`, `pinned.runs.value = …`. */
const WRITE =
  /\b(?:state|comparison|sweep|pinned|exportService)\.\w+\.value\s*(?:=(?![=>])|[-+*/%|&^?]{1,2}=|\+\+|--)|(?:\+\+|--)(?:\w+\.)*state\.\w+\.value/;

const sources = ['ui', 'features', 'stage', 'main.tsx', '../tools', '../scripts', '../tests'].flatMap((part) => {
  const path = join('src', part);
  return /\.tsx?$/.test(part)
    ? [path]
    : readdirSync(path, { recursive: true, encoding: 'utf8' })
        .filter((name) => /\.(tsx?|mjs)$/.test(name))
        .map((name) => join(path, name));
});

test('no source outside src/app assigns to it', () => {
  expect(WRITE.test('app.state.view.value = 1')).toBe(true);
  expect(WRITE.test('state.time.value++')).toBe(true);
  expect(WRITE.test('state.time.value === 1')).toBe(false);
  expect(sources.length).toBeGreaterThan(100);
  const writes = sources.flatMap((path) =>
    path.endsWith('readonly.test.ts')
      ? []
      : readFileSync(path, 'utf8')
          .split('\n')
          .flatMap((line, i) => (WRITE.test(line) ? [`${path}:${i + 1}: ${line.trim()}`] : [])),
  );
  expect(writes).toEqual([]);
});
