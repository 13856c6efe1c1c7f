import { formatShort } from '../../ui/kit/format.ts';

const seconds = (t: number): string => `${formatShort(t, 3)}\u202fs`;

export const words = {
  comparing: (percent: number) => `checking ${percent}\u2009%`,
  ask: 'How far is it right?',
  askTitle: 'Computes this long run again by another method, and tells how many digits agree until when',
  all: (end: string) => `right to 4 digits to the end, ${end}`,
  fades: (four: string, none: string) => `right to 4 digits until ${four}, to none after ${none}`,
  holds: (four: string, digits: number, end: string) =>
    `right to 4 digits until ${four}, to ${digits} to the end, ${end}`,
  seconds,
  title: (method: string, rtol: string, until: string) =>
    `Computed again by ${method} with rtol ${rtol} and compared until ${until}. A digit counts as right where both agree: 4 digits are 0.0001 of the largest value so far`,
  band: (said: string) => `The bar under the time line fades as digits are lost: ${said}`,
} as const;
