import { cosine, sine } from '../../elementary/trigonometry.ts';
import { inputsOf } from '../../model/inputs.ts';
import type { Feedback, Program } from '../../mechanics/forcing.ts';
import type { System } from '../../model/system.ts';
import type { RideControl, Scenario } from '../../scenario/types.ts';
import { RIDE_DEFAULTS } from '../../scenario/ride.ts';
import { plantOf } from '../design/scenarioControl.ts';
import { planeOf } from '../path/steadyTurn.ts';
import { boardLayer } from './boardLayer.ts';
import { riderLayer } from './riderLayer.ts';
import type { Layer, Sight } from './layer.ts';
import { Follower } from './wish.ts';

/**
 * A ride: commands as they come, or from a file, become torques once every sample. Help h mixes two riders, one whom a layer
 * keeps up and takes where the commands say, and one whose muscles the commands are: u = h layer + (1 - h) direct.
 * A foot on the ground, which pushes, drags and holds the rider up where the board is too slow to be balanced on, comes from
 * outside: forces along the heading and, as part of the help, a torque on the lean.
 */

/** A foot is down below the first of these speeds (m/s) and up above the second. */
const FOOT_DOWN = 0.7;
const FOOT_UP = 1.1;
/** A foot gives the whole by at most this acceleration (m/s²), and less over the last of the way (m/s). */
const FOOT_ACCELERATION = 1.5;
const FOOT_BAND = 0.3;
/** Without help a lean asks this share of what a twist asks, of both feet alike. */
const HAND_LEAN = 0.5;

/**
 * @param scenario checked, SI, with control of type ride
 * @param system that it names
 * @param control the scenario's own
 * @throws ScenarioError where no regulator holds this rider up
 */
export function rideFeedbackOf(scenario: Scenario, system: System, control: RideControl): Map<string, Feedback> {
  const { meta } = system;
  const plane = planeOf(meta);
  const layer = meta.gait!.hold?.length ? riderLayer(scenario, system) : boardLayer(meta);
  const { body } = layer;
  const along = [plane.x, plane.y].map((i) => `f_${meta.coordinates[i]!.name}`);
  const names = [
    ...meta.gait!.feet,
    ...along,
    ...(layer.lean ? [`f_${layer.lean.name}`] : []),
    ...body.map(({ input }) => input),
  ];
  const most = new Map(body.map(({ input, limit }) => [input, limit]));
  const known = inputsOf(meta).map((input) => input.name);
  const program = rideProgram(control, layer, plane, massOf(scenario, system, plane.x));
  const limits = control.limits ?? {};
  return new Map(
    names
      .filter((name) => known.includes(name))
      .map((name, k) => [
        name,
        new RideFeedback(program, Number(limits[name] ?? most.get(name) ?? (k < 2 ? layer.limit : Infinity))),
      ]),
  );
}

class RideFeedback implements Feedback {
  constructor(
    readonly program: Program,
    readonly limit: number,
  ) {}

  /** The program asks. */
  asked(): number {
    return 0;
  }

  /** A computer's inputs do not react between its samples. */
  addSlopes(): void {}
}

function massOf(scenario: Scenario, system: System, x: number): number {
  const { parameters } = plantOf(scenario, system);
  const n = system.meta.coordinates.length;
  const M = new Float64Array(n * n);
  system.mechanics(new Float64Array(n), new Float64Array(n), parameters, M, new Float64Array(n));
  return M[x * n + x]!;
}

function rideProgram(control: RideControl, layer: Layer, plane: ReturnType<typeof planeOf>, mass: number): Program {
  const { commands, help = RIDE_DEFAULTS.help, speed: target = RIDE_DEFAULTS.speed } = control;
  return {
    begin() {
      const follower = new Follower(commands, help);
      const sight = { foot: 0 } as Sight;
      const feet = new Float64Array(2);
      return (t, q, v, out) => {
        const wish = follower.at(t);
        const heading = q[plane.heading]!;
        const [c, s] = [cosine(heading), sine(heading)];
        const speed = c * v[plane.x]! + s * v[plane.y]!;
        const slow = share((FOOT_UP - speed) / (FOOT_UP - FOOT_DOWN));
        Object.assign(sight, { t, q, v, speed, across: c * v[plane.y]! - s * v[plane.x]!, wish });
        sight.foot = Math.max(slow, wish.brake);
        layer.ask(sight, feet);
        const { help } = wish;
        for (let k = 0; k < 2; k++) {
          const hand = layer.direct * (HAND_LEAN * wish.lean + (k === 0 ? 1 : -1) * wish.twist);
          out[k] = help * feet[k]! - (1 - help) * hand;
        }
        const pushed = wish.push * share((target - speed) / FOOT_BAND);
        const dragged = wish.brake * Math.max(-1, Math.min(1, speed / FOOT_BAND));
        const force = mass * FOOT_ACCELERATION * (pushed - dragged);
        out[2] = force * c;
        out[3] = force * s;
        if (!layer.lean) return;
        const { index, stiffness, damping } = layer.lean;
        out[4] = -help * sight.foot * (stiffness * q[index]! + damping * v[index]!);
        for (let k = 0; k < layer.body.length; k++) {
          const servo = layer.body[k]!;
          out[5 + k] = help * servo.ask(sight) + (1 - help) * servo.direct * wish[servo.wish];
        }
      };
    },
  };
}

const share = (x: number): number => Math.max(0, Math.min(1, x));
