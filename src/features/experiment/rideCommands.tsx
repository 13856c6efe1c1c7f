/** The commands of a ride as text, one on each line; what they are worth is checked with the scenario. */
import type { RideCommand, RideControl } from '../../core/scenario/types.ts';
import { Checker } from '../../core/scenario/checker.ts';
import { checkCommands, RIDE_COMMANDS } from '../../core/scenario/ride.ts';
import { rideWords as words } from './rideWords.ts';
import { TextSetting } from './textSetting.tsx';

export function RideCommands({ control, change }: { control: RideControl; change(part: Partial<RideControl>): void }) {
  return (
    <>
      <p class="hint">{words.note(Object.keys(RIDE_COMMANDS).join(', '))}</p>
      <TextSetting
        testId="ride-commands"
        label={words.label}
        rows={8}
        text={textOf(control.commands)}
        read={readCommands}
        change={(commands) => change({ commands })}
      />
    </>
  );
}

/** Time in s, name, and the value where it is not 1; times as they are, so that a ride stays the same to the last bit. */
export const textOf = (commands: readonly RideCommand[] = []): string =>
  commands
    .map(([time, name, value]) => `${time} ${name}${value === undefined || value === 1 ? '' : ` ${value}`}`)
    .join('\n');

/** The commands, or in words which line is none. */
export function readCommands(text: string): RideCommand[] | string {
  const lines = text.split('\n').map((line) => line.trim().split(/[\s,]+/));
  const written = lines.flatMap((parts, i) => (parts[0] === '' ? [] : [{ parts, line: i + 1 }]));
  const c = new Checker();
  const numbers = (word: string | undefined): unknown =>
    word === undefined || Number.isNaN(Number(word)) ? word : Number(word);
  const raw = written.map(({ parts: [time, name, ...rest] }) => [numbers(time), name, ...rest.map(numbers)]);
  const commands = checkCommands(c, 'commands', raw);
  const [first] = c.errors;
  if (!first) return commands;
  const place = Number(/\[(\d+)\]/.exec(first[0])?.[1] ?? 0);
  return words.line(written[place]?.line ?? 1, first[1]);
}
