/** Words of opening files. */
export const words = {
  open: 'Open',
  openTitle: 'Open a table of numbers, a scenario, the results of a sweep or a mesh pair',
  samples: 'Samples',
  samplesTitle: 'Sample runs',
  drop: 'Drop a table of numbers, a scenario, the results of a sweep or a mesh pair',
} as const;
