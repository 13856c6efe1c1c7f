/** Words of the comparison of methods. */
export const words = {
  title: 'Compare methods',
  about: (title: string) =>
    `“${title}” as it stands in the panel, run with each chosen method in a worker of its own. Beside each of the report's four stands what its Table 1 has for the falling board.`,
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
  run: 'Run them',
  set: 'Compare',
  projection: 'project onto the constraints',
  curve: 'Curve',
  csv: 'Table as CSV',
  png: 'Picture',
  report: (seconds: number, reached: number) => `report: ${reached} s in ${seconds} s`,
  states: { waiting: 'waiting', computing: 'computing' },
  precision: 'precision for the time it took',
  computing: 'computing time, s',
  drift: 'energy drift, relative',
  plot: (column: string) => `${column}, one curve a method`,
} as const;
