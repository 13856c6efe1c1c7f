/** What is read before the tool is opened. */
export const firstWords = { open: 'Lessons' } as const;
