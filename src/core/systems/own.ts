/** Systems that a person describes: read once for each text, known by an id like the built-in ones from then on. */
import type { Sketch, Value } from '../geometry/drawing.ts';
import type { System, SystemView } from '../model/system.ts';
import type { Model } from '../description/model.ts';
import { descriptionIn, ownId } from '../scenario/own.ts';
import { ScenarioError } from '../scenario/types.ts';

interface Own {
  view: SystemView;
  model: Model;
  system?: Promise<System>;
}

const known = new Map<string, Own>();

/** Views of all systems by id, into which what is learned is put: the registry's. */
type Views = Record<string, SystemView>;

/**
 * Reads a description; afterwards its system is known by the id.
 * @throws ScenarioError with the line and column of the first fault
 */
export async function learn(text: string, views: Views): Promise<SystemView> {
  const id = ownId(text);
  const before = known.get(id);
  if (before?.view.meta.description === text) return before.view;
  const { readSystem } = await import('../description/index.ts');
  const { model, faults, view } = readSystem(text);
  if (!model || !view) throw new ScenarioError('system.description', faults[0]!.message);
  if (before) throw new ScenarioError('system.description', 'another description has the same id; change a comment');
  known.set(id, { view, model });
  views[id] = view;
  return view;
}

/** Reads the description that a raw scenario holds, if it holds one, so that the scenario can be checked. @throws ScenarioError */
export async function learnFrom(raw: unknown, views: Views): Promise<void> {
  const text = descriptionIn(raw);
  if (text !== null) await learn(text, views);
}

/** A system that has been learned, with its equations. @throws ScenarioError with the line of what makes it no system */
export function loadOwn(id: string): Promise<System> | undefined {
  const own = known.get(id);
  if (!own) return undefined;
  return (own.system ??= derived(own));
}

/** How a learned system is drawn, for parameters by name; undefined where there is none of that id. */
export async function drawOwn(id: string): Promise<((value: Value) => Sketch) | undefined> {
  const own = known.get(id);
  if (!own) return undefined;
  const { sketchOf } = await import('../description/index.ts');
  return sketchOf(own.model);
}

async function derived({ model, view }: Own): Promise<System> {
  const { deriveSystem, faultOf } = await import('../description/index.ts');
  try {
    return deriveSystem(model, view);
  } catch (error) {
    const fault = faultOf(error);
    if (fault === null) throw error;
    throw new ScenarioError('system.description', fault);
  }
}
