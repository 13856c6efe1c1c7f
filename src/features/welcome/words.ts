/** Words of the first minute: what to try, and the tour. */
export const text = {
  offer: 'First visit',
  try: 'Lean the board ten degrees and let two small motors steer it upright.',
  balance: 'Balance it',
  ride: 'Ride it',
  take: 'Tour of five steps',
  dismiss: 'Not now',
  tour: 'Tour',
  ofThePage: 'Tour of the page',
  of: (step: number, steps: number) => `Step ${step} of ${steps}`,
  back: 'Back',
  next: 'Next',
  finish: 'Done',
  skip: 'Skip the tour',
  steps: {
    cases: {
      title: 'Choose a case',
      body: 'The name at the top opens the gallery: boards that are ridden, let go or balanced, and the other systems of the student report of 2017 that this laboratory grew out of. One click runs one.',
    },
    run: {
      title: 'Change and run',
      body: 'The panel holds all that a run starts from. Every field takes a number or an expression such as pi/8, and the motion follows; what takes long to compute waits for Run.',
    },
    play: {
      title: 'Watch it',
      body: 'Space plays and pauses, the arrows go row by row, the slider goes anywhere. Drag the scene to look from another side.',
    },
    tools: {
      title: 'Look closer',
      body: 'Plots, equations, eigenvalues and methods open from here, and share their time with the scene.',
    },
    control: {
      title: 'Control it',
      body: 'Choose a regulator here and change a weight while the board rides: it rides on with the new gain.',
    },
  },
} as const;
