/** Words of sharing a link. */
export const words = {
  share: 'Share',
  shareTitle: 'Copy a link to this scenario',
  copied: 'Link copied',
  copiedHint: (characters: number) =>
    `The scenario is in the link itself (${characters} characters); nothing is sent to a server.`,
  notShared: 'This scenario can\u2019t be shared yet',
  dialog: 'Link to this scenario',
  field: 'Link',
  copyHint: 'This browser does not let the page copy. Copy the link from the field.',
} as const;
