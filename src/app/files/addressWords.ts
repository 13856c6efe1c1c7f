/** Words on files by address. They come with such a file. */
export const fileText = {
  refused: 'The file named in the address was not opened',
  sameOrigin: (what: string) => `\u201c${what}\u201d: only a path beside this page, such as data/ride.csv, is fetched`,
  ending: (what: string) => `\u201c${what}\u201d: expected a .csv, .txt, .json, .parquet or .md file`,
  answered: (status: number) => `the server answered ${status}`,
  page: 'the server answered with a page, not a file',
  large: (mb: number) => `it is larger than the ${mb} MB this page reads`,
  unreachable: 'the server could not be reached, or sends the file from elsewhere',
} as const;
