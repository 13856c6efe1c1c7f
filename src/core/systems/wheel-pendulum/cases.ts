import type { Case } from '../../cases/case.ts';

const figures = 'the authors’ figures, read from the pictures';

export const wheelPendulumCases: readonly Case[] = [
  {
    id: 'wheel-pendulum',
    title: 'Pendulum on a wheel let go',
    source: 'Report, section 3.5.1',
    chapter: '3.5.1',
    look: 'Upright at ψ = −90°, six degrees off: the rod falls and its wheel rolls away under it. (Nothing keeps the rod out of the ground.)',
    picture: { time: 0.9 },
    scenario: {
      version: 1,
      system: 'wheel-pendulum',
      initial: { psi: '-96 deg' },
      method: { rtol: 1e-10 },
      duration: 10,
    },
    plots: [
      { title: 'Hub', x: 't', y: ['X'], unit: 'm' },
      { title: 'Wheel and pendulum', x: 't', y: ['phi', 'psi'], unit: 'rad' },
    ],
  },
  {
    id: 'wheel-pendulum-lqr',
    title: 'Pendulum on a wheel balanced',
    source: 'Report, section 3.5.1, and the authors’ later figures',
    chapter: '3.5.1',
    look: 'The regulator catches the rod, then two blows at 8 s and 12 s: the wheel rolls under it, and back.',
    picture: { time: 8.4 },
    scenario: {
      version: 1,
      system: 'wheel-pendulum',
      initial: { psi: '-96 deg' },
      inputs: { tau_phi: '22*exp(-10*(t-8)^2) - 22*exp(-10*(t-12)^2)' },
      control: {
        type: 'lqr',
        inputs: ['tau_phi'],
        Q: { X: 20, X_dot: 5, psi: 100, psi_dot: 40, phi: 30, phi_dot: 100 },
      },
      duration: 15,
    },
    published: [
      {
        what: 'X falls to',
        measure: { kind: 'min', column: 'X', to: 4 },
        value: -0.37,
        unit: 'm',
        tolerance: 0.01,
        source: figures,
      },
      {
        what: 'X falls after the first blow to',
        measure: { kind: 'min', column: 'X', from: 8, to: 11 },
        value: -0.39,
        unit: 'm',
        tolerance: 0.01,
        source: figures,
      },
      {
        what: 'X rises after the second blow to',
        measure: { kind: 'max', column: 'X', from: 12 },
        value: 0.34,
        unit: 'm',
        tolerance: 0.01,
        source: figures,
      },
      {
        what: 'psi at the least',
        measure: { kind: 'min', column: 'psi' },
        value: -1.69,
        unit: 'rad',
        tolerance: 0.02,
        source: figures,
      },
      {
        what: 'psi at the most',
        measure: { kind: 'max', column: 'psi' },
        value: -1.51,
        unit: 'rad',
        tolerance: 0.02,
        source: figures,
      },
    ],
    plots: [
      { title: 'Hub', x: 't', y: ['X'], unit: 'm' },
      { title: 'Wheel and pendulum', x: 't', y: ['phi', 'psi'], unit: 'rad' },
      { title: 'Torque: regulator and blows', x: 't', y: ['tau_phi'], unit: 'N·m' },
    ],
  },
];
