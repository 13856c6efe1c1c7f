/** What the page says of the plots before it is opened; the rest comes with it. */
export const firstWords = { open: 'Plots' } as const;
