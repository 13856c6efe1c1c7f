/** Words of the gallery. */
export const text = {
  title: 'Cases',
  edited: 'edited',
  search: 'Search cases',
  placeholder: 'system, figure, word …',
  none: (word: string) => `No case speaks of “${word}”.`,
  count: (n: number) => (n === 1 ? '1 case' : `${n} cases`),
  now: 'in the panel',
  lqr: 'LQR',
  track: 'tracked',
  section: (chapter: string) => `section ${chapter}`,
  /** Where the report is named first. */
  report: 'The report: “A-1: Modelling and Control of a Ripstik”, final report of the course MTHE 493, 2017.',
  sections: {
    board: 'The board, ridden and let go',
    '3.2': 'Report 3.2: coordinate systems',
    '3.3': 'Report 3.3: equations of motion',
    '3.4': 'Report 3.4: nonholonomic constraints',
    '3.5': 'Report 3.5: linear quadratic regulator',
    papers: 'From papers and textbooks',
  },
  keys: 'Arrows move, Enter runs',
} as const;
