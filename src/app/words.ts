/** Words on autosave and the connection; those on links and on files by address come with them. */
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

export const fileText = {
  loading: (name: string) => `loading ${name}`,
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
