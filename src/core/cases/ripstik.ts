import type { Case } from './case.ts';

const held = ['X', 'Y', 'Z', 'alpha', 'psi', 'theta'];

export const ripstikCases: readonly Case[] = [
  {
    id: 'ridden',
    title: 'Ridden board',
    source: '',
    look: 'Feet twist the plates out of phase: with free casters and no push, the board gathers speed.',
    scenario: {
      version: 1,
      system: 'ripstik',
      initial: { X_dot: 0.5 },
      control: {
        type: 'track',
        reference: { tau_fp: '20 deg * sin(2*pi*1.5*t)', tau_bp: '-20 deg * sin(2*pi*1.5*t)' },
        kp: 60,
        kd: 3,
      },
      duration: 10,
    },
    plots: [
      { title: 'Roll of the plates on the rod', x: 't', y: ['alpha_fp', 'alpha_bp'], unit: 'deg' },
      { title: 'Speed', x: 't', y: ['X_dot', 'Y_dot'], unit: 'm/s' },
      { title: 'Path', x: 'X', y: ['Y'], unit: 'm', equal: true },
    ],
  },
  {
    id: 'balanced',
    title: 'Balanced by its steering motors',
    source: '',
    look: 'Ten degrees of lean at 1 m/s: two small motors on the casters steer the board back under itself. Open Control and change a weight while it rides.',
    scenario: {
      version: 1,
      system: 'ripstik',
      initial: { X_dot: 1, alpha: '10 deg' },
      control: { type: 'lqr', inputs: ['tau_fc', 'tau_bc'], at: { X_dot: 1 } },
      duration: 10,
    },
    plots: [
      { title: 'Roll of rod and plates', x: 't', y: ['alpha', 'alpha_fp', 'alpha_bp'], unit: 'deg' },
      { title: 'Steer', x: 't', y: ['theta_fc', 'theta_bc'], unit: 'deg' },
    ],
  },
  {
    id: 'released',
    title: 'Released at 1 m/s',
    source: '',
    look: 'Half a degree of lean grows until a corner of the deck touches the ground.',
    scenario: { version: 1, system: 'ripstik', initial: { X_dot: 1, alpha: '0.5 deg' }, duration: 10 },
    plots: [
      { title: 'Roll of the plates on the rod', x: 't', y: ['alpha_fp', 'alpha_bp'], unit: 'deg' },
      { title: 'Steer', x: 't', y: ['theta_fc', 'theta_bc'], unit: 'deg' },
    ],
  },
  ...[2, 3].map(
    (speed): Case => ({
      id: `coasting-${speed}`,
      title: `Released at ${speed} m/s`,
      source: '',
      look: 'The same half degree of lean: the faster the board coasts, the later it falls. Its casters steer into the fall, but too little to stop it.',
      scenario: { version: 1, system: 'ripstik', initial: { X_dot: speed, alpha: '0.5 deg' }, duration: 10 },
      plots: [
        { title: 'Roll of the plates on the rod', x: 't', y: ['alpha_fp', 'alpha_bp'], unit: 'deg' },
        { title: 'Steer', x: 't', y: ['theta_fc', 'theta_bc'], unit: 'deg' },
      ],
    }),
  ),
  {
    id: 'falling-report',
    title: 'Falling board (Fig. 14 to 17)',
    source: 'Report, section 3.4.4, Fig. 14 to 17',
    look: 'As the report has it: the board swings through the ground and back; its best method took 26.4 s for these 5.8 s.',
    scenario: {
      version: 1,
      system: 'ripstik',
      parameterSet: 'authors',
      constraints: 'report',
      initial: { alpha: '10 deg' },
      duration: 5.8,
      events: { touchdown: 'ignore' },
    },
    figure: 'Fig. 14 to 17',
    chapter: '3.4.4',
    published: [
      { what: 'front plate swings to', measure: { kind: 'max', column: 'alpha_fp', to: 1.4 }, value: 5.4, unit: 'rad', tolerance: 0.4, source: 'Fig. 15, read from the picture' },
      { what: 'back plate swings to', measure: { kind: 'max', column: 'alpha_bp', to: 1.4 }, value: 5.15, unit: 'rad', tolerance: 0.4, source: 'Fig. 15, read from the picture' },
    ],
    plots: [
      { title: 'Fig. 14: height of the rod', x: 't', y: ['Z'], unit: 'm', to: 1.4 },
      { title: 'Fig. 15: roll of the front plate', x: 't', y: ['alpha_fp'], unit: 'rad', to: 1.4 },
      { title: 'Fig. 15: roll of the back plate', x: 't', y: ['alpha_bp'], unit: 'rad', to: 1.4 },
      { title: 'Fig. 16: yaw of the front caster', x: 't', y: ['theta_fc'], unit: 'rad', to: 1.4 },
      { title: 'Fig. 16: yaw of the back caster', x: 't', y: ['theta_bc'], unit: 'rad', to: 1.4 },
    ],
  },
  {
    id: 'falling-ground',
    title: 'Falling onto the ground',
    source: 'Report, section 3.4.4, with rolling constraints and a ground',
    look: 'Ten degrees of lean at rest, stopped by the ground.',
    scenario: { version: 1, system: 'ripstik', initial: { alpha: '10 deg' }, duration: 5 },
    chapter: '3.4.4',
    plots: [
      { title: 'Height of the rod', x: 't', y: ['Z'], unit: 'm' },
      { title: 'Roll of the plates on the rod', x: 't', y: ['alpha_fp', 'alpha_bp'], unit: 'deg' },
    ],
  },
  {
    id: 'hanging',
    title: 'Hanging board (Fig. 8 to 10)',
    source: 'Report, section 3.3.2, Fig. 8 to 10',
    look: 'The rod is held; plates swing like pendulums and the casters turn under them, to ±129°. The report shows casters within ±45°: there the wheel offset did not turn with the plate.',
    scenario: {
      version: 1,
      system: 'ripstik',
      parameterSet: 'authors',
      constraints: 'none',
      hold: held,
      initial: { Z: 0.3, alpha_fp: '45 deg', alpha_bp: '-45 deg' },
      duration: 10,
    },
    figure: 'Fig. 8 to 10',
    chapter: '3.3.3',
    published: [
      { what: 'front plate swings between', measure: { kind: 'max', column: 'alpha_fp' }, value: Math.PI / 4, unit: 'rad', tolerance: 0.1, source: 'Section 3.3.3: between 45° and -45°' },
      { what: 'and', measure: { kind: 'min', column: 'alpha_fp' }, value: -Math.PI / 4, unit: 'rad', tolerance: 0.1, source: 'Section 3.3.3: between 45° and -45°' },
    ],
    plots: [
      { title: 'Fig. 8: roll of the front plate', x: 't', y: ['alpha_fp'], unit: 'rad' },
      { title: 'Fig. 8: roll of the back plate', x: 't', y: ['alpha_bp'], unit: 'rad' },
      { title: 'Fig. 9: yaw of the front caster', x: 't', y: ['theta_fc'], unit: 'rad' },
      { title: 'Fig. 9: yaw of the back caster', x: 't', y: ['theta_bc'], unit: 'rad' },
    ],
  },
  {
    id: 'turning',
    title: 'Ridden in a turn',
    source: '',
    look: 'The same gait, 15° with a bias of 5°: the bias turns the board.',
    scenario: {
      version: 1,
      system: 'ripstik',
      initial: { X_dot: 0.5 },
      control: {
        type: 'track',
        reference: { tau_fp: '5 deg + 15 deg * sin(2*pi*1.5*t)', tau_bp: '5 deg - 15 deg * sin(2*pi*1.5*t)' },
        kp: 60,
        kd: 3,
      },
      duration: 10,
    },
    plots: [
      { title: 'Path', x: 'X', y: ['Y'], unit: 'm', equal: true },
      { title: 'Heading', x: 't', y: ['theta'], unit: 'deg' },
    ],
  },
];
