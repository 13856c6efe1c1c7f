/** What the page says of the help before it is opened; the rest comes with it. */
export const firstWords = {
  terms: 'Words',
  about: 'About',
  licences: 'Licences',
  documents: 'Documents',
} as const;
