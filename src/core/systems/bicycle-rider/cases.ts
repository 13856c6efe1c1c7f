import type { Case, CasePlot } from '../../cases/case.ts';

const source = 'Moore 2012: the bicycle with a leaning rider';

const leans: CasePlot = { title: 'Lean of frame and body, steer', x: 't', y: ['roll', 'lean', 'steer'], unit: 'deg' };
const path: CasePlot = { title: 'Path of the rear contact', x: 'x', y: ['y'], unit: 'm', equal: true };

export const bicycleRiderCases: readonly Case[] = [
  {
    id: 'bicycle-rider-no-hands',
    title: 'Bicycle ridden without hands',
    source,
    look: 'At 5 m/s the only torque is the waist’s, between upper body and frame. It tips the frame, the fork steers by itself, and the bicycle comes upright from two degrees.',
    picture: { time: 0.5, view: 'front' },
    scenario: {
      version: 1,
      system: 'bicycle-rider',
      initial: { speed: 5, roll: '2 deg' },
      control: {
        type: 'lqr',
        inputs: ['tau_lean'],
        at: { speed: 5 },
        Q: { roll: 1000, steer: 100, lean: 1000, roll_dot: 1, lean_dot: 1 },
        R: { tau_lean: 0.001 },
      },
      duration: 8,
    },
    plots: [leans, { title: 'Torque of the waist', x: 't', y: ['tau_lean'], unit: 'N·m' }, path],
  },
  {
    id: 'bicycle-rider-firm',
    title: 'Bicycle under a firm waist',
    source,
    look: 'A waist of 128 N·m/rad and 50 N·m·s/rad and no control, pushed at 5 m/s: the bicycle rights itself.',
    picture: { time: 0.4, view: 'front' },
    scenario: {
      version: 1,
      system: 'bicycle-rider',
      parameters: { leanStiffness: 128, leanDamping: 50 },
      initial: { speed: 5, roll_dot: 0.3 },
      method: { rtol: 1e-10 },
      duration: 10,
    },
    plots: [leans, path],
  },
  {
    id: 'bicycle-rider-limp',
    title: 'Bicycle under a limp rider',
    source,
    look: 'The same without stiffness: the upper body topples with 7.30 1/s, and throws the frame the other way.',
    picture: { time: 0.85, view: 'front' },
    scenario: {
      version: 1,
      system: 'bicycle-rider',
      initial: { speed: 5, lean: '0.1 deg' },
      method: { rtol: 1e-10 },
      duration: 1,
    },
    plots: [leans, path],
  },
];
