/** What a person can ask of the page, by button, menu or key: one list, which all of these read. */
import type { App } from './app.ts';

/** Where a key means something; without one, wherever no field, menu or dialog has the focus. */
export type KeyPlace = 'field' | 'scene' | 'push-pad';

/** A line of the sheet of keys; keys with the same line stand together. */
export interface KeyLine {
  /** What they do, in words. */
  what: string;
}

export interface Key {
  /** As `KeyboardEvent.key` has it, letters in lower case; `drag` for the pointer. */
  key: string;
  shift?: true;
  /** Control, or Command on a Mac. */
  control?: true;
  place?: KeyPlace;
  /** A text field that is no part of the experiment keeps the key for itself. */
  textual?: true;
  /** Without it, the key is not on the sheet. */
  line?: KeyLine;
}

export interface Command {
  /** Permanent. */
  id: string;
  /** As menus and buttons show it. */
  label: string | ((app: App) => string);
  /** More words, for a title. */
  hint?: string;
  keys?: readonly Key[];
  /** Always, where it does not say. Reads signals: a component that asks is drawn again. */
  enabled?(app: App): boolean;
  /** Missing where the place of its keys does it: a field steps its own value. */
  perform?(app: App): void;
}

const KEY_NAMES: Readonly<Record<string, string>> = {
  ' ': 'Space',
  ArrowLeft: '←',
  ArrowRight: '→',
  ArrowUp: '↑',
  ArrowDown: '↓',
};

const nameOf = ({ key }: Key): string => KEY_NAMES[key] ?? (key.length === 1 ? key.toUpperCase() : key);

export const labelOf = ({ label }: Command, app: App): string => (typeof label === 'string' ? label : label(app));

/** Its words with its first key behind them. */
export function titleOf(command: Command, app: App): string {
  const words = command.hint ?? labelOf(command, app);
  const key = command.keys?.[0];
  return key ? `${words} (${nameOf(key)})` : words;
}

/** The command that a key press asks for in a place, if it can be performed. */
export function commandFor(
  commands: readonly Command[],
  {
    key,
    shiftKey,
    ctrlKey,
    metaKey,
    altKey,
  }: Pick<KeyboardEvent, 'key' | 'shiftKey' | 'ctrlKey' | 'metaKey' | 'altKey'>,
  app: App,
  place?: KeyPlace,
): Command | undefined {
  const name = key.length === 1 ? key.toLowerCase() : key;
  const control = ctrlKey || metaKey;
  const found = (shift: boolean): Command | undefined =>
    commands.find(
      ({ keys = [], enabled }) =>
        keys.some(
          (one) =>
            one.key === name &&
            (one.shift ?? false) === shift &&
            (one.control ?? false) === control &&
            (one.control || one.place === place),
        ) &&
        (enabled?.(app) ?? true),
    );
  // A field steps by tenths with Alt; elsewhere such keys are the browser's.
  if (altKey && place !== 'field') return undefined;
  // Shift is there to reach some signs: only where a key asks for it does it mean more.
  return (shiftKey ? found(true) : undefined) ?? (shiftKey && control ? undefined : found(false));
}

/** The sheet: keys, and what they do, in the order of the list. */
export function sheetOf(commands: readonly Command[]): (readonly [keys: string, what: string])[] {
  const lines = new Map<KeyLine, Key[]>();
  for (const key of commands.flatMap(({ keys = [] }) => keys))
    if (key.line) lines.set(key.line, [...(lines.get(key.line) ?? []), key]);
  return [...lines].map(([{ what }, keys]) => [inWords(keys), what]);
}

/** `Shift ← →`, `1 – 6`, `Enter in a field, Ctrl Enter`: keys pressed alike share what is held with them. */
function inWords(keys: readonly Key[]): string {
  const alike = new Map<string, { before: string; names: string[]; after: string }>();
  for (const key of keys) {
    const before = `${key.control ? 'Ctrl ' : ''}${key.shift ? 'Shift ' : ''}`;
    const after = key.place === 'field' ? ' in a field' : '';
    const group = alike.get(before + after) ?? { before, names: [], after };
    group.names.push(nameOf(key));
    alike.set(before + after, group);
  }
  return [...alike.values()].map(({ before, names, after }) => before + shortened(names) + after).join(', ');
}

/** Digits in a row by the first and the last of them. */
function shortened(names: readonly string[]): string {
  const row = names.length > 2 && names.every((name, i) => name === String(Number(names[0]) + i));
  return row ? `${names[0]} – ${names.at(-1)}` : names.join(' ');
}
