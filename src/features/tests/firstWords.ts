/** What the page says of it before it is opened; the rest comes with it. */
export const firstWords = { open: 'Tests' } as const;
