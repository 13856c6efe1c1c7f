/** Every word on the page that is not data. */
export const text = {
  name: 'RipStik Lab',
  top: {
    cases: 'Cases', open: 'Open', openTitle: 'Open a CSV, a scenario or a mesh pair', samples: 'Samples', samplesTitle: 'Sample runs',
    exports: 'Export', csv: 'Run as CSV', scenario: 'Scenario as JSON', theme: (now: string) => `Use the ${now === 'dark' ? 'light' : 'dark'} theme`,
    keys: 'Keyboard', ownScenario: 'Own scenario', edited: 'edited',
  },
  panel: {
    experiment: 'Experiment', now: 'Now', file: 'File', fold: (name: string) => `Fold ${name}`, unfold: (name: string) => `Show ${name}`,
    system: 'System', constraints: 'Constraints', hold: 'Held coordinates', holdHint: 'Frozen at their initial value.',
    start: 'Start', startHint: 'Empty: not named, rests or gives way. Plain angles are degrees; pi/8 and 0.3 rad are read as written.',
    value: 'value', rate: 'rate', parameters: 'Parameters', parameterSet: 'Parameter set', method: 'Method', formulation: 'Formulation',
    rtol: 'relative tolerance', atol: 'absolute tolerance', step: 'step (first step if adaptive)', maxStep: 'largest step', auto: 'auto',
    projection: 'Project every step and sample onto the constraints', inputs: 'Inputs', inputsHint: 'Numbers or expressions of t, e.g. 0.1*sin(2*pi*t).',
    control: 'Control', controlKind: 'Controller', controlNone: 'None', controlTrack: 'Track a reference', controlLqr: 'LQR (from the scenario)',
    reference: 'reference', kp: 'proportional gain', kd: 'derivative gain', trackHint: 'References are expressions of t, e.g. 20 deg * sin(2*pi*1.5*t).',
    lqrNote: (inputs: string) => `State feedback on ${inputs}, as the scenario says.`, run: 'Run', time: 'Time and events', duration: 'duration',
    outputStep: 'output step', touchdown: 'When a plate touches the ground', stop: 'Stop', ignore: 'Run on',
    cancel: 'Cancel', reset: 'Reset', notInForce: (n: number) => (n === 1 ? '1 field is not in force' : `${n} fields are not in force`),
    differs: (name: string) => `${name} differs from the case: set it back`, scrub: 'Drag to change', solved: 'solved', moved: 'moved to fit', gaveWay: 'gave way',
  },
  transport: {
    label: 'Playback', play: 'Play', pause: 'Pause', back: 'Back one row', forward: 'Forward one row', position: 'Time', speed: 'Speed',
    held: (speed: string) => `held ${speed}`, heldTitle: 'This machine holds the slower speed', loop: 'Loop', seconds: 's', of: 'of',
  },
  view: {
    label: 'View', names: { orbit: 'Orbit', front: 'Front', side: 'Side', top: 'Top', caster: 'Caster' },
    follow: 'Follow', trails: 'Trails', forces: 'Forces', switches: 'Show in the scene', scene: 'Three-dimensional view of the motion',
  },
  status: {
    label: 'Status', steps: 'steps', energy: 'energy', energyTitle: 'Energy now minus energy at the start, relative to largest kinetic energy',
    residual: 'residual', residualTitle: 'Largest constraint residual so far', computing: (percent: number) => `computing ${percent} %`,
    ended: (reason: string) => `ended: ${reason}`, idle: 'not run yet', rows: 'rows', columns: 'columns', skipped: (n: number) => (n === 1 ? '1 line with a problem' : `${n} lines with problems`),
    reasons: { end: 'end', touchdown: 'touchdown', 'constraint-singular': 'constraints singular', 'step-too-small': 'step too small', 'non-finite': 'not finite', cancelled: 'cancelled', failed: 'failed' } as Record<string, string>,
  },
  file: {
    issues: (n: number) => (n === 1 ? '1 note on this file' : `${n} notes on this file`), clean: 'Every line was used.', more: (n: number) => `and ${n} more`,
    line: 'line', column: 'column', whole: 'whole file', none: 'No file open. Drop a CSV anywhere on the page, or open one.', stepTitle: 'Time step of this file',
    stepAsk: (name: string) => `${name} has no header and no time column. How far apart are its rows?`, step: 'time step', use: 'Use this step', giveUp: 'Do not open', rowsPerSecond: (n: string) => `${n} rows in a second`, drop: 'Drop a CSV, scenario or mesh pair',
  },
  now: { value: 'value', rate: 'rate', multipliers: 'Multipliers', empty: 'Nothing to read yet. Run the experiment or open a file.', part: { front: 'front', back: 'back' }, lateral: 'lateral', vertical: 'vertical' },
  hint: 'Press Run to compute this motion, or drop a CSV on the page.',
  noScene: 'The scene cannot be drawn',
  message: { label: 'Messages', dismiss: 'Dismiss' },
  close: 'Close',
  sheet: 'Panels',
  said: { computing: 'Computing', ended: (reason: string, time: string) => `Run ended at ${time} seconds: ${reason}`, passed: (name: string, time: string) => `${name} at ${time} seconds` },
  keys: [
    ['Space', 'play or pause'], ['← →', 'one row back or forward'], ['Shift ← →', '0.1 s back or forward'], [', .', 'one row back or forward'],
    ['Home End', 'to the start or the end'], ['J K L', 'slower, pause, faster'], ['1 – 5', 'orbit, front, side, top, caster view'], ['F', 'follow the board'],
    ['Ctrl Enter', 'run'], ['↑ ↓ in a field', 'step the value; Shift ×10, Alt ÷10'], ['?', 'this sheet'],
  ] as readonly (readonly [string, string])[],
} as const;
