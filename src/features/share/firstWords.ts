/** Words of the button. */
export const firstWords = {
  share: 'Share',
  shareTitle: 'Copy a link to this scenario',
  notShared: 'This scenario can\u2019t be shared yet',
} as const;
