/** Words of sharing a link. */
export const words = {
  copied: 'Link copied',
  copiedHint: (characters: number) =>
    `The scenario is in the link itself (${characters} characters); nothing is sent to a server.`,
  dialog: 'Link to this scenario',
  field: 'Link',
  copyHint: 'This browser does not let the page copy. Copy the link from the field.',
} as const;
