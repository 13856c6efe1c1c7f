import { describe, expect, it } from 'vitest';
import type { RideCommand } from '../../core/scenario/types.ts';
import { readCommands, textOf } from './rideCommands.tsx';

describe('the commands of a ride as text', () => {
  it('are the same commands when they are read again, to the last bit', () => {
    const commands: RideCommand[] = [
      [0.1 + 0.2, 'start', 1],
      [3, 'twist', -0.55],
      [3, 'straight', 1],
    ];
    expect(textOf(commands)).toBe('0.30000000000000004 start\n3 twist -0.55\n3 straight');
    expect(readCommands(textOf(commands))).toEqual(commands);
    expect(readCommands(' \n')).toEqual([]);
  });

  it.each([
    ['0 start\n\n2 left 3', 'Line 3: must be at most 1, not 3'],
    ['soon start', 'Line 1: must be a number, not the text "soon"'],
    ['2 start\n1 stop', 'Line 2: 1 s is before the command above it at 2 s: put them in order of time'],
  ])('say which line is none: %j', (text, said) => {
    expect(readCommands(text)).toBe(said);
  });
});
