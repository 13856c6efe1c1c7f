import type { AttitudeCharts } from '../mechanics/attitudeCharts.ts';
import type { ConstrainedSystem } from '../mechanics/constrainedSystem.ts';
import type { Projection } from '../mechanics/projection.ts';
import { maxAbs } from '../linalg/dense.ts';
import type { System } from '../model/system.ts';
import type { Scenario } from '../scenario/types.ts';
import type { Actuation } from './actuation.ts';
import type { EnergyBalance } from './energyBalance.ts';
import type { LastStep } from './lastStep.ts';

/** Rows that a chunk starts with room for; it grows when a long step brings more. */
const CHUNK_ROWS = 512;

/** What rows are made of. */
export interface RowParts {
  readonly system: System;
  /** With the formulas as they stand. */
  readonly dynamics: ConstrainedSystem;
  readonly projection: Projection;
  readonly actuation: Actuation;
  readonly charts: AttitudeCharts | null;
  readonly extras: readonly string[];
}

/** The rows of a run, column by column, until they are taken. */
export class Rows {
  readonly columns: readonly string[];
  /** Waiting to be taken. */
  count = 0;
  /** Of the whole run. */
  emitted = 0;
  /** Of all rows, of the constraints. */
  largestResidual = 0;
  private readonly parts: RowParts;
  private readonly extras: ReadonlySet<string>;
  private chunk: Float64Array[];
  private readonly lambda: Float64Array;
  private readonly u: Float64Array;
  private readonly energies = new Float64Array(2);

  /** @param scenario tells how many rows there will be */
  constructor(parts: RowParts, { duration, outputStep }: Pick<Scenario, 'duration' | 'outputStep'>) {
    this.parts = parts;
    this.extras = new Set(parts.extras);
    this.columns = this.names();
    const rows = Math.min(CHUNK_ROWS, Math.ceil(duration / outputStep) + 2);
    this.chunk = this.columns.map(() => new Float64Array(rows));
    this.lambda = new Float64Array(parts.dynamics.m);
    this.u = new Float64Array(parts.actuation.names.length);
  }

  /**
   * One row: the state that was looked at, projected if projection is on, and what is derived from it.
   * @returns false where that is not finite; then there is no row
   */
  emit(time: number, step: LastStep, balance: EnergyBalance): boolean {
    const { extras, lambda, u, energies, chunk } = this;
    const { system, dynamics, projection, actuation, charts } = this.parts;
    const { atQ: q, atV: v } = step;
    const projected = step.project(time);
    if (!(maxAbs(q) < Infinity && maxAbs(v) < Infinity)) return false;
    if (this.count >= chunk[0]!.length) this.grow();
    const row = this.count++;
    let c = 0;
    const put = (x: number): void => void (this.chunk[c++]![row] = x);
    put(time);
    for (let i = 0; i < q.length; i++) put(q[i]!);
    for (let i = 0; i < v.length; i++) put(v[i]!);
    if (extras.has('lambda')) {
      if (!projection.multipliers(time, q, v, lambda)) lambda.fill(NaN);
      for (let r = 0; r < lambda.length; r++) put(lambda[r]!);
    }
    (charts ?? system).energy(q, v, dynamics.parameters, energies);
    const [kinetic, potential] = energies as unknown as [number, number];
    balance.row(kinetic, potential);
    const residual = projected ? projection.left : projection.residual(q, v);
    this.largestResidual = Math.max(this.largestResidual, residual);
    if (extras.has('energy')) put(kinetic + potential);
    if (extras.has('residual')) put(residual);
    if (extras.has('inputs')) {
      actuation.values(time, q, v, u);
      for (let i = 0; i < u.length; i++) put(u[i]!);
    }
    if (extras.has('energy-parts')) {
      put(kinetic);
      put(potential);
    }
    this.emitted++;
    return true;
  }

  /** Hands them over, column by column. */
  take(): { columns: Float64Array[]; rows: number } {
    const taken = { columns: this.chunk.map((column) => column.slice(0, this.count)), rows: this.count };
    this.count = 0;
    return taken;
  }

  /** None were emitted. */
  clear(): void {
    this.count = this.emitted = this.largestResidual = 0;
  }

  private names(): string[] {
    const { extras } = this;
    const { system, dynamics, actuation } = this.parts;
    const names = system.meta.coordinates.map((c) => c.name);
    const list = ['t', ...names, ...names.map((name) => `${name}_dot`)];
    if (extras.has('lambda')) for (let r = 1; r <= dynamics.m; r++) list.push(`lambda_${r}`);
    if (extras.has('energy')) list.push('energy');
    if (extras.has('residual')) list.push('residual');
    if (extras.has('inputs')) list.push(...actuation.names);
    if (extras.has('energy-parts')) list.push('kinetic', 'potential');
    return list;
  }

  private grow(): void {
    this.chunk = this.chunk.map((old) => {
      const grown = new Float64Array(2 * old.length);
      grown.set(old);
      return grown;
    });
  }
}
