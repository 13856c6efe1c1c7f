import { Matrix } from 'ml-matrix';
import type { Scenario } from '../scenario/types.ts';
import type { System } from '../model/system.ts';
import { lqrOf } from './design/scenarioControl.ts';
import { exponential } from './sampled/exponential.ts';
import { frequencies, loopGain, oneInput } from './margins.ts';
import { modulus, plainEigenvalues } from './linearization/spectrum.ts';

/**
 * What a regulator's loop looks like: the loop gain at each input, the others closed (K. J. Åström and R. M. Murray, Feedback
 * Systems, 2nd ed., sections 9.6 and 10.1), and how the closed loop answers a step of an input's disturbance.
 */
export interface Responses {
  inputs: readonly string[];
  states: readonly string[];
  /** What it is of. */
  input: string;
  state: string;
  /** Of the loop gain L(i w) at one input; rad/s, ascending. */
  loop: { frequency: number[]; real: number[]; imaginary: number[] };
  /** A step of 1 added to what the input asks, from 0 s: the deviation of a state, and of what the regulator asks. */
  step: { t: number[]; state: number[]; input: number[] };
}

export interface ResponsesRequest {
  scenario: Scenario;
  /** Names; one that is none stands for the first input, and for the state that answers most. */
  input: string;
  state: string;
}

const STEPS = 400;
/** Time constants of the slowest mode that are shown, and the longest time, s. */
const CONSTANTS = 5;
const LONGEST = 30;

/**
 * Null where the regulator leaves every mode as it is.
 *
 * @param system that the scenario names
 * @throws ScenarioError where there is no design
 */
export function responsesOf({ scenario, input, state }: ResponsesRequest, system: System): Responses | null {
  const design = lqrOf(scenario, system);
  const { inputs, states } = design.linearization;
  const { A, B, toStates } = design.quotient;
  if (A.rows === 0) return null;
  const K = design.riccati.gain;
  const at = Math.max(0, inputs.indexOf(input));
  const loop = { A, B, K };
  const single = oneInput(loop, at);
  // Every few of the frequencies that see each pole.
  const all = frequencies(loop).filter((w, i, list) => i === 0 || w > list[i - 1]! * 1.01);
  const gains = all.map((w) => loopGain(single, w));
  const closed = Matrix.sub(A, B.mmul(K));
  const slowest = Math.min(...plainEigenvalues(closed).map(([re]) => Math.abs(re)));
  const duration = Math.min(LONGEST, CONSTANTS / (slowest || 1));
  const h = duration / STEPS;
  // (x, 1)' = (A - B K, b; 0, 0) (x, 1).
  const n = A.rows;
  const driven = Matrix.zeros(n + 1, n + 1);
  driven.setSubMatrix(Matrix.mul(closed, h), 0, 0);
  driven.setSubMatrix(Matrix.mul(B.getColumnVector(at), h), 0, n);
  const E = exponential(driven);
  let x = Matrix.zeros(n + 1, 1);
  x.set(n, 0, 1);
  const answers: number[][] = [];
  const step: Responses['step'] = { t: [], state: [], input: [] };
  for (let k = 0; k <= STEPS; k++) {
    const z = x.subMatrix(0, n - 1, 0, 0);
    step.t.push(k * h);
    answers.push(toStates.mmul(z).to1DArray());
    step.input.push(-K.getRowVector(at).mmul(z).get(0, 0));
    x = E.mmul(x);
  }
  const peak = (i: number): number => Math.max(...answers.map((x) => Math.abs(x[i]!)));
  // Of coordinates: what rates do follows.
  const most = states
    .slice(0, Math.ceil(states.length / 2))
    .reduce((best, _, i) => (peak(i) > peak(best) ? i : best), 0);
  const row = states.includes(state) ? states.indexOf(state) : most;
  step.state = answers.map((x) => x[row]!);
  return {
    inputs,
    states,
    input: inputs[at]!,
    state: states[row]!,
    loop: {
      frequency: all,
      real: gains.map(({ re }) => re.get(0, 0)),
      imaginary: gains.map(({ im }) => im.get(0, 0)),
    },
    step,
  };
}

/** Magnitude of the loop gain, and its phase (rad) without jumps of a turn. */
export function bodeOf({ real, imaginary }: Responses['loop']): { magnitude: number[]; phase: number[] } {
  let turns = 0;
  let before: number | null = null;
  const phase = real.map((re, i) => {
    const angle = Math.atan2(imaginary[i]!, re);
    if (before !== null && Math.abs(angle - before) > Math.PI) turns -= Math.sign(angle - before);
    before = angle;
    return angle + 2 * Math.PI * turns;
  });
  return { magnitude: real.map((re, i) => modulus([re, imaginary[i]!])), phase };
}
