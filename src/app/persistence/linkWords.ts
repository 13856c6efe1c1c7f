/** Words on links. They come with a link. */
export const shareText = {
  opened: (title: string) => `Opened from a link: ${title}`,
  openedHint: 'Your last work is still kept; editing this one takes its place.',
  openedFresh: 'The scenario is in the panel and running.',
  back: 'Back to your last work',
  altered:
    'The link was changed by hand, or its case has changed since it was made. Dots in the panel mark what differs from the case.',
  unknownTool: (id: string) => `It names a tool that this page does not have: \u201c${id}\u201d.`,
  bad: 'The link could not be opened',
  badLesson: 'The lesson in the address can\u2019t be read',
  noLesson: 'there is no packed lesson after lesson=',
  badHint: 'Nothing on the page has changed.',
} as const;
