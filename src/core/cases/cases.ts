import type { ScenarioFile } from '../scenario/types.ts';

/** A built-in case: data for the page's menu, the command line, documentation and tests. */
export interface Case {
  id: string;
  title: string;
  /** The figure or paper it reproduces, or empty. */
  source: string;
  /** One line: what to look at. */
  look: string;
  scenario: ScenarioFile;
}

const held = ['X', 'Y', 'Z', 'alpha', 'psi', 'theta'];

export const cases: readonly Case[] = [
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
  },
  {
    id: 'released',
    title: 'Released at 1 m/s',
    source: '',
    look: 'Half a degree of lean grows until a corner of the deck touches the ground.',
    scenario: { version: 1, system: 'ripstik', initial: { X_dot: 1, alpha: '0.5 deg' }, duration: 10 },
  },
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
  },
  {
    id: 'falling-ground',
    title: 'Falling onto the ground',
    source: 'Report, section 3.4.4, with rolling constraints and a ground',
    look: 'Ten degrees of lean at rest, stopped by the ground.',
    scenario: { version: 1, system: 'ripstik', initial: { alpha: '10 deg' }, duration: 5 },
  },
  {
    id: 'hanging',
    title: 'Hanging board (Fig. 8 to 10)',
    source: 'Report, section 3.3.2, Fig. 8 to 10',
    look: 'The rod is held; plates swing like pendulums and the casters turn under them. The report shows casters within ±45°: there the wheel offset did not turn with the plate.',
    scenario: {
      version: 1,
      system: 'ripstik',
      parameterSet: 'authors',
      constraints: 'none',
      hold: held,
      initial: { Z: 0.3, alpha_fp: '45 deg', alpha_bp: '-45 deg' },
      duration: 10,
    },
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
  },
];
