/** What a comparison of two runs says, in few words and as a band. */
import type { Trust } from '../../core/simulation/trust.ts';
import { words } from './words.ts';

const { seconds } = words;

/** Cut, not rounded: a run is right at least so long. */
const cut = (t: number): number => Math.floor(t * 100 + 1e-6) / 100;

export function saidOf({ until, compared, digits }: Trust): string {
  if (until[4] === compared) return words.all(seconds(cut(compared)));
  if (until[1] === compared) return words.holds(seconds(cut(until[4])), Math.min(3, Math.floor(digits.at(-1)![1])));
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
  // Until the end of what was compared only what holds there is shown.
  const held = stops.filter((stop, i) => i === 0 || stop.at < last || i === 1);
  const end4 = held.at(-1)!;
  return until[1] === compared
    ? [...held, { at: last, strength: end4.strength }, { at: last, strength: 0 }]
    : [...stops, { at: place(until[1]), strength: 0 }];
}
