/** Systems that a person describes: read once for each text, known by an id like the built-in ones from then on. */
import type { Sketch, Value } from '../geometry/drawing.ts';
import type { System, SystemView } from '../model/system.ts';
import type { Typeset } from '../model/typeset.ts';
import type { SystemReading } from '../description/index.ts';
import type { Model } from '../description/model.ts';
import { descriptionIn, ownId } from '../scenario/own.ts';
import { ScenarioError } from '../scenario/types.ts';

/** Views of all systems by id, into which what is learned is put: the registry's. */
type Views = Record<string, SystemView>;

interface Own {
  model: Model;
  view: SystemView;
  system?: Promise<System>;
}

/**
 * Models at hand, the newest last: a person who types makes one with every key, and each holds its whole graph. An older one is
 * read anew from the description in its view, which stays.
 */
const known = new Map<string, Own>();
const MOST_KNOWN = 6;

function keep(id: string, own: Own): Own {
  known.delete(id);
  known.set(id, own);
  for (const oldest of known.keys()) if (known.size > MOST_KNOWN) known.delete(oldest);
  return own;
}

/**
 * Reads a description; afterwards its system is known by the id.
 *
 * @param text of the description
 * @param views what is known of systems, by id
 * @param reading of the same text, where whoever asks has read it already
 * @throws ScenarioError with the line and column of the first fault
 */
export async function learn(text: string, views: Views, reading?: SystemReading): Promise<SystemView> {
  const id = ownId(text);
  const before = views[id];
  if (before?.meta.description === text) return before;
  if (before) throw new ScenarioError('system.description', 'another description has the same id; change a comment');
  return (views[id] = keep(id, reading ? ownIn(reading) : await readAnew(text)).view);
}

async function readAnew(text: string): Promise<Own> {
  const { readSystem } = await import('../description/index.ts');
  return ownIn(readSystem(text));
}

function ownIn({ model, faults, view }: SystemReading): Own {
  if (!model || !view) throw new ScenarioError('system.description', faults[0]!.message);
  return { model, view };
}

/** What was learned under an id; undefined where nothing was. */
function ownOf(id: string, views: Views): Promise<Own> | undefined {
  const own = known.get(id);
  if (own) return Promise.resolve(keep(id, own));
  const text = Object.hasOwn(views, id) ? views[id]!.meta.description : undefined;
  return text === undefined ? undefined : readAnew(text).then((again) => keep(id, known.get(id) ?? again));
}

/**
 * Reads the description that a raw scenario holds, if it holds one, so that the scenario can be checked.
 *
 * @param raw JSON as parsed
 * @param views what is known of systems, by id
 * @throws ScenarioError
 */
export async function learnFrom(raw: unknown, views: Views): Promise<void> {
  const text = descriptionIn(raw);
  if (text !== null) await learn(text, views);
}

/**
 * A system that has been learned, with its equations.
 *
 * @param id of the system
 * @param views what is known of systems, by id
 * @param step told of every part of the derivation, where it has not been derived yet
 * @throws ScenarioError with the line of what makes it no system
 */
export function loadOwn(
  id: string,
  views: Views,
  step?: (done: number, of: number) => void,
): Promise<System> | undefined {
  return ownOf(id, views)?.then((own) => (own.system ??= derived(own, step)));
}

/**
 * How a learned system is drawn, for parameters by name; undefined where there is none of that id.
 *
 * @param id of the system
 * @param views what is known of systems, by id
 */
export async function drawOwn(id: string, views: Views): Promise<((value: Value) => Sketch) | undefined> {
  const own = await ownOf(id, views);
  if (!own) return undefined;
  const { sketchOf } = await import('../description/index.ts');
  return sketchOf(own.model);
}

/**
 * The equations of a learned system as marked LaTeX; undefined where there is none of that id. Its own graph is left as it is.
 *
 * @param id of the system
 * @param views what is known of systems, by id
 */
export function typesetOwn(id: string, views: Views): Promise<Typeset> | undefined {
  const text = Object.hasOwn(views, id) ? views[id]!.meta.description : undefined;
  if (text === undefined) return undefined;
  return Promise.all([readAnew(text), import('../description/typeset.ts')]).then(([{ model }, { typesetOf }]) =>
    typesetOf(model, id),
  );
}

async function derived({ model, view }: Own, step?: (done: number, of: number) => void): Promise<System> {
  const { deriveSystem, faultOf } = await import('../description/index.ts');
  try {
    return deriveSystem(model, view, step ? { step } : {});
  } catch (error) {
    const fault = faultOf(error);
    if (fault === null) throw error;
    throw new ScenarioError('system.description', fault);
  }
}
