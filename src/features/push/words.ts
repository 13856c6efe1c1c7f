/** Words of pushing at a body: the switch, the keys, the pad. */
export const words = {
  push: 'Push',
  pushTitle: 'Drag a body to pull at it; Shift and drag does it at any time',
  dragKey: 'pull at a body of a run',
  switchKey: 'the same by keys: arrows, Page Up and Page Down push, Escape lets go',
  title: 'Push by keys',
  body: 'Body',
  hint: 'Arrows, Page Up and Page Down; Escape lets go',
  release: 'Let go',
  ways: {
    ahead: 'Push ahead',
    back: 'Push back',
    left: 'Push to the left',
    right: 'Push to the right',
    up: 'Push up',
    down: 'Push down',
  },
  /** Of each axis: the word for a positive force and for a negative one. */
  towards: [
    ['ahead', 'back'],
    ['left', 'right'],
    ['up', 'down'],
  ] as const,
  newtons: (force: string, towards: string) => `${force}\u2009N ${towards}`,
  pulls: (body: string, forces: string) => `${body}: ${forces}`,
  nothing: 'Nothing is held',
  balanced: 'held, no force',
} as const;
