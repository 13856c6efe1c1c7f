/** What is read before the tool is opened. */
export const firstWords = { title: 'Sweeps' } as const;
