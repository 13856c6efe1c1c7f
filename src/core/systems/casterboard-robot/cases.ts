import type { Case, CasePlot } from '../../cases/case.ts';

const paper = 'Kinugasa, Ishikawa, Sugimoto and Osuka 2013, recomputed from its Lagrangian with J = m1 l1² / 3';
const amplitude = Math.PI / 9;
const w = 6.4;

const plots: readonly CasePlot[] = [
  { title: 'Path', x: 'x', y: ['y'], unit: 'm', equal: true },
  { title: 'Plates', x: 't', y: ['phi_f', 'phi_r'], unit: 'deg' },
  { title: 'Heading', x: 't', y: ['theta'], unit: 'deg' },
];

/** Both plates sway by 20° at 6.4 rad/s, the rear one later by a phase; x is where the robot has got to after 5 s. */
function forward(id: string, title: string, phase: number, words: string, look: string, x: number): Case {
  return {
    id: `casterboard-robot-${id}`,
    title,
    among: { id: 'casterboard-robot', value: title.replace('Robot, plates ', '') },
    source: 'Kinugasa et al. 2013, the report’s reference [19]',
    look,
    picture: { time: 3.2, distance: 1.3 },
    scenario: {
      version: 1,
      system: 'casterboard-robot',
      initial: {
        phi_r: -amplitude * Math.sin(phase),
        phi_f_dot: amplitude * w,
        phi_r_dot: amplitude * w * Math.cos(phase),
      },
      control: {
        type: 'track',
        reference: {
          tau_f: 'pi/9 * sin(6.4*t)',
          tau_r: words === '0' ? 'pi/9 * sin(6.4*t)' : `pi/9 * sin(6.4*t - ${words})`,
        },
        kp: 100,
        kd: 1,
      },
      duration: 5,
    },
    published: [
      { what: 'x at 5 s', measure: { kind: 'end', column: 'x' }, value: x, unit: 'm', tolerance: 0.01, source: paper },
    ],
    plots,
  };
}

export const casterboardRobotCases: readonly Case[] = [
  forward(
    'in-phase',
    'Robot, plates in phase',
    0,
    '0',
    'Both weights sway together and the casters steer under them: it goes straight ahead, weaving.',
    1.097,
  ),
  forward(
    'quarter',
    'Robot, plates a quarter apart',
    Math.PI / 2,
    'pi/2',
    'The rear plate follows a quarter of a period later. It gets about as far, on a slanted path.',
    1.11,
  ),
  forward(
    'opposite',
    'Robot, plates opposed',
    Math.PI,
    'pi',
    'Out of phase it twists like a ridden board, and is the slowest.',
    0.993,
  ),
  {
    id: 'casterboard-robot-turning',
    title: 'Robot turning',
    source: 'Kinugasa et al. 2013, the report’s reference [19]',
    look: 'A bias on plates that move opposed: the robot settles on a small circle.',
    picture: { time: 14, distance: 1.4 },
    scenario: {
      version: 1,
      system: 'casterboard-robot',
      initial: { phi_f: 'pi/18', phi_r: '-pi/18', phi_f_dot: 'pi/18*11.4', phi_r_dot: '-pi/18*11.4' },
      control: {
        type: 'track',
        reference: { tau_f: 'pi/18 * sin(11.4*t) + pi/18', tau_r: '-pi/18 * sin(11.4*t) - pi/18' },
        kp: 100,
        kd: 1,
      },
      duration: 20,
    },
    published: [
      {
        what: 'diameter of the circle',
        measure: { kind: 'diameter', x: 'x', y: 'y', from: 8 },
        value: 0.425,
        unit: 'm',
        tolerance: 0.01,
        source: paper,
      },
    ],
    plots,
  },
];
