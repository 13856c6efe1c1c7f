// What is chosen for a file's reading: later over earlier, remembered by shape, and read like a stranger's text.
import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { choicesFrom, rememberedFrom } from '../../../src/app/files/importChoices.ts';
import { mergedChoices, remembering } from '../../../src/app/files/mergedChoices.ts';
import { kindOf } from '../../../src/app/files/fileKind.ts';
import type { ImportChoices } from '../../../src/csv/plan.ts';

const SEED = { seed: 20261201 };
const whole: Required<ImportChoices> = {
  encoding: 'windows-1252',
  separator: ';',
  decimal: ',',
  headerLine: 3,
  system: null,
  map: { theta: 'heading', X: null },
  units: { heading: 'deg' },
  angles: 'deg',
  lengths: 'mm',
  time: null,
  timeUnit: 'ms',
  dateOrder: 'month first',
  step: 0.01,
  body: 'cart',
  scalar: 'first',
  run: 2,
  up: 'y',
  rates: 'savitzky-golay',
};

describe('choices', () => {
  test('whole ones come back as they were; what is none is left out', () => {
    expect(choicesFrom(JSON.parse(JSON.stringify(whole)))).toEqual(whole);
    expect(choicesFrom({ ...whole, step: -1, run: 0, map: { a: 3 }, colour: 'red', headerLine: 1.5 })).toEqual(
      Object.fromEntries(
        Object.entries(whole).filter(([name]) => !['step', 'run', 'map', 'headerLine'].includes(name)),
      ),
    );
  });

  test('anything at all: never thrown at, and what comes of it comes back', () => {
    fc.assert(
      fc.property(fc.anything(), fc.dictionary(fc.string(), fc.anything()), (value, table) => {
        for (const some of [value, table, { ...whole, ...table }])
          expect(choicesFrom(choicesFrom(some))).toEqual(choicesFrom(some));
        rememberedFrom({ shape: value, ...table });
      }),
      SEED,
    );
    expect(choicesFrom(JSON.parse('{"map": {"__proto__": "x"}}'))).toEqual({});
  });

  test('later ones win, columns and units one by one', () => {
    expect(mergedChoices(whole, { map: { X: 'x', theta_dot: null }, units: { x: 'cm' }, decimal: '.' })).toEqual({
      ...whole,
      decimal: '.',
      map: { theta: 'heading', X: 'x', theta_dot: null },
      units: { heading: 'deg', x: 'cm' },
    });
  });

  test('forty shapes are remembered, the one chosen longest ago goes first, and one can be forgotten', () => {
    let known = remembering(null, 'first', whole);
    for (let i = 0; i < 39; i++) known = remembering(known, `shape ${i}`, { up: 'y' });
    known = remembering(known, 'first', { up: 'z' });
    known = remembering(known, 'last', { up: 'y' });
    expect(Object.keys(known!)).toHaveLength(40);
    expect(known).toMatchObject({ first: { up: 'z' }, last: { up: 'y' } });
    expect(known).not.toHaveProperty('shape 0');
    expect(remembering(known, 'first', {})).not.toHaveProperty('first');
    expect(remembering({ one: whole }, 'one', {})).toBeNull();
  });
});

describe('what a file is', () => {
  const blob = (content: string | number[]) =>
    new Blob([typeof content === 'string' ? content : Uint8Array.from(content)]);

  test.each([
    ['caster.mat', 'newmtl hub\nKd 0.1 0.1 0.1\n', 'mesh'],
    ['caster.mdl', 'v 0 0 0\n', 'mesh'],
    ['board.system.txt', 'coordinate x\n', 'system'],
    ['run.mat', 'MATLAB 5.0 MAT-file, Platform: GLNXA64', 'table'],
    ['run4.mat', [0, 0, 0, 0, 3, 0, 0, 0], 'table'],
    ['run73.mat', [0x4d, 0x41, 0x54, 0x4c, 0x41, 0x42, 0x20, 0x37], 'table'],
    ['s.json', '{"version": 1, "system": "ripstik"}', 'scenario'],
    ['s.json', 'not JSON at all', 'scenario'],
    ['no ending', '\n {"system": "ripstik"}', 'scenario'],
    ['records.json', '[{"t": 0, "x": 1}]', 'table'],
    ['lines.json', '{"t": 0, "x": 1}\n{"t": 1, "x": 2}\n', 'table'],
    ['run.csv', '{"version": 1}', 'table'],
    ['run.csv', 't,X\n0,1\n', 'table'],
  ])('%s beginning with %j: %s', async (name, content, kind) => {
    expect(await kindOf(name, blob(content))).toBe(kind);
  });
});
