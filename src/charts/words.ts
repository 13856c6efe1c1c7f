/** Words that every chart says. */
export const words = {
  hint: {
    seek: 'Click to go there; drag to zoom, Shift and drag to move along; double click for all.',
    plain: 'Drag to zoom, Shift and drag to move along; double click for all.',
    pick: 'Point to read, click to choose; drag to zoom, double click for all.',
    keys: 'Keys: + and − zoom, 0 shows all, T opens the table.',
  },
  /** What is drawn small because it hardly moves. */
  range: (span: string, unit: string) => `varies by only ${span}${unit && `\u202f${unit}`}`,
  table: 'Values',
  whole: 'Show all',
};
