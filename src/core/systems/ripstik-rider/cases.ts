import type { Case, CasePlot } from '../../cases/case.ts';

/** Weights on what can be felt: roll of the plates on the rod, steer, lean, and their rates. */
const felt = ['alpha_fp', 'alpha_bp', 'theta_fc', 'theta_bc', 'beta'];

/** Feet that balance, the gain designed for a speed (m/s). */
const byTheFeet = (speed: number, more: object = {}) => ({
  type: 'lqr' as const,
  inputs: ['tau_af', 'tau_ab'],
  at: speed > 0 ? { X_dot: speed } : {},
  Q: Object.fromEntries(felt.flatMap((name) => [name, `${name}_dot`].map((state) => [state, 1]))),
  ...more,
});

const leans: CasePlot = {
  title: 'Lean of the rider, roll of the plates',
  x: 't',
  y: ['beta', 'alpha_fp', 'alpha_bp'],
  unit: 'deg',
};
const torques: CasePlot = { title: 'Ankle torques', x: 't', y: ['tau_af', 'tau_ab'], unit: 'N·m' };
const path: CasePlot = { title: 'Path', x: 'X', y: ['Y'], unit: 'm', equal: true };

export const ripstikRiderCases: readonly Case[] = [
  {
    id: 'rider-balanced',
    title: 'Rider, balanced by the feet',
    source: '',
    look: 'Three degrees of lean at 1 m/s. Ankles turn the plates, casters follow, and the board is steered back under the body. The largest gain is 1,684 N·m/rad: 88.2 N·m at most. Analysis has its curve over speed.',
    picture: { time: 0.3 },
    scenario: {
      version: 1,
      system: 'ripstik-rider',
      initial: { X_dot: 1, beta: '3 deg' },
      control: byTheFeet(1),
      duration: 10,
    },
    plots: [leans, torques, path],
  },
  {
    id: 'rider-fast',
    title: 'Rider at 5 m/s: a twelfth of the effort',
    source: '',
    look: 'The same at 5 m/s, where a little steer moves the board far: the largest gain is 144 in place of 1,684, the ankles give 7.5 N·m in place of 88.',
    picture: { time: 0.6 },
    scenario: {
      version: 1,
      system: 'ripstik-rider',
      initial: { X_dot: 5, beta: '3 deg' },
      control: byTheFeet(5),
      duration: 10,
    },
    plots: [leans, torques, path],
  },
  {
    id: 'rider-standing',
    title: 'Rider who tries to stand still',
    source: '',
    look: 'At rest a turned plate only shifts the wheels a little. The gain is 58,226 N·m/rad: a fiftieth of a degree takes 20 N·m, from a tenth the rider falls. To balance by the feet is a matter of speed.',
    picture: { time: 0.4 },
    scenario: {
      version: 1,
      system: 'ripstik-rider',
      initial: { beta: '0.02 deg' },
      control: byTheFeet(0),
      duration: 10,
    },
    plots: [leans, torques],
  },
  {
    id: 'rider-late',
    title: 'Rider whose feet answer late',
    source: '',
    look: 'Half a degree at 1 m/s, held for 2 ms and 0.19 s late, about as a person reacts. The delay margin is 0.2087 s: it swings and comes to rest only just. At 0.22 s the swing grows.',
    picture: { time: 0.8 },
    scenario: {
      version: 1,
      system: 'ripstik-rider',
      initial: { X_dot: 1, beta: '0.5 deg' },
      control: byTheFeet(1, { sample: 0.002, delay: 0.19 }),
      duration: 5,
    },
    plots: [leans, torques, path],
  },
  {
    id: 'rider-hips',
    title: 'Rider who swings the hips',
    source: '',
    look: 'Hips and shoulders swing by 34° against the feet, every 0.4 s the other way, and the feet do no more than balance. From 1.5 m/s, against the drag of the wheels, the board goes at 2.09 m/s after 12 s; with still hips at 1.28.',
    picture: { time: 6.2 },
    scenario: {
      version: 1,
      system: 'ripstik-rider',
      release: ['twist'],
      parameters: { wheelDrag: 0.5 },
      initial: { X_dot: 1.5 },
      control: {
        type: 'ride',
        commands: Array.from({ length: 30 }, (_, k) => [Math.round(4 * k) / 10, 'hips', k % 2 === 0 ? 1 : -1] as const),
      },
      duration: 12,
    },
    plots: [
      { title: 'Twist of the hips, heading', x: 't', y: ['twist', 'theta'], unit: 'deg' },
      { title: 'Speed', x: 't', y: ['speed'], unit: 'm/s' },
      torques,
    ],
  },
  {
    id: 'rider-landing',
    title: 'Rider who lands on soft legs',
    source: '',
    look: 'Down at 1.4 m/s, as after a hop of 10 cm, at two degrees of lean. Legs give by 10.4 cm, the wheels carry 1,444 N at most, twice the weight; on stiff legs (20,000 N/m) 2,088 N. The feet balance on.',
    picture: { time: 0.15 },
    scenario: {
      version: 1,
      system: 'ripstik-rider',
      release: ['crouch'],
      initial: { X_dot: 1, beta: '2 deg', crouch_dot: 1.4 },
      control: byTheFeet(1),
      duration: 3,
    },
    plots: [
      { title: 'Crouch', x: 't', y: ['crouch'], unit: 'm' },
      { title: 'Load on the wheels', x: 't', y: ['lambda_2', 'lambda_4'], unit: 'N' },
      leans,
    ],
  },
];
