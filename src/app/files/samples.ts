export interface SampleInfo {
  id: string;
  title: string;
  /** Relative to the page. */
  url: string;
}

/** Recorded motions that come with the page (`public/data`, written by `npm run samples`). */
export const samples: readonly SampleInfo[] = [
  { id: 'ridden', title: 'Ridden board, 10 s', url: 'data/ridden.csv' },
  { id: 'falling-report', title: 'Falling board, 5.8 s, degrees', url: 'data/falling-report.csv' },
  { id: 'headerless', title: 'No header, 10 columns, as the report’s files', url: 'data/headerless.csv' },
];
