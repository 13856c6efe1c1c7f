/**
 * The derivation's program of a system as data (`accelerations.generated.json`, written by derivation/direct.py): what an
 * engine other than TypeScript is written from.
 */

/** One operation; operands are positions of earlier ones. */
export type Op = readonly [kind: string, first: number | string, second?: number, third?: number];

export interface Tape {
  readonly ops: readonly Op[];
  /** Values that depend on the parameters alone, in the order of the constants. */
  readonly prepare: readonly number[];
  /** By constraint set, the values of each array that its functions write. */
  readonly sets: Readonly<Record<string, TapeSet>>;
}

export interface TapeSet {
  readonly rate: readonly number[];
  readonly lambda: readonly number[];
  readonly factors: readonly number[];
  /** Pairs of which the first must be larger for the accelerations to exist. */
  readonly larger: readonly number[];
  readonly smaller: readonly number[];
  readonly shift: readonly number[];
  readonly slip: readonly number[];
  readonly heights: readonly number[];
}
