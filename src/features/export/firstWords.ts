/** What the page says of it before it is opened; the rest comes with it. */
export const firstWords = {
  title: 'Export',
  csv: 'Run as CSV',
  scenario: 'Scenario as JSON',
  more: 'Picture, video, 3-D file …',
} as const;
