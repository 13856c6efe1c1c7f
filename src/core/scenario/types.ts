import type { PathOptions } from './path.ts';

/** The scenario: one JSON for page, link, worker, command line and tests. */

/** A number (SI, radians) or an expression such as `"10 deg"`. */
export type NumberOrExpression = number | string;

/** The computer that runs a controller; without `sample` there is none and the controller acts continuously. */
export interface Computer {
  /** It measures at k * sample and holds its inputs in between, s. */
  sample?: number | undefined;
  /** From a measurement to when its inputs act, s; of any length. */
  delay?: number | undefined;
  /** `continuous` (default): the continuous regulator's gain, held; `sampled`: the least cost among held inputs. */
  design?: 'continuous' | 'sampled' | undefined;
  /** By input. */
  actuators?: Record<string, Actuator> | undefined;
  /** What is measured, by a state's name or an expression of states; without it every state is, exactly. */
  sensors?: Record<string, Sensor> | undefined;
  /** Intensities of the white noise that a Kalman filter expects in each state's rate, by state, unit² / s. */
  process?: Record<string, number> | undefined;
  /** Of the sensors' noise. */
  seed?: number | undefined;
}

/**
 * What a motor makes of what is asked: at most `limit`, changing by at most `rate` (per s), in steps of `resolution`, and
 * reached with a time constant `lag` (s).
 */
export interface Actuator {
  limit?: number;
  rate?: number;
  lag?: number;
  resolution?: number;
}

/** What a sensor adds to what it measures, in its own unit. */
export interface Sensor {
  /** Standard deviation per sample. */
  noise?: number;
  /** White noise, per √Hz: `density / √sample` is its standard deviation per sample. */
  density?: number;
  /** Steps in which it reads. */
  resolution?: number;
  /** Constant error. */
  bias?: number;
  /** Random walk of the error, per √s. */
  drift?: number;
  /** Random walk (per √s) by which a filter follows the error as a state of its own; without it, it takes the sensor for right. */
  follow?: number;
}

export interface LqrControl extends Computer {
  type: 'lqr';
  inputs: string[];
  at?: Record<string, NumberOrExpression>;
  Q?: Record<string, NumberOrExpression>;
  R?: Record<string, NumberOrExpression>;
  limits?: Record<string, NumberOrExpression>;
  schedule?: SpeedSchedule | undefined;
  path?: PathOptions | undefined;
}

/** Gains designed at `count` forward speeds between two (m/s) and interpolated at the speed that there is. */
export interface SpeedSchedule {
  from: number;
  to: number;
  count: number;
}

export interface TrackControl extends Omit<Computer, 'design'> {
  type: 'track';
  /** Keyed by the input that follows it; expressions of t. */
  reference: Record<string, NumberOrExpression>;
  kp: number;
  kd: number;
  limits?: Record<string, NumberOrExpression>;
}

/** At a time (s), what the rider is told, and how much of it. */
export type RideCommand = readonly [time: number, command: string, value: number];

/** A rider who is told where to go: commands as data, and a layer beneath that balances. */
export interface RideControl extends Pick<Computer, 'sample' | 'delay' | 'actuators'> {
  type: 'ride';
  /** In the order of their times; each acts from the first sample at or after its time. */
  commands: readonly RideCommand[];
  /** How much the stabilizing layer does of what it would, 0 (the commands are the torques) to 1. */
  help?: number | undefined;
  /** That a start pushes up to, m/s. */
  speed?: number | undefined;
  limits?: Record<string, NumberOrExpression>;
}

export interface MethodOptions {
  name: string;
  /** Every method has one but `ida`, which takes the residual as it is. */
  formulation?: string;
  rtol: number;
  atol: number;
  step?: number;
  maxStep?: number;
  stages?: number;
  projection: boolean;
  /** What computes the steps, by the same operations to the last bit; absent: the fastest that the host has. */
  engine?: EngineId;
}

/** Permanent ids: WebAssembly written from the derivation's tape, and the program's own TypeScript. */
export const ENGINE_NAMES = ['wasm', 'typescript'] as const;
export type EngineId = (typeof ENGINE_NAMES)[number];

/** A scenario as written: every key but `version` and `system` may be left out. */
export interface ScenarioFile {
  version: 1;
  system: string;
  parameterSet?: string;
  parameters?: Record<string, NumberOrExpression>;
  constraints?: string;
  hold?: string[];
  /** Of the coordinates that the system holds by default, those that are free. */
  release?: string[];
  initial?: Record<string, NumberOrExpression>;
  inputs?: Record<string, NumberOrExpression>;
  control?: LqrControl | TrackControl | RideControl;
  at?: Record<string, NumberOrExpression>;
  method?: Partial<MethodOptions>;
  duration?: number;
  outputStep?: number;
  events?: Record<string, 'stop' | 'ignore'>;
  columns?: string[];
}

/** A scenario after checking: every default filled in, every number a number (inputs and references stay expressions). */
export interface Scenario {
  version: 1;
  system: string;
  /** The text that describes an own system. */
  description?: string;
  parameterSet: string | null;
  /** Every parameter of the system, SI. */
  parameters: Record<string, number>;
  constraints: string;
  /** Everything that is held, by default too. */
  hold: string[];
  release?: string[];
  /** Only what was named. */
  initial: Record<string, number>;
  inputs: Record<string, NumberOrExpression>;
  control: LqrControl | TrackControl | RideControl | null;
  at: Record<string, number>;
  method: MethodOptions;
  duration: number;
  outputStep: number;
  events: Record<string, 'stop' | 'ignore'>;
  columns: string[];
}

/** A refusal that says what, where, and what would be right. */
export class ScenarioError extends Error {
  /** Path of the offending key, e.g. `initial.alpha_fp`. */
  readonly path: string;
  constructor(path: string, message: string) {
    super(path ? `${path}: ${message}` : message);
    this.name = 'ScenarioError';
    this.path = path;
  }
}
