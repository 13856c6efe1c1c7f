/** What the page says of the comparison before it is opened; the rest comes with it. */
export const firstWords = {
  open: 'Compare',
  pinned: 'pinned',
  pinKey: 'pin this run, to compare others with it',
  keep: 'Pin this run',
} as const;
