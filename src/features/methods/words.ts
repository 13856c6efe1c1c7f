/** Words of the comparison of methods. */
export const words = {
  title: 'Compare methods',
  about: (title: string) =>
    `“${title}” as it stands in the panel, run with each chosen method in a worker of its own. Beside the four methods of the 2017 report stands what its Table 1 gives for the falling board: computing time for the time reached.`,
  aboutSet: (label: string) =>
    `${label}: the panel is left as it is, and each chosen method runs in a worker of its own.`,
  columns: [
    'method',
    'computing, s',
    'energy drift',
    'residual',
    'steps (rejected)',
    'evaluations (Jacobians)',
    'reached, s',
    'ended',
  ],
  agree: (compared: string) =>
    `The methods agree to 4 digits to the end, ${compared}. That makes none of them right, but it is a good sign.`,
  part: (four: string, none: string) =>
    `The methods agree to 4 digits until ${four}; after ${none} they have no digit in common.`,
  fade: (four: string, two: string, compared: string) =>
    `The methods agree to 4 digits until ${four}, to 2 until ${two}, and to 1 to the end, ${compared}.`,
  seconds: (t: number) => `${t} s`,
  run: 'Run the chosen ones',
  set: 'Compare',
  projection: 'project onto the constraints',
  curve: 'Curve',
  csv: 'Table as CSV',
  showAll: (n: number) => `Show all ${n} methods`,
  showChosen: 'Show the chosen ones only',
  report: (seconds: number, reached: number) => `report: ${seconds} s for ${reached} s`,
  states: { waiting: 'waiting', computing: 'computing' },
  precision: 'precision for the time it took',
  computing: 'computing time, s',
  drift: 'energy drift, relative',
  plot: (column: string) => `${column}, one curve a method`,
} as const;
