/** Words of the gallery. */
export const text = {
  title: 'Cases',
  edited: 'changed',
  search: 'Search cases',
  placeholder: 'system, figure, word …',
  none: (word: string) => `No case matches “${word}”.`,
  count: (n: number) => (n === 1 ? '1 case' : `${n} cases`),
  now: 'in the panel',
  lqr: 'LQR',
  track: 'tracked',
  ride: 'ridden by commands',
  section: (chapter: string) => `section ${chapter}`,
  /** Where the report is named first. */
  report:
    '“The report” is “A-1: Modelling and Control of a Ripstik”, a student project of 2017 (course MTHE 493) that this program began with.',
  sections: {
    board: 'The board',
    parts: 'Its parts',
    mathematics: 'Its mathematics',
    control: 'Its control',
    rider: 'Its rider, and a robot in the rider’s place',
  },
  /** Of cases that differ in one thing. */
  choices: (title: string) => `The same as “${title}” with`,
  keys: 'Arrows move, Enter runs',
} as const;
