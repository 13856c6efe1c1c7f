import { dependentWords, type System } from '../model/system.ts';
import type { ConstrainedSystem } from './constrainedSystem.ts';

/** A function of the state whose downward crossing of zero ends the run. */
export interface EventFunction {
  id: string;
  /** Evaluated at a state; positive before the event. */
  value(t: number, q: Float64Array, v: Float64Array): number;
  message(t: number): string;
  /** Looked for anywhere within a step, however often it crosses; of another, too dear for that, the steps' ends tell. */
  readonly smooth: boolean;
}

/** The scaled constraints count as dependent when their smallest eigenvalue is this small. */
const SINGULAR_BELOW = 1e-6;

/**
 * The events of a run: under contact constraint sets only, and only those not ignored.
 *
 * @param system that the run is of
 * @param dynamics with the constraint set and parameters of the run
 * @param actions what to do at an event, by its id
 */
export function eventsOf(
  system: System,
  dynamics: ConstrainedSystem,
  actions: Readonly<Record<string, 'stop' | 'ignore'>>,
): EventFunction[] {
  const list: EventFunction[] = [];
  for (const { id, label, sets, value } of system.crossings ?? []) {
    const here = sets.length === 0 || sets.includes(dynamics.constraints?.id ?? 'none');
    if (!here || actions[id] === 'ignore') continue;
    list.push({
      id,
      smooth: true,
      value: (_t, q, v) => value(q, v, dynamics.parameters),
      message: (t) => `${id}: ${label} at t = ${t.toFixed(3)} s`,
    });
  }
  if (!dynamics.constraints?.contact) return list;
  if (system.clearance && actions['touchdown'] !== 'ignore') {
    const clearance = system.clearance;
    list.push({
      id: 'touchdown',
      smooth: true,
      value: (_t, q) => clearance(q, dynamics.parameters),
      message: (t) =>
        `touchdown: ${system.meta.touchdown?.label ?? 'a part'} reached the ground at t = ${t.toFixed(3)} s`,
    });
  }
  if (actions['constraint-singular'] !== 'ignore') {
    list.push({
      id: 'constraint-singular',
      smooth: false,
      value: (t, q, v) => {
        // Only the sign counts; the eigenvalue itself is needed near zero alone.
        const bound = dynamics.independenceBoundAt(t, q, v);
        if (bound > SINGULAR_BELOW) return bound - SINGULAR_BELOW;
        dynamics.prepare(t, q, v);
        return dynamics.independence(t, q, v) - SINGULAR_BELOW;
      },
      message: (t) =>
        `constraint-singular: the constraints became dependent at t = ${t.toFixed(3)} s${dependentWords(system.meta, dynamics.constraints?.id)}`,
    });
  }
  return list;
}
