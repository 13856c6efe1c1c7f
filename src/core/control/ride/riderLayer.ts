import { RIDE_BODY } from '../../scenario/ride.ts';
import { cosine, sine } from '../../elementary/trigonometry.ts';
import { Matrix } from 'ml-matrix';
import { inputsOf } from '../../model/inputs.ts';
import type { InputMeta, System, SystemMeta } from '../../model/system.ts';
import type { Scenario } from '../../scenario/types.ts';
import { GainSchedule } from '../design/gainSchedule.ts';
import { designLqr } from '../design/lqr.ts';
import { plantOf } from '../design/scenarioControl.ts';
import { located, preparedPlant } from '../linearization/preparedPlant.ts';
import type { Plant } from '../linearization/steadyMotion.ts';
import { planeOf, steadyTurn } from '../path/steadyTurn.ts';
import { place, type Layer, type Servo, type Sight } from './layer.ts';

/**
 * A rider kept up by the ankles: at the speed s that there is and for the curvature kappa that is wanted,
 * `u = kappa (u1 + K x1) - K (x - x0)`: the regulator K(s) about straight riding x0(s), with the turn that goes with kappa,
 * x0 + kappa x1 held by kappa u1 (steady turns are as good as linear in kappa up to 0.3 1/m; `steadyTurn.ts`). x is seen
 * from the board: heading and place are where they are.
 */

/** Speeds that regulators are made at, m/s: the gain changes most where it is slow. Held beyond the ends. */
const SPEEDS = [0.9, 1.3, 2, 3, 5];
/** Of the turn that a family of turns is taken from, 1/m. */
const GENTLE = 0.02;
/** The most of a turn: 1/m, and m/s² to its centre, which leans the rider by 9°. */
const TIGHTEST = 0.4;
const SIDEWAYS = 1.6;
/** Of the pump: torque that sways the plates against each other, N·m, and Hz. */
const PUMP = 110;
const FREQUENCY = 1.8;
/** N·m: what an ankle gives at most, and what a command asks of it without help. */
const LIMIT = 160;
const DIRECT = 30;
/** A foot on the ground holds the rider up by more than gravity (m g h) pulls him down; the damping's share of it, s. */
const HOLD = 2.5;
const HOLD_DAMPING = 0.15;
/** Of a lean that shows what the weight does, rad. */
const SMALL = 1e-4;

/** Of a whole crouch, the share of the height of the centre of mass; of a whole turn of the hips, rad. */
const DEEP = 0.28;
const WIDE = 0.6;
/** Hips and shoulders go ahead into a turn, rad for the tightest. */
const LEAD = 0.3;
/** Muscles that move the body: N/m and N·m/rad, damping as a share of the time that they take (s), the most that they give. */
const LEGS = { stiffness: 20_000, damping: 0.1, limit: 1500, direct: 400 };
const HIPS = { stiffness: 150, damping: 0.05, limit: 80, direct: 25 };

/** What the regulator weighs beside the rider's lean: roll of the plates on the rod and steer, and their rates. */
const FELT = ['alpha_fp', 'alpha_bp', 'theta_fc', 'theta_bc'];

/** Rows of K, then what a unit of curvature adds; by speed, for each foot. Made once for a board. */
const made = new WeakMap<System, Map<string, readonly GainSchedule[]>>();

/**
 * @param scenario checked, SI
 * @param system with a rider
 * @throws ScenarioError where there is no regulator
 */
export function riderLayer(scenario: Scenario, system: System): Layer {
  const { meta } = system;
  const n = meta.coordinates.length;
  // The feet balance a body that stands as it is told to: its own muscles see to that.
  const plant = stiff(withoutDrag(plantOf(scenario, system)));
  const plane = planeOf(meta);
  const leanName = meta.gait!.hold![0]!;
  const lean = place(meta, leanName);
  const schedules = schedulesOf(plant, [...FELT, leanName]);
  const row = new Float64Array(2 * n + 2);
  const board = place(meta, inputsOf(meta).find(({ name }) => name === meta.gait!.feet[0])!.tracks![0]!);
  const pull = gravityOn(plant, lean, board);
  return {
    lean: { name: leanName, index: lean, stiffness: HOLD * pull, damping: HOLD * HOLD_DAMPING * pull },
    limit: LIMIT,
    direct: DIRECT,
    body: servosOf(scenario, meta),
    ask({ t, q, v, speed, across, wish, foot }, feet) {
      const most = Math.min(TIGHTEST, SIDEWAYS / Math.max(speed * speed, 1e-3));
      const asked = wish.twist * most + (wish.lean * SIDEWAYS) / Math.max(speed * speed, 1);
      const curvature = Math.max(-most, Math.min(most, asked));
      const pump = PUMP * wish.pump * sine(2 * Math.PI * FREQUENCY * t);
      for (let k = 0; k < 2; k++) {
        schedules[k]!.at(speed, row);
        let u = row[2 * n]! * curvature + row[2 * n + 1]! + (k === 0 ? pump : -pump);
        for (let i = 0; i < n; i++) {
          if (i === plane.x || i === plane.heading) u -= row[n + i]! * (i === plane.x ? 0 : v[i]!);
          else if (i === plane.y) u -= row[n + i]! * across;
          else u -= row[i]! * q[i]! + row[n + i]! * v[i]!;
        }
        // With a foot on the ground the ankles' own stiffness holds the plates.
        feet[k] = (1 - foot) * u;
      }
    },
  };
}

/** What is held by default, held. */
function stiff(plant: Plant): Plant {
  const { meta } = plant.system;
  const held = (meta.held ?? []).map((name) => place(meta, name));
  return { ...plant, hold: [...new Set([...plant.hold, ...held])] };
}

/** Legs that crouch and hips that turn, those of them that are free; each follows its target, which moves no faster than a body. */
function servosOf({ hold, parameters }: Scenario, meta: SystemMeta): Servo[] {
  const servo = (
    wish: Servo['wish'],
    muscle: typeof LEGS,
    spring: string,
    target: (sight: Sight) => number,
  ): readonly Servo[] => {
    const name = RIDE_BODY[wish]!;
    const index = place(meta, name);
    const input = meta.inputs.find(({ column }) => Object.keys(column).join() === name)?.name;
    if (index < 0 || !input || hold.includes(name)) return [];
    const passive = parameters[spring] ?? 0;
    const { stiffness, damping, limit, direct } = muscle;
    return [
      {
        input,
        limit,
        direct,
        wish,
        ask(sight) {
          const wanted = target(sight);
          return passive * wanted - stiffness * (sight.q[index]! - wanted + damping * sight.v[index]!);
        },
      },
    ];
  };
  const deep = DEEP * (parameters['riderHeight'] ?? 0);
  return [
    ...servo('crouch', LEGS, 'legStiffness', ({ wish }) => deep * wish.crouch),
    ...servo('hips', HIPS, 'hipStiffness', ({ wish }) =>
      Math.max(-WIDE, Math.min(WIDE, WIDE * wish.hips + LEAD * wish.twist)),
    ),
  ];
}

/** Regulators are about steady motions, and with drag there is none: it is small beside what they do. */
function withoutDrag(plant: Plant): Plant {
  const { meta } = plant.system;
  const drag = meta.parameters.findIndex((p) => p.name === meta.gait!.drag);
  return { ...plant, parameters: plant.parameters.map((value, i) => (i === drag ? 0 : value)) };
}

/** What the weight does to a small lean of rider and board together, which leaves the ankles as they are, N·m/rad. */
function gravityOn({ system, parameters }: Plant, lean: number, board: number): number {
  const n = system.meta.coordinates.length;
  const [q, h] = [new Float64Array(n), new Float64Array(n)];
  q[lean] = q[board] = SMALL;
  system.mechanics(q, new Float64Array(n), parameters, new Float64Array(n * n), h);
  return h[lean]! / SMALL;
}

function schedulesOf(plant: Plant, felt: readonly string[]): readonly GainSchedule[] {
  const { system, parameters, constraints, hold } = plant;
  const key = JSON.stringify([[...parameters], constraints, hold]);
  const mine = made.get(system) ?? new Map<string, readonly GainSchedule[]>();
  made.set(system, mine);
  const found = mine.get(key);
  if (found) return found;
  const { meta } = system;
  const inputs = meta.gait!.feet.map((name) => inputsOf(meta).find((input) => input.name === name)!);
  const designs = SPEEDS.map((speed) => located('control', () => designAt(plant, speed, inputs, felt)));
  const schedules = inputs.map(
    (_, k) =>
      new GainSchedule(SPEEDS, (speed) => ({ gain: Matrix.rowVector(designs[SPEEDS.indexOf(speed)]!.getRow(k)) })),
  );
  mine.clear();
  mine.set(key, schedules);
  return schedules;
}

/** By foot: K (2n), then u1 + K x1, then K x0 of what stands still. */
function designAt(plant: Plant, speed: number, inputs: readonly InputMeta[], felt: readonly string[]): Matrix {
  const { meta } = plant.system;
  const n = meta.coordinates.length;
  const plane = planeOf(meta);
  const ahead = (meta.forward ?? meta.speed)!.along[0];
  const prepared = preparedPlant(plant, { [ahead]: speed }, inputs, 'control');
  const { gain } = designLqr(prepared.plant, { Q: weights(meta, felt), R: inputs.map(() => 1) });
  const turn = steadyTurn(plant, { [ahead]: speed }, GENTLE, inputs);
  const { q, v } = turn.motion;
  const straight = prepared.motion;
  const heading = q[plane.heading]!;
  return new Matrix(
    inputs.map((_, k) => {
      let feedforward = turn.u0[k]!;
      for (let i = 0; i < n; i++) {
        if (i !== plane.x && i !== plane.y && i !== plane.heading)
          feedforward += gain.get(k, i) * (q[i]! - straight.q[i]!) + gain.get(k, n + i) * (v[i]! - straight.v[i]!);
      }
      const [c, s] = [cosine(heading), sine(heading)];
      feedforward += gain.get(k, n + plane.y) * (c * v[plane.y]! - s * v[plane.x]!);
      feedforward += gain.get(k, n + plane.heading) * v[plane.heading]!;
      const rest = straight.q.reduce((sum, x, i) => sum + gain.get(k, i) * x, 0);
      return [...gain.getRow(k), feedforward / GENTLE, rest];
    }),
  );
}

function weights({ coordinates }: SystemMeta, felt: readonly string[]): number[] {
  const names = coordinates.map((c) => (felt.includes(c.name) ? 1 : 0));
  return [...names, ...names];
}
