/** What the page says of the comparison before it is opened; the rest comes with it. */
export const firstWords = {
  open: 'Compare',
  pinned: 'kept',
  pinKey: 'keep this run, to compare with',
  keep: 'Keep this run',
} as const;
