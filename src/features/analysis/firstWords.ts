/** What the page says of the analysis before it is opened; the rest comes with it. */
export const firstWords = { open: 'Analysis' } as const;
