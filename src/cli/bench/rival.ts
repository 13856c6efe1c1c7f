import { SEED, STATES, constrainedAcceleration } from './accelerations.ts';
import { Checksum, measureTogether, type MeasureOptions, type Times, type Work } from './measure.ts';
import { consistentStates, dynamicsOf, scenarioOf, type State } from './states.ts';
import { MujocoBoard, type RootJoint } from './mujoco.ts';

/** Largest difference of accelerations, relative to the largest, at which both sides still compute the same mechanics. */
const SAME = 1e-9;

export interface RivalReport {
  mujocoVersion: string;
  states: number;
  /** Ours on the rolling board, with its four constraints. */
  constrained: Times;
  /** Ours without constraints: the same problem as theirs. */
  free: Times;
  /** `mj_forward` without constraints, by how the rod is joined to the world. */
  mjForward: Record<RootJoint, Times>;
  /** A call into the module that does nothing, µs: part of every `mj_forward`, whose loop is in JavaScript. */
  border: number;
  /** Medians: ours with constraints, and without, over the faster of theirs without. */
  ratio: number;
  ratioFree: number;
  /** Largest difference between the free accelerations of both, relative to the largest. */
  disagreement: number;
  checksums: { ours: string; theirs: string };
}

/**
 * A constrained acceleration of ours beside MuJoCo's `mj_forward` for the same five bodies, in turns, at the same
 * states. The module offers no loop of its own, so both loop in JavaScript over states made beforehand.
 */
export async function rival(options: MeasureOptions): Promise<RivalReport> {
  const rolling = scenarioOf({ version: 1, system: 'ripstik' });
  const dynamics = dynamicsOf(rolling);
  const free = dynamicsOf({ ...rolling, constraints: 'none' });
  const states = consistentStates(dynamics, STATES, SEED);
  const hinges = await MujocoBoard.load(rolling.parameters, 'hinges');
  const freeJoint = await MujocoBoard.load(rolling.parameters, 'free');

  const [ours, theirs] = [new Checksum(), new Checksum()];
  const [a, b, none] = [new Float64Array(dynamics.n), new Float64Array(dynamics.n), new Float64Array(0)];
  let disagreement = 0;
  for (const { q, v } of states) {
    if (!free.acceleration(0, q, v, a, none)) throw new Error(`no acceleration: ${free.failure}`);
    hinges.forward(hinges.positionsOf(q), hinges.velocitiesOf(q, v));
    hinges.acceleration(b);
    a.forEach((x) => ours.add(x));
    b.forEach((x) => theirs.add(x));
    disagreement = Math.max(
      disagreement,
      Math.max(...a.map((x, i) => Math.abs(x - b[i]!))) / Math.max(...b.map(Math.abs)),
    );
  }
  if (!(disagreement < SAME)) throw new Error(`MuJoCo's board is not ours: accelerations differ by ${disagreement}`);

  const times = measureTogether(
    {
      constrained: constrainedAcceleration(dynamics, states),
      hinges: forwards(hinges, states),
      free: constrainedAcceleration(free, states),
      freeJoint: forwards(freeJoint, states),
      border: (count) => {
        let sum = 0;
        for (let i = 0; i < count; i++) sum += hinges.callNothing();
        return sum;
      },
    },
    options,
  );
  const fastest = Math.min(times.hinges.median, times.freeJoint.median);
  const report = {
    mujocoVersion: hinges.version,
    states: states.length,
    constrained: times.constrained,
    free: times.free,
    mjForward: { hinges: times.hinges, free: times.freeJoint },
    border: times.border.median,
    ratio: times.constrained.median / fastest,
    ratioFree: times.free.median / fastest,
    disagreement,
    checksums: { ours: ours.text, theirs: theirs.text },
  };
  hinges.dispose();
  freeJoint.dispose();
  return report;
}

function forwards(board: MujocoBoard, states: readonly State[]): Work {
  const positions = states.map(({ q }) => board.positionsOf(q));
  const velocities = states.map(({ q, v }) => board.velocitiesOf(q, v));
  return (count) => {
    let sum = 0;
    for (let i = 0, k = 0; i < count; i++) {
      board.forward(positions[k]!, velocities[k]!);
      sum += board.accelerationAt(3);
      if (++k === states.length) k = 0;
    }
    return sum;
  };
}
