/** The words of the first view; the others come with the view. */
export const firstWords = { title: 'File' } as const;
