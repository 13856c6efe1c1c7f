/** What can be plotted of a motion: its recorded columns and what follows from them. */
import type { Motion } from '../../app/types.ts';
import { Envelope } from '../../core/motion/envelope.ts';
import type { Trajectory } from '../../core/motion/trajectory.ts';
import { text } from './words.ts';

export interface ColumnInfo {
  name: string;
  label: string;
  /** SI, as recorded; angles are turned into degrees by choice. */
  unit: string;
  angle: boolean;
  part: 'board' | 'front' | 'back' | null;
  group: string;
}

/** Every column of a motion, in groups. */
export function columnsOf({ system, trajectory, constraints }: Motion): ColumnInfo[] {
  const { coordinates, inputs, bodies } = system.meta;
  const known = new Map<string, ColumnInfo>();
  const put = (name: string, info: Omit<ColumnInfo, 'name'>): void => void known.set(name, { name, ...info });
  put('t', { label: text.time, unit: 's', angle: false, part: null, group: text.groups.other });
  for (const c of coordinates) {
    const angle = c.kind === 'angle';
    put(c.name, { label: c.label, unit: angle ? 'rad' : 'm', angle, part: c.part, group: text.groups.coordinates });
    put(`${c.name}_dot`, {
      label: text.rateOf(c.label),
      unit: angle ? 'rad/s' : 'm/s',
      angle,
      part: c.part,
      group: text.groups.rates,
    });
  }
  for (const i of inputs)
    put(i.name, { label: i.label, unit: i.unit, angle: false, part: partOf(i.name), group: text.groups.inputs });
  for (const { part, lateral, vertical } of constraints ? system.contacts : []) {
    put(`lambda_${lateral + 1}`, {
      label: text.force(part, 'lateral'),
      unit: 'N',
      angle: false,
      part,
      group: text.groups.multipliers,
    });
    put(`lambda_${vertical + 1}`, {
      label: text.force(part, 'vertical'),
      unit: 'N',
      angle: false,
      part,
      group: text.groups.multipliers,
    });
  }
  put('energy', { label: text.energy, unit: 'J', angle: false, part: null, group: text.groups.other });
  put('residual', { label: text.residual, unit: '', angle: false, part: null, group: text.groups.other });
  const recorded = trajectory.columns.map(
    (name) =>
      known.get(name) ?? {
        name,
        label: name,
        unit: '',
        angle: false,
        part: null,
        group: name.startsWith('lambda_') ? text.groups.multipliers : text.groups.other,
      },
  );
  const derived = [
    ...(inputs.some((i) => trajectory.has(i.name))
      ? [{ name: 'power', label: text.power, unit: 'W', angle: false, part: null, group: text.groups.derived }]
      : []),
    ...bodies.flatMap((b) =>
      ['x', 'y', 'z'].map((axis) => ({
        name: `${b.id}.${axis}`,
        label: `${b.label}, ${axis}`,
        unit: 'm',
        angle: false,
        part: b.part,
        group: text.groups.derived,
      })),
    ),
  ];
  return [...recorded, ...derived];
}

const partOf = (name: string): ColumnInfo['part'] =>
  /_f[pc]?$/.test(name) ? 'front' : /_b[pc]?$/.test(name) ? 'back' : null;

/** Rows worked out in one go, so that a long motion never stops the page. */
const AT_ONCE = 20_000;

/** Values of one column of a growing motion, made as they are asked for, with their envelope. */
export class Values {
  readonly envelope = new Envelope();
  private readonly trajectory: Trajectory;
  private readonly row: ((row: number) => number) | null;
  private readonly name: string;
  private made = new Float64Array(0);
  private count = 0;
  private generation = 0;

  constructor(motion: Motion, name: string, wrapped: boolean) {
    this.trajectory = motion.trajectory;
    this.name = name;
    this.row = rowFunction(motion, name, wrapped);
  }

  /** Values so far; fewer than there are rows while they are still worked out. */
  get(): Float64Array {
    const { trajectory } = this;
    if (trajectory.generation !== this.generation) {
      this.generation = trajectory.generation;
      this.envelope.clear();
      this.count = 0;
    }
    if (!this.row) return trajectory.column(this.name) ?? new Float64Array(0);
    // The newest row of a thinned motion may still be replaced: it is not kept.
    const rows = Math.min(trajectory.settled, this.count + AT_ONCE);
    if (this.made.length < rows) {
      const grown = new Float64Array(Math.max(rows, 2 * this.made.length, 1024));
      grown.set(this.made.subarray(0, this.count));
      this.made = grown;
    }
    for (; this.count < rows; this.count++) this.made[this.count] = this.row(this.count);
    return this.made.subarray(0, rows);
  }

  /** Rows are missing: look again. */
  get behind(): boolean {
    return this.row !== null && this.count < this.trajectory.settled;
  }
}

/** How a row of a column that is not simply recorded is worked out, or null. */
function rowFunction(
  { system, parameters, trajectory }: Motion,
  name: string,
  wrapped: boolean,
): ((row: number) => number) | null {
  const at = (column: string, row: number): number => trajectory.column(column)?.[row] ?? NaN;
  const { coordinates, inputs, bodies } = system.meta;
  if (trajectory.has(name)) {
    const isAngle = coordinates.some((c) => c.kind === 'angle' && c.name === name);
    return wrapped && isAngle ? (row) => Math.atan2(Math.sin(at(name, row)), Math.cos(at(name, row))) : null;
  }
  if (name === 'power') {
    const terms = inputs
      .filter((i) => trajectory.has(i.name))
      .flatMap((i) =>
        Object.entries(i.column).map(([coordinate, weight]) => ({ input: i.name, rate: `${coordinate}_dot`, weight })),
      );
    return (row) => terms.reduce((sum, { input, rate, weight }) => sum + weight * at(input, row) * at(rate, row), 0);
  }
  const [body, axis = ''] = name.split('.');
  const offset = 12 * bodies.findIndex((b) => b.id === body) + 'xyz'.indexOf(axis);
  if (offset < 0 || axis.length !== 1) return () => NaN;
  const p = Float64Array.from(system.meta.parameters, (m) => parameters[m.name] ?? m.default);
  const poses = new Float64Array(12 * bodies.length);
  const q = new Float64Array(coordinates.length);
  return (row) => {
    for (let i = 0; i < q.length; i++) q[i] = at(coordinates[i]!.name, row);
    system.poses(q, p, poses);
    return poses[offset]!;
  };
}
