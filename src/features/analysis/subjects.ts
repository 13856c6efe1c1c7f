/** What a root locus can be drawn against, and the range that is offered. */
import type { LocusRequest } from '../../core/control/locus/scenarioLocus.ts';
import type { SystemView } from '../../core/model/system.ts';
import type { Scenario, ScenarioFile } from '../../core/scenario/types.ts';
import type { Column } from '../../core/motion/columns.ts';

export interface LocusSubject {
  id: string;
  vary: LocusRequest['vary'];
  name: string;
  label: string;
  symbol: string;
  /** A dot stands above it. */
  rate: boolean;
  /** As it is shown, and how many of it are one SI unit. */
  unit: string;
  factor: number;
  angle: boolean;
  least: number;
  most: number;
}

const DEGREES = 180 / Math.PI;

/** The speed first, then the other rates, then every parameter. */
export function subjectsOf(
  { meta }: Pick<SystemView, 'meta'>,
  names: ReadonlyMap<string, Column>,
  speedWord: string,
): LocusSubject[] {
  const aliases = meta.speed ? [point(meta.speed.name, speedWord, 'v', 'm/s', false, false)] : [];
  const rates = [...names.values()]
    .filter((s) => s.rate || meta.order === 1)
    .map((s) => point(s.name, s.label, s.symbol, s.unit, s.degrees, s.rate));
  const parameters = meta.parameters.map((p): LocusSubject => ({
    id: `parameter.${p.name}`,
    vary: 'parameter',
    name: p.name,
    label: p.label,
    symbol: p.symbol,
    rate: false,
    ...shown(p.unit, p.kind === 'angle'),
    least: p.min ?? (p.positive ? Number.MIN_VALUE : -Infinity),
    most: p.max ?? Infinity,
  }));
  return [...aliases, ...rates, ...parameters];
}

function point(name: string, label: string, symbol: string, unit: string, angle: boolean, rate: boolean): LocusSubject {
  return {
    id: `at.${name}`,
    vary: 'at',
    name,
    label,
    symbol,
    rate,
    ...shown(unit, angle),
    least: -Infinity,
    most: Infinity,
  };
}

const shown = (unit: string, angle: boolean) => ({
  unit: angle ? unit.replace('rad', '°') : unit,
  factor: angle ? DEGREES : 1,
  angle,
});

/** A range to begin with, SI: a walk to a fast ride for speeds, around its value for a parameter. */
export function offeredRange(
  { vary, name, angle, least, most }: LocusSubject,
  value: number,
): { from: number; to: number } {
  if (vary === 'at') return { from: 0, to: name === 'speed' ? 10 : 5 };
  const reach = Math.abs(value) || (angle ? 0.5 : 1);
  const from = Math.max(value > 0 ? value - 0.9 * reach : value - reach, least);
  return { from: tidy(from), to: tidy(Math.min(value + reach, most)) };
}

/** Values in force, so that a range can be offered around them. */
export function parametersOf(draft: ScenarioFile, { meta }: SystemView): Scenario['parameters'] {
  const set = draft.parameterSet === undefined ? {} : meta.parameterSets[draft.parameterSet];
  const named = Object.fromEntries(
    Object.entries(draft.parameters ?? {}).filter(([, value]) => typeof value === 'number'),
  ) as Record<string, number>;
  return { ...Object.fromEntries(meta.parameters.map((p) => [p.name, p.default])), ...set, ...named };
}

const tidy = (x: number): number => Number(x.toPrecision(6));
