/** Words of the comparison of methods. */
export const words = {
  title: 'Compare methods',
  about: (title: string) =>
    `“${title}” as it stands in the panel, run with each chosen method, all at the same time. “Report” is Table 1 of the 2017 report this program began with: computing time for the time reached, for the falling board.`,
  aboutSet: (label: string) => `${label}: the panel is left as it is, and the chosen methods run at the same time.`,
  columns: [
    'method',
    'computing time, s',
    'energy drift, relative',
    'residual',
    'steps (rejected)',
    'evaluations (Jacobians)',
    'reached t, s',
    'ended',
  ],
  agree: (compared: string) =>
    `The methods agree to 4 digits to the end, ${compared}. That makes none of them right, but it is a good sign.`,
  part: (four: string, none: string) =>
    `The methods agree to 4 digits until ${four}; after ${none} they have no digit in common.`,
  fade: (four: string, two: string, compared: string) =>
    `The methods agree to 4 digits until ${four}, to 2 until ${two}, and to 1 to the end, ${compared}.`,
  seconds: (t: number) => `${t} s`,
  run: 'Run chosen methods',
  set: 'Compare',
  projection: 'project onto the constraints',
  curve: 'Curve',
  noCurves: 'The curves of all methods stand here once they have run.',
  csv: 'Table as CSV',
  showAll: (n: number) => `Show all ${n} methods`,
  showChosen: 'Show the chosen ones only',
  report: (seconds: number, reached: number) => `report: ${seconds} s for ${reached} s`,
  states: { waiting: 'waiting', computing: 'computing' },
  precision: 'accuracy against computing time',
  computing: 'computing time, s',
  drift: 'energy drift, relative',
  plot: (column: string) => `${column}, one curve per method`,
} as const;
