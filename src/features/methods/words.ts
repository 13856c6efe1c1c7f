/** Words of the comparison of methods. */
export const words = {
  open: 'Methods',
  title: 'Compare methods',
  about: (title: string) =>
    `“${title}” as it stands in the panel, run with each chosen method in a worker of its own. Beside each of the report's four stands what its Table 1 has for the falling board.`,
  aboutSet: (label: string) =>
    `${label}: the panel is left as it is, and each chosen method runs in a worker of its own.`,
  columns: [
    'method',
    'settings',
    'computing, s',
    'output, s',
    'steps',
    'rejected',
    'evaluations',
    'Jacobians',
    'energy',
    'residual',
    'ended',
    'report',
  ],
  run: 'Run them',
  set: 'Compare',
  projection: 'project onto the constraints',
  curve: 'Curve',
  csv: 'Table as CSV',
  png: 'Picture',
  report: (seconds: number, reached: number) => `${reached} s in ${seconds} s`,
  states: { waiting: 'waiting', computing: 'computing' },
  plot: (column: string) => `${column} against time, one curve a method`,
} as const;
