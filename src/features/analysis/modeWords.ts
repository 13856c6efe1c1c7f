/** Of a mode that is on the stage. */
export const modeWords = {
  showMode: 'Show as motion',
  showModeOf: (value: string) => `Show the mode ${value} as motion`,
  mode: (value: string) => `Mode ${value}\u202f1/s`,
  modeHint: (angle: string) => `Not a run: the linear mode, with its largest angle ${angle}.`,
  growth: 'As it grows or decays',
  shapeOnly: 'Shape only',
  growthLabel: 'How the mode is shown',
  back: 'Back to the run',
} as const;
