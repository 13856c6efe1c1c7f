/** Words of the read-out. */
export const words = {
  title: 'Now',
  value: 'value',
  rate: 'rate',
  multipliers: 'Multipliers',
  empty: 'Nothing to read yet. Run the experiment or open a file.',
  moreColumns: (n: number) => `and ${n} more columns, in Plots`,
  lateral: 'lateral',
  vertical: 'vertical',
} as const;
