// @vitest-environment happy-dom
// One list of commands: the sheet, the buttons and the keys are read from it.
import { beforeEach, describe, expect, test, vi } from 'vitest';
import { commandFor, labelOf, sheetOf, type Key } from '../../../src/app/commands.ts';
import type { App } from '../../../src/app/app.ts';
import * as registry from '../../../src/features/registry.ts';
import { inOrder } from '../../../src/ui/feature.ts';
import { commandsOf } from '../../../src/ui/shell/commands.ts';
import { press } from '../../../src/ui/shell/keyboard.ts';
import { putOnStage, testApp } from '../page.tsx';

const commands = commandsOf(inOrder(registry));
const bound = commands.flatMap((command) => (command.keys ?? []).map((key) => ({ command, key })));
const NONE = { shiftKey: false, ctrlKey: false, metaKey: false, altKey: false };
const pressOf = ({ key, shift, control }: Key) => ({
  ...NONE,
  key,
  shiftKey: shift ?? false,
  ctrlKey: control ?? false,
});

describe('the list', () => {
  test('names each command once, in words', () => {
    const app = testApp();
    const ids = commands.map(({ id }) => id);
    expect(new Set(ids).size).toBe(ids.length);
    for (const command of commands) expect(labelOf(command, app)).not.toBe('');
  });

  test('gives each key one meaning in its place', () => {
    const places = bound.map(({ key: { key, shift, control, place } }) => JSON.stringify([key, shift, control, place]));
    expect(places.length).toBeGreaterThan(30);
    expect(places.filter((one, i) => places.indexOf(one) !== i)).toEqual([]);
  });

  test('is the sheet of keys: the page’s, what features add, what holds everywhere', () => {
    const own = sheetOf(commandsOf([]));
    expect(own).toEqual([
      ['Space', 'play or pause'],
      ['← →', 'one row back or forward'],
      [', .', 'one row back or forward'],
      ['Shift ← →', '0.1 s back or forward'],
      ['Home End', 'to the start or the end'],
      ['J K L', 'slower, pause, faster'],
      ['1 – 6', 'orbit, front, side, top, caster view, from aboard'],
      ['F', 'follow what moves'],
      ['P N A', 'front caster in a corner, names, axes of bodies'],
      ['Enter in a field, Ctrl Enter', 'run'],
      ['Ctrl Z', 'undo the last change'],
      ['Ctrl Shift Z, Ctrl Y', 'redo it'],
      ['↑ ↓ in a field', 'step the value; Shift ×10, Alt ÷10'],
      ['?', 'help'],
    ]);
    const all = sheetOf(commands);
    expect([...all.slice(0, 9), ...all.slice(-5)]).toEqual(own);
  });

  test.each(bound.map(({ command, key }) => [command.id, JSON.stringify(key), key] as const))(
    '%s is found by %s',
    (id, _, key) => {
      const app = testApp();
      app.actions.edit('a', (draft) => ({ ...draft, duration: 3 }));
      app.actions.edit('b', (draft) => ({ ...draft, duration: 4 }));
      app.actions.undo();
      putOnStage(app, { version: 1, system: 'ripstik', duration: 0.02 });
      expect(commandFor(commands, pressOf(key), app, key.place)?.id).toBe(id);
    },
  );
});

describe('a key', () => {
  let app: App;
  const type = (key: string, more: Partial<Parameters<typeof press>[1]> = {}): boolean => {
    const preventDefault = vi.fn();
    const event = { ...NONE, key, target: document.body, defaultPrevented: false, preventDefault, ...more };
    press({ app, commands }, event);
    return preventDefault.mock.calls.length > 0;
  };

  beforeEach(() => {
    vi.useRealTimers();
    document.body.innerHTML = '';
    app = testApp();
    putOnStage(app, { version: 1, system: 'ripstik', duration: 1, outputStep: 0.01 });
  });

  test('does what its command does, and is taken', () => {
    expect(type('ArrowRight')).toBe(true);
    expect(app.state.time.value).toBeCloseTo(0.01, 12);
    type('ArrowRight', { shiftKey: true });
    expect(app.state.time.value).toBeCloseTo(0.11, 12);
    type('End');
    expect(app.state.time.value).toBe(1);
    type('Home');
    expect(app.state.time.value).toBe(0);
    type('2');
    expect(app.state.view.value).toBe('front');
    type('F', { shiftKey: true });
    expect(app.state.follow.value).toBe(false);
    type('l');
    expect([app.state.playing.value, app.state.speed.value]).toEqual([true, 1]);
    type('l');
    type('j');
    type('j');
    expect([app.state.playing.value, app.state.speed.value]).toEqual([true, 0.5]);
    type('k');
    expect(app.state.playing.value).toBe(false);
    type('?', { shiftKey: true });
    expect(app.state.dialog.value).toBe('keys');
  });

  test('that means nothing, or nothing now, is left to the browser', () => {
    expect(type('x')).toBe(false);
    putOnStage(app, { version: 1, system: 'stiff-decay', duration: 0.1 });
    expect(type('6')).toBe(false);
    expect(type('g')).toBe(false);
    expect([app.state.view.value, app.state.dragPushes.value]).toEqual(['orbit', false]);
  });

  test('with Control or Alt is the browser’s', () => {
    expect(type('f', { ctrlKey: true })).toBe(false);
    expect(type('f', { altKey: true })).toBe(false);
    expect(app.state.follow.value).toBe(true);
  });

  test('in a field is the field’s; on a button Space presses it', () => {
    document.body.innerHTML = '<input type="text" id="a"><button id="b"></button><select id="c"></select>';
    for (const id of ['a', 'c']) expect(type('f', { target: document.getElementById(id) })).toBe(false);
    expect(type(' ', { target: document.getElementById('b') })).toBe(false);
    expect(type('f', { target: document.getElementById('b') })).toBe(true);
  });

  test('Enter runs from a field that says so, and with Control from anywhere', () => {
    vi.useFakeTimers();
    document.body.innerHTML =
      '<div data-enter="run"><input type="text" id="a"></div><div data-enter="none"><input type="text" id="b"></div>';
    const run = vi.spyOn(app.actions, 'run').mockImplementation(() => undefined);
    const runs = (id: string, more: object = {}): number => {
      run.mockClear();
      type('Enter', { target: document.getElementById(id), ...more });
      vi.runAllTimers();
      return run.mock.calls.length;
    };
    expect(runs('a')).toBe(1);
    expect(runs('b')).toBe(0);
    expect(runs('b', { ctrlKey: true })).toBe(1);
    expect(runs('b', { metaKey: true })).toBe(1);
  });
});
