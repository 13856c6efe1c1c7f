/** From a system to the next one that is typed: what of an experiment still has a meaning. */
import type { SystemMeta } from '../../core/model/system.ts';
import { checkScenario } from '../../core/scenario/schema.ts';
import { ScenarioError, type ScenarioFile } from '../../core/scenario/types.ts';

const only = <T>(record: Readonly<Record<string, T>> | undefined, names: ReadonlySet<string>) => {
  const kept = Object.entries(record ?? {}).filter(([name]) => names.has(name));
  return kept.length > 0 ? Object.fromEntries(kept) : undefined;
};

/**
 * An experiment on another system: values of names that it still has stay, and so do time and method. What its check refuses is
 * left out, the controller first.
 *
 * @param meta of the system
 */
export function carriedOver(draft: ScenarioFile, meta: SystemMeta): ScenarioFile {
  const coordinates = new Set(meta.coordinates.map(({ name }) => name));
  const rates = [...coordinates].map((name) => `${name}_dot`);
  const states = new Set([...coordinates, ...rates, ...(meta.speed ? [meta.speed.name] : [])]);
  const { version, duration, outputStep, method, columns } = draft;
  const hold = draft.hold?.filter((name) => coordinates.has(name));
  const released = draft.release?.filter((name) => meta.held?.includes(name));
  const constraints = meta.constraintSets.some(({ id }) => id === draft.constraints) ? draft.constraints : undefined;
  const parts = {
    initial: only(draft.initial, states),
    parameters: only(draft.parameters, new Set(meta.parameters.map(({ name }) => name))),
    inputs: only(draft.inputs, new Set(meta.inputs.map(({ name }) => name))),
    hold: hold && hold.length > 0 ? hold : undefined,
    release: released && released.length > 0 ? released : undefined,
    constraints,
    control: draft.control,
    at: only(draft.at, states),
    events: only(draft.events, new Set(meta.events?.map(({ id }) => id))),
    parameterSet: Object.hasOwn(meta.parameterSets, draft.parameterSet ?? '') ? draft.parameterSet : undefined,
    columns,
    duration,
    outputStep,
    method,
  };
  const without = (...left: (keyof ScenarioFile)[]): ScenarioFile => ({
    version,
    system: meta.id,
    ...Object.fromEntries(
      Object.entries(parts).filter(([key, value]) => value !== undefined && !left.includes(key as keyof ScenarioFile)),
    ),
  });
  const tries = [
    without(),
    without('control'),
    without('control', 'at', 'inputs', 'hold', 'release', 'constraints'),
    without('control', 'at', 'inputs', 'hold', 'release', 'constraints', 'initial', 'parameters', 'events'),
  ];
  return tries.find((file) => isFine(file, meta)) ?? { version, system: meta.id };
}

function isFine(file: ScenarioFile, meta: SystemMeta): boolean {
  try {
    checkScenario(file, { [meta.id]: meta });
    return true;
  } catch (error) {
    if (error instanceof ScenarioError) return false;
    throw error;
  }
}
