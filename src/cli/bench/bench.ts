import { accelerations, type AccelerationReport } from './accelerations.ts';
import { apart, type Caller } from './apart.ts';
import { THOROUGH, machine, type Machine, type MeasureOptions } from './measure.ts';
import { boards, stepping, type Board, type SteppingReport } from './stepping.ts';

/** What `bench` prints: the two figures first, then what stands behind them. Processor time throughout. */
export interface BenchReport {
  machine: Machine;
  /** Median, by multipliers, on the rolling board. */
  microsecondsPerConstrainedAcceleration: number;
  /** Median by method, on the rolling board at 1 m/s. */
  stepsPerSecond: Record<string, number>;
  acceleration: AccelerationReport;
  stepping: Record<Board, Record<string, SteppingReport>>;
}

/** Measures this machine: constrained accelerations, and steps by method on the hanging and the coasting board. */
export function bench(options: MeasureOptions = THOROUGH, call: Caller = apart): BenchReport {
  const acceleration = accelerations(options);
  const steps = Object.fromEntries(
    (Object.keys(boards) as Board[]).map((board) => [board, stepping(board, options, call)]),
  ) as BenchReport['stepping'];
  return {
    machine: machine(),
    microsecondsPerConstrainedAcceleration: acceleration.acceleration.median,
    stepsPerSecond: Object.fromEntries(
      Object.entries(steps.coasting).map(([id, report]) => [id, report.stepsPerSecond]),
    ),
    acceleration,
    stepping: steps,
  };
}
