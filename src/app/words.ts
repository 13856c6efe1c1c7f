/** Words on autosave, links and files by address. */
export const text = {
  unusable: 'What was kept of your last work can\u2019t be used',
  unusableHint: 'The page opens with its first case. What is stored stays until you edit something.',
  notStored: 'Your work stays in this tab only',
  notStoredHint: (reason: string) =>
    reason === 'QuotaExceededError'
      ? 'The storage that this browser has for the page is full. Free some of it, or save the scenario as a file to keep it.'
      : `This browser stores nothing for the page (${reason}). Save the scenario as a file to keep it.`,
  fileGone: (name: string) => `${name} is not kept`,
  fileGoneHint: (mb: number) =>
    `Files of up to ${mb} MB are kept in this browser; open it again. Your scenario is as you left it.`,
  fileLarge: (name: string) => `${name} is open, but will not be kept`,
  fileLargeHint: (mb: number) => `It is longer than the ${mb} MB that are kept over a reload; its name is remembered.`,
  runLarge: (name: string) => `\u201c${name}\u201d stays until the page is left`,
  runLargeHint: (mb: number) => `Kept runs of up to ${mb} MB together survive a reload. Export it to keep it.`,
  forgotten: 'Everything stored in this browser is forgotten',
  forgottenHint: 'The page stays as it is. What you edit from now on is kept again.',
  notForgotten: 'What is stored could not be removed',
  forget: 'Forget everything stored',
  forgetHint:
    'Your last work is kept in this browser only: drafts, settings, the open file, kept runs, the last sweep, dropped meshes.',
} as const;

export const shareText = {
  opened: (title: string) => `Opened from a link: ${title}`,
  openedHint: 'Your last work is still kept; editing this one takes its place.',
  openedFresh: 'The scenario is in the panel and running.',
  back: 'Back to your last work',
  altered:
    'The link was changed by hand, or its case has changed since it was made. Dots in the panel mark what differs from the case.',
  unknownTool: (id: string) => `It names a tool that this page does not have: \u201c${id}\u201d.`,
  bad: 'The link could not be opened',
  badHint: 'Nothing on the page has changed.',
} as const;

export const fileText = {
  loading: (name: string) => `loading ${name}`,
  refused: 'The file named in the address was not opened',
  sameOrigin: (what: string) => `\u201c${what}\u201d: only a path beside this page, such as data/ride.csv, is fetched`,
  ending: (what: string) => `\u201c${what}\u201d: expected a .csv, .txt, .json or .parquet file`,
  answered: (status: number) => `the server answered ${status}`,
  page: 'the server answered with a page, not a file',
  large: (mb: number) => `it is larger than the ${mb} MB this page reads`,
  unreachable: 'the server could not be reached, or sends the file from elsewhere',
} as const;

export const skipText = { label: 'Skip to', scene: 'Skip to the scene', playback: 'Skip to playback' } as const;

export const offlineText = {
  offline: 'offline',
  offlineTitle: 'No connection. The page goes on working with what is stored.',
  update: 'A new version is ready',
  updateHint: 'It is used from your next visit on, or now:',
  updated: 'This page has a new version',
  updatedHint:
    'Another tab uses it already. This tab goes on with the old one until you reload it; what you edited is kept.',
  reload: 'Reload',
} as const;
