/** Pushing, by pointer and by keys; the pad itself does what its own keys ask for. */
import type { Command } from '../../app/commands.ts';
import { canPush } from '../../app/push/pointerPush.ts';
import { words } from './words.ts';

const PAD_KEYS: Readonly<Record<keyof typeof words.ways, string>> = {
  ahead: 'ArrowUp',
  back: 'ArrowDown',
  left: 'ArrowLeft',
  right: 'ArrowRight',
  up: 'PageUp',
  down: 'PageDown',
};
export type Way = keyof typeof PAD_KEYS;
export const ways = Object.keys(PAD_KEYS) as Way[];

const padId = (way: Way | 'none'): string => `push-${way}`;

export const padCommands: readonly Command[] = [
  ...ways.map((way): Command => ({
    id: padId(way),
    label: words.ways[way],
    keys: [{ key: PAD_KEYS[way], place: 'push-pad' }],
  })),
  { id: padId('none'), label: words.release, keys: [{ key: 'Escape', place: 'push-pad' }] },
];

/** The way that a command of the pad pushes, or null for the one that releases. */
export const wayOf = (command: Command): Way | null => ways.find((way) => padId(way) === command.id) ?? null;

export const commands: readonly Command[] = [
  {
    id: 'push-by-drag',
    label: words.pushTitle,
    keys: [{ key: 'drag', shift: true, place: 'scene', line: { what: words.dragKey } }],
  },
  {
    id: 'push',
    label: words.push,
    hint: words.pushTitle,
    keys: [{ key: 'g', line: { what: words.switchKey } }],
    enabled: ({ state }) => canPush(state.motion.value),
    perform: ({ actions }) => actions.toggle('dragPushes'),
  },
  ...padCommands,
];
