/**
 * The engines that runs are made by: TypeScript, and WebAssembly where the host compiles it and the derivation has left a
 * tape. Both give the same bits, so that which one makes a run matters for its time alone.
 */
import type { EmbeddedTableau } from '../integrators/runge-kutta/tableau.ts';
import type { Tape } from '../model/tape.ts';
import { compiles, instantiate } from './host.ts';
import { layoutOf, type Contact, type Layout } from './layout.ts';
import { writeProgram } from './program.ts';

interface Exports {
  memory: { buffer: ArrayBuffer };
  accelerations(y: number, rate: number): number;
  project(y: number): number;
  steps(
    place: number,
    count: number,
    t: number,
    h: number,
    error: number,
    limit: number,
    most: number,
    rtol: number,
    atol: number,
    projecting: number,
  ): number;
  makeDense(step: number, t: number, h: number): number;
  interpolate(step: number, s: number): void;
}

/** What works with a machine's memory; it is told when another takes its place. */
export interface Tenant {
  /** Takes the memory, unless it has it. */
  claim(): void;
  /** Keeps what it needs: the memory is another's from now on. */
  release(): void;
  /** Generalized forces at time t (s) and the state at an address, into the memory's `force`. */
  force(t: number, address: number): void;
}

/** One compiled program. Its memory serves one tenant at a time. */
export class Machine {
  readonly run: Omit<Exports, 'memory'>;
  readonly memory: Float64Array;
  readonly layout: Layout;
  private tenant: Tenant | null = null;

  constructor(bytes: Uint8Array<ArrayBuffer>, layout: Layout) {
    const force = (t: number, address: number): void => this.tenant!.force(t, address);
    const exports = instantiate(bytes, { force }) as Exports;
    this.run = exports;
    this.memory = new Float64Array(exports.memory.buffer);
    this.layout = layout;
  }

  /** @returns whether the tenant is a new one, who has to bring what it needs */
  takenBy(tenant: Tenant): boolean {
    if (this.tenant === tenant) return false;
    this.tenant?.release();
    this.tenant = tenant;
    return true;
  }
}

/** By constraint set of a tape, by tableau, without and with forces from outside. */
const machines = new WeakMap<object, Map<EmbeddedTableau, (Machine | null)[]>>();

/**
 * The machine for a pair on one constraint set; compiled once.
 *
 * @param tape of the derivation
 * @param setId of the constraint set
 * @param tableau of the method
 * @param contact null without one
 * @param n coordinates
 * @param forced forces act from outside
 * @returns null where WebAssembly is refused
 */
export function machineFor(
  tape: Tape,
  setId: string,
  tableau: EmbeddedTableau,
  contact: Contact | null,
  n: number,
  forced: boolean,
): Machine | null {
  const set = tape.sets[setId]!;
  let ofSet = machines.get(set);
  if (!ofSet) machines.set(set, (ofSet = new Map()));
  let both = ofSet.get(tableau);
  if (!both) ofSet.set(tableau, (both = []));
  const known = both[Number(forced)];
  if (known !== undefined) return known;
  return (both[Number(forced)] = compiled({ tape, set, tableau, contact, n, forced }));
}

/** A page's policy may refuse WebAssembly, and so may a host that has none: TypeScript does the work then. */
function compiled(kind: Parameters<typeof writeProgram>[0]): Machine | null {
  if (!compiles()) return null;
  return new Machine(writeProgram(kind), layoutOf(kind));
}
