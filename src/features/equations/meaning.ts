/** What a symbol of the equations means, in words and with its present value. */
import { coordinateUnit } from '../../core/model/units.ts';
import type { Motion } from '../../app/runs/motion.ts';
import type { SystemView } from '../../core/model/system.ts';
import type { Typeset } from '../../core/model/typeset.ts';
import { equations } from './words.ts';
import { formatQuantity } from '../../ui/kit/format.ts';
import { sample } from '../../ui/slowTime.ts';

const words = equations.meaning;

export interface Meaning {
  what: string;
  /** With its unit; empty where there is none. */
  value: string;
}

const KINDS: Readonly<Record<string, (body: string) => string>> = {
  R: words.attitude,
  r: words.place,
  v: words.velocity,
  omega: words.omega,
  I: words.inertia,
  T: words.kinetic,
  e: words.heading,
  heading: words.heading,
  axle: words.axle,
  up: words.up,
  contact: words.contact,
};

/** Words for a mark such as `alpha_fp_dot`, `casterTrail` or `omega.front-plate`. */
export function meaningOf(
  mark: string,
  view: SystemView,
  typeset: Typeset,
  motion: Motion | null,
  time: number,
): Meaning {
  const { meta } = view;
  const parameter = meta.parameters.find(({ name }) => name === mark);
  if (parameter)
    return {
      what: parameter.label,
      value: formatQuantity(
        motion?.parameters[mark] ?? parameter.default,
        parameter.kind === 'angle' ? '°' : parameter.unit,
      ),
    };
  const derivative = /^(.*?)_(dot|ddot)$/.exec(mark);
  const name = derivative?.[1] ?? mark;
  const coordinate = meta.coordinates.find((c) => c.name === name);
  if (coordinate) {
    const unit = coordinateUnit(coordinate);
    const value = motion && derivative?.[2] !== 'ddot' ? sample(motion.trajectory, mark, time) : null;
    const what =
      derivative === null
        ? coordinate.label
        : derivative[2] === 'dot'
          ? words.rate(coordinate.label)
          : words.acceleration(coordinate.label);
    return { what, value: value === null ? '' : formatQuantity(value, derivative ? `${unit}/s` : unit) };
  }
  const row = /^lambda_(\d+)$/.exec(mark);
  if (row) {
    const title = titleOfRow(typeset, motion?.constraints ?? null, Number(row[1]) - 1);
    const value = motion ? sample(motion.trajectory, mark, time) : null;
    return { what: words.multiplier(title), value: value === null ? '' : formatQuantity(value, 'N') };
  }
  return { what: ofBody(mark, view), value: '' };
}

function ofBody(mark: string, { meta }: SystemView): string {
  const dot = mark.indexOf('.');
  if (dot < 0) return words.abbreviation;
  const [kind, id] = [mark.slice(0, dot), mark.slice(dot + 1)];
  if (kind === 'Q') return words.force(meta.coordinates.find(({ name }) => name === id)?.label ?? id);
  const label = id.startsWith('frame.')
    ? words.frame
    : words.body(meta.bodies.find((body) => body.id === id)?.label ?? id.replaceAll('-', ' '));
  return KINDS[kind]?.(label) ?? words.abbreviation;
}

/** A row's title in words; of the first set where none is in force. */
export function titleOfRow(typeset: Typeset, set: string | null, row: number): string {
  const constraints = typeset.constraints.find(({ id }) => id === set) ?? typeset.constraints[0];
  const title = constraints?.rows[row]?.title ?? '';
  return equations.constraints.titles[title] ?? title;
}
