/** What a comparison of two runs says, in few words and as a band. */
import type { Trust } from '../../core/simulation/trust.ts';
import { words } from './words.ts';

const { seconds } = words;

/** Cut, not rounded: a run is right at least so long. */
const cut = (t: number): number => Math.floor(t * 100 + 1e-6) / 100;

/** Digits that hold all the time: what is lost in between and found again does not count. */
const heldBy = (digits: Trust['digits']): number => Math.floor(digits.reduce((least, [, d]) => Math.min(least, d), 3));

export function saidOf({ until, compared, digits }: Trust): string {
  if (until[4] === compared) return words.all(seconds(cut(compared)));
  if (until[1] === compared) return words.holds(seconds(cut(until[4])), heldBy(digits), seconds(cut(compared)));
  return words.fades(seconds(cut(until[4])), seconds(Math.ceil(until[1] * 100 - 1e-6) / 100));
}

/** How strong the band is at a place of the line (0 to 1) of the run from `start` to `end`, s: full to 4 digits, none after the last. */
export function stopsOf({ until, compared }: Trust, start: number, end: number): { at: number; strength: number }[] {
  const place = (t: number): number => Math.min(1, Math.max(0, (t - start) / (end - start || 1)));
  const last = place(compared);
  const stops = [
    { at: 0, strength: 1 },
    { at: place(until[4]), strength: 1 },
    { at: place(until[2]), strength: 0.55 },
    { at: place(until[1]), strength: 0.25 },
  ];
  if (until[1] < compared) return [...stops, { at: place(until[1]), strength: 0 }];
  // What holds to the end of what was compared is the strength there.
  const held = stops[[until[4], until[2], until[1]].findIndex((t) => t === compared) + 1]!;
  return [
    ...stops.filter(({ at }, i) => i === 0 || at < last),
    { at: last, strength: held.strength },
    { at: last, strength: 0 },
  ];
}
