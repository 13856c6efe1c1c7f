import type { Scenario } from '../../scenario/types.ts';
import type { System } from '../../model/system.ts';
import { decays, type Decay, type LqrDesign, type UnreachableMode } from './lqr.ts';
import type { InputReach } from '../linearization/reachability.ts';
import type { PreparedPlant } from '../linearization/preparedPlant.ts';
import { lqrOf, preparedOf } from './scenarioControl.ts';
import type { Complex, Mode } from '../linearization/spectrum.ts';

/** A linearization and its design as plain numbers: for the command line, files and messages between threads. */
export interface ControlReport {
  system: string;
  /** Coordinates, then velocities (2n); inputs (k). */
  states: readonly string[];
  inputs: readonly string[];
  /** 2n x 2n and 2n x k, rows first. */
  A: number[][];
  B: number[][];
  /** Orthonormal basis N of the deviations that the constraints allow, 2n x d. */
  basis: number[][];
  /** On the tangent space of the constraints, neutral ones as exact zeros. */
  eigenvalues: Complex[];
  /** Modes that no input reaches, one entry per dimension. */
  uncontrollable: (Mode & { weighted?: boolean })[];
  /** Without an lqr these are null. K is k x 2n in `u = -K x`. */
  K: number[][] | null;
  closedLoopEigenvalues: Complex[] | null;
  careResidual: number | null;
  /** Diagonals, by state and by input. */
  Q: number[] | null;
  R: number[] | null;
  /** The same by name, as they were used: states that `control.Q` leaves out count 0, or 1 where it names none. */
  weights: { Q: Record<string, number>; R: Record<string, number> } | null;
  /** Of the modes that the design placed. */
  closedLoop: Decay[] | null;
  /** Reachable modes on the imaginary axis that Q does not see: left alone. */
  unseen: Mode[] | null;
  point: { q: number[]; v: number[]; multipliers: number[]; moving: readonly string[] };
  reachability: {
    dimension: number;
    stages: number[];
    margin: { kept: number; dropped: number };
    /** How far the complement is from moving by itself, relative; above rounding it does not exist. */
    complementResidual: number;
    byInput: InputReach[];
  };
  orders: OrdersReport;
}

/** The three orders of linearization: (a) eliminate, then linearize; (b) linearize, then eliminate; (c) Omega frozen. */
export interface OrdersReport {
  /** Largest entry of (b) - (a) and of (c) - (a) on the tangent space. */
  difference: number;
  frozenDifference: number;
  /** Of (b) and of (c). */
  linearizeFirstEigenvalues: Complex[];
  frozenEigenvalues: Complex[];
}

/**
 * Everything about a scenario's operating point and, where it has one, its lqr.
 *
 * @param scenario checked, SI
 * @param system that the scenario names
 * @throws ScenarioError where the point is no steady motion or the design can't be had
 */
export function controlReport(scenario: Scenario, system: System): ControlReport {
  const design = scenario.control?.type === 'lqr' ? lqrOf(scenario, system) : null;
  const prepared = preparedOf(scenario, system);
  const { orders, spectra } = prepared;
  return {
    ...plantReport(scenario, prepared, design?.unreachable ?? prepared.plant.modes),
    ...designReport(design),
    orders: {
      difference: orders.difference,
      frozenDifference: orders.frozenDifference,
      linearizeFirstEigenvalues: spectra.linearizeFirst,
      frozenEigenvalues: spectra.frozen,
    },
  };
}

type PlantPart = Omit<ControlReport, 'orders' | keyof ReturnType<typeof designReport>>;

function plantReport(
  scenario: Scenario,
  { plant, spectra }: PreparedPlant,
  modes: (Mode | UnreachableMode)[],
): PlantPart {
  const {
    linearization: { motion, states, inputs, A, B, basis },
    split,
    byInput,
  } = plant;
  return {
    system: scenario.system,
    states,
    inputs,
    A: A.to2DArray(),
    B: B.to2DArray(),
    basis: basis.to2DArray(),
    eigenvalues: spectra.plain,
    uncontrollable: modes,
    // x + 0 makes -0 a 0, which is what a JSON file keeps of it.
    point: {
      q: [...motion.q],
      v: [...motion.v],
      multipliers: Array.from(motion.lambda, (x) => x + 0),
      moving: motion.moving,
    },
    reachability: {
      dimension: split.reachable.columns,
      stages: split.stages,
      margin: split.margin,
      complementResidual: split.complementResidual,
      byInput,
    },
  };
}

function byName(names: readonly string[], values: readonly number[]): Record<string, number> {
  return Object.fromEntries(names.map((name, i) => [name, values[i]!]));
}

function designReport(design: LqrDesign | null) {
  return {
    K: design?.gain.to2DArray() ?? null,
    closedLoopEigenvalues: design?.closedLoop ?? null,
    careResidual: design?.riccati.residual ?? null,
    Q: design ? [...design.weights.Q] : null,
    R: design ? [...design.weights.R] : null,
    weights: design && {
      Q: byName(design.linearization.states, design.weights.Q),
      R: byName(design.linearization.inputs, design.weights.R),
    },
    closedLoop: design ? decays(design.placed) : null,
    unseen: design?.unseen ?? null,
  };
}
