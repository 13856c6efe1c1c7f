import type { ControlCalls } from './controlTypes.ts';
import type { CsvCalls } from './csvTypes.ts';
import type { MechanicsCalls } from './mechanicsTypes.ts';
import type { RideCalls } from './rideTypes.ts';
import type { RunCalls } from './runTypes.ts';
import type { SweepCalls } from './sweepTypes.ts';
import type { TestsCalls } from './testsTypes.ts';

/** All that a worker can be asked; the part of a name before its dot is the service that answers. */
export type ComputeCalls = RunCalls & RideCalls & SweepCalls & ControlCalls & MechanicsCalls & CsvCalls & TestsCalls;
