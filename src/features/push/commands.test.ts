import { expect, test } from 'vitest';
import { commandFor, sheetOf } from '../../app/commands.ts';
import type { App } from '../../app/app.ts';
import { commands, padCommands, wayOf, ways } from './commands.ts';

const NONE = { shiftKey: false, ctrlKey: false, metaKey: false, altKey: false };

test('the sheet names the switch and the drag; the keys of the pad stand in words', () =>
  expect(sheetOf(commands)).toEqual([
    ['Shift drag', 'pull at a body of a run'],
    ['G', 'the same by keys: arrows, Page Up and Page Down push, Escape lets go'],
  ]));

test('every way has its key on the pad, Escape releases, and none is taken elsewhere', () => {
  const app = {} as App;
  const found = ['ArrowUp', 'ArrowDown', 'ArrowLeft', 'ArrowRight', 'PageUp', 'PageDown', 'Escape'].map((key) =>
    commandFor(padCommands, { ...NONE, key }, app, 'push-pad')!,
  );
  expect(found.map(wayOf)).toEqual([...ways, null]);
  expect(commandFor(padCommands, { ...NONE, key: 'ArrowUp' }, app)).toBeUndefined();
});
