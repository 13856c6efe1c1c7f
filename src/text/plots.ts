/** Words of the plots. */
export const text = {
  title: 'Plots', time: 'time', energy: 'energy', residual: 'constraint residual', power: 'power of the inputs',
  rateOf: (label: string) => `rate of ${label}`, force: (part: string, way: string) => `${part} wheel, ${way} force`,
  groups: { coordinates: 'Coordinates', rates: 'Rates', inputs: 'Inputs', multipliers: 'Constraint forces', derived: 'Worked out', other: 'Other' },
  empty: 'Run a case or open a file: its curves stand here.',
  degrees: 'degrees', wrapped: 'wrap angles', ofCase: 'Plots of the case', add: 'Add a plot', whole: 'Whole time',
  over: 'over', addCurve: 'add a curve …', removeCurve: (name: string) => `Remove ${name}`, removePane: (title: string) => `Remove the plot ${title}`,
  up: (title: string) => `Move ${title} up`, save: 'Save', png: 'as PNG', svg: 'as SVG', csv: 'as CSV', table: 'Table', values: (title: string) => `Values of ${title}`,
  hide: (name: string) => `${name}: show or hide`, isolateHint: 'Click: show or hide. Double click: this one alone.', keysHint: 'arrow keys move the time, + and − zoom, 0 shows all',
  pane: (title: string, curves: string, x: string) => `${title}: ${curves} over ${x}. Drag to zoom, click to go there; arrow keys move the time, plus and minus zoom, zero shows all.`,
  spent: (joules: string) => `${joules} J put in so far`, names: { angles: 'Angles', positions: 'Positions', rates: 'Rates', inputs: 'Effort', power: 'Power', path: 'Path', state: 'State', energy: 'Energy' },
  newPane: 'New plot', noCurve: 'Add a curve.', exact: 'exact',
};
