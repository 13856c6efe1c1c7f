/** Weights as a person meets them: sets to start from, and what a control that names none means. */
import type { LqrControl, NumberOrExpression } from '../../core/scenario/types.ts';
import type { SystemMeta } from '../../core/model/system.ts';

export interface WeightSet {
  id: 'identity' | 'angles' | 'firm' | 'gentle';
  Q: Record<string, number>;
  R: Record<string, number>;
}

/** Sets that mean something on every system. */
export function weightSets(meta: SystemMeta, inputs: readonly string[]): WeightSet[] {
  const Q = (weight: (kind: 'length' | 'angle', rate: boolean) => number) =>
    Object.fromEntries(
      meta.coordinates.flatMap((c) => [
        [c.name, weight(c.kind, false)],
        [`${c.name}_dot`, weight(c.kind, true)],
      ]),
    );
  const R = (weight: number) => Object.fromEntries(inputs.map((name) => [name, weight]));
  return [
    { id: 'identity', Q: Q(() => 1), R: R(1) },
    { id: 'angles', Q: Q((kind, rate) => (kind === 'angle' && !rate ? 10 : 0)), R: R(1) },
    { id: 'firm', Q: Q((kind, rate) => (kind === 'angle' ? (rate ? 10 : 100) : 1)), R: R(0.1) },
    { id: 'gentle', Q: Q(() => 1), R: R(100) },
  ];
}

/** Every state's weight as it is in force: all 1 where none is named, 0 for those not named where some are. */
export function writtenQ(control: LqrControl, meta: SystemMeta): Record<string, NumberOrExpression> {
  const named = Object.keys(control.Q ?? {}).length > 0;
  return Object.fromEntries(
    meta.coordinates
      .flatMap(({ name }) => [name, `${name}_dot`])
      .map((name) => [name, control.Q?.[name] ?? (named ? 0 : 1)]),
  );
}

/** What an operating point is given by: its speed, and whatever the scenario names besides. */
export function operatingKeys(
  meta: SystemMeta,
  at: Readonly<Record<string, NumberOrExpression>> | undefined,
): string[] {
  const speed = meta.speed?.name ?? `${meta.coordinates[0]!.name}_dot`;
  return [...new Set([speed, ...Object.keys(at ?? {})])];
}

/** What "LQR" begins with: the case's own controller, or the inputs that suit the system, about its start's speed. */
export function firstLqr(
  meta: SystemMeta,
  initial: Readonly<Record<string, NumberOrExpression>> | undefined,
  saved: LqrControl | undefined,
): LqrControl {
  if (saved) return saved;
  const at = Object.fromEntries(
    operatingKeys(meta, undefined).flatMap((name) => (initial?.[name] === undefined ? [] : [[name, initial[name]]])),
  );
  return { type: 'lqr', inputs: [...(meta.regulators ?? meta.inputs.map((i) => i.name))], at };
}
