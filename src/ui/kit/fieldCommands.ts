import type { Command } from '../../app/commands.ts';
import { words } from './words.ts';

const line = { what: words.stepValue };

/** What every number field does with its own value. */
export const fieldCommands: readonly Command[] = [
  { id: 'value-up', label: words.valueUp, keys: [{ key: 'ArrowUp', place: 'field', line }] },
  { id: 'value-down', label: words.valueDown, keys: [{ key: 'ArrowDown', place: 'field', line }] },
];
