/** Words of the tests. */
export const words = {
  title: 'Tests',
  about: (title: string) =>
    `“${title}” as it stands in the panel is put through manoeuvres, each with a number and the bounds it must keep.`,
  noTests: 'No tests come with this system: write some below, or open a file of them.',
  loading: 'Loading',
  run: 'Run the tests',
  stop: 'Stop',
  results: 'Results',
  passed: (passed: number, of: number) => `${passed} of ${of} passed`,
  going: (done: number, of: number) => `${done} of ${of} runs computed`,
  stale: 'The scenario in the panel was changed since; run them again for what it is now.',
  columns: ['', 'Test', 'Outcome', 'Path'],
  pass: 'pass',
  fail: 'FAIL',
  waiting: 'waiting',
  picture: (name: string) => `Path over the ground of “${name}”`,
  save: 'Save the report',
  formats: { json: 'JSON', junit: 'JUnit XML' },
  edit: 'The tests, as JSON',
  editNote:
    'A patch over the scenario, a measure, bounds, and random spreads; docs/control.md says what may stand here.',
  shipped: 'Those that come with the system',
  wrong: (message: string) => `These tests can’t be read: ${message}`,
} as const;
