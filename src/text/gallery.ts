/** Words of the gallery. */
export const text = {
  title: 'Cases', search: 'Search cases', placeholder: 'system, figure, word …', none: (word: string) => `No case speaks of “${word}”.`,
  count: (n: number) => (n === 1 ? '1 case' : `${n} cases`), now: 'in the panel', lqr: 'LQR', track: 'tracked', section: (chapter: string) => `section ${chapter}`,
};
