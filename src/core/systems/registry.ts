/**
 * Every system there is: one folder and one line in `registered` (with its import). Views, metas and cases come at
 * once; equations, drawings and typeset formulas are loaded one system at a time, for they are large.
 */
import type { Case } from '../cases/case.ts';
import { type Drawing, valueOf } from '../geometry/drawing.ts';
import { LONGEST_FILE } from '../scenario/defaults.ts';
import { descriptionIn } from '../scenario/own.ts';
import type { SystemReading } from '../description/index.ts';
import { defineSystem } from '../model/defineSystem.ts';
import type { System, SystemMeta, SystemView } from '../model/system.ts';
import type { Tape } from '../model/tape.ts';
import type { Typeset } from '../model/typeset.ts';
import { bicycle } from './bicycle/index.ts';
import { bicycleRider } from './bicycle-rider/index.ts';
import { cartPendulum } from './cart-pendulum/index.ts';
import { casterRotation } from './caster-rotation/index.ts';
import { casterboardRobot } from './casterboard-robot/index.ts';
import { chaplyginSleigh } from './chaplygin-sleigh/index.ts';
import type { SystemFolder } from './folder.ts';
import { ripstik } from './ripstik/index.ts';
import { ripstikRider } from './ripstik-rider/index.ts';
import { rollingWheel } from './rolling-wheel/index.ts';
import { stiffDecay } from './stiff-decay/index.ts';
import { wheelPendulum } from './wheel-pendulum/index.ts';

/** In the order of the lists of systems and of cases; the page opens with the first case of the first. */
const registered: readonly SystemFolder[] = [
  ripstik,
  ripstikRider,
  casterRotation,
  cartPendulum,
  rollingWheel,
  stiffDecay,
  wheelPendulum,
  casterboardRobot,
  bicycle,
  bicycleRider,
  chaplyginSleigh,
];

const folders: ReadonlyMap<string, SystemFolder> = new Map(registered.map((folder) => [folder.view.meta.id, folder]));

export const systemIds: readonly string[] = [...folders.keys()];

/** Every system as the views know it, by id; what is learned from a description is put here too. */
export const systemViews: Record<string, SystemView> = Object.fromEntries(
  registered.map(({ view }) => [view.meta.id, view]),
);

/** Their metas alone, as scenarios are checked against; always those of `systemViews`. */
export const systemMetas: Readonly<Record<string, SystemMeta>> = new Proxy({} as Record<string, SystemMeta>, {
  get: (_, id) => (Object.hasOwn(systemViews, id) ? systemViews[id as string]!.meta : undefined),
  has: (_, id) => Object.hasOwn(systemViews, id),
  ownKeys: () => Object.keys(systemViews),
  getOwnPropertyDescriptor: (_, id) =>
    Object.hasOwn(systemViews, id)
      ? { value: systemViews[id as string]!.meta, enumerable: true, configurable: true }
      : undefined,
});

/** What reads descriptions comes with the first of them. */
const own = () => import('./own.ts');
const isDescribed = (id: string): boolean =>
  Object.hasOwn(systemViews, id) && systemViews[id]!.meta.description !== undefined;

/**
 * Reads a description, whose system is known by its id from then on.
 *
 * @param text of the description
 * @param reading of the same text, where whoever asks has read it already
 * @throws ScenarioError
 */
export const learnSystem = (text: string, reading?: SystemReading): Promise<SystemView> =>
  own().then(({ learn }) => learn(text, systemViews, reading));

/**
 * The same for the description that a raw scenario holds, if it does: before it is checked.
 *
 * @param raw JSON as parsed
 * @throws ScenarioError
 */
export async function learnSystemOf(raw: unknown): Promise<void> {
  if (descriptionIn(raw) !== null) await (await own()).learnFrom(raw, systemViews);
}

/**
 * The same for the text of a scenario's file, whatever else is wrong with it.
 *
 * @param text of the file
 * @throws ScenarioError
 */
export async function learnSystemIn(text: string): Promise<void> {
  if (text.length > LONGEST_FILE || !text.includes('"description"')) return;
  let raw: unknown;
  try {
    raw = JSON.parse(text.replace(/^\ufeff/, ''));
  } catch {
    // Its fault is told when it is read as a scenario.
    return;
  }
  await learnSystemOf(raw);
}

/** Every built-in case. The first one is what the page opens with. */
export const cases: readonly Case[] = registered.flatMap((folder) => folder.cases);

/** What of a system's equations is loaded. */
export interface SystemParts {
  /** Left out, whatever asks for a Jacobian throws: explicit methods without a regulator or a push need none. */
  jacobians?: boolean;
  /** The accelerations as data, for WebAssembly. */
  tape?: boolean;
  /** Told of every part of a derivation, where a described system is derived for the first time. */
  derived?: (done: number, of: number) => void;
}

/** Systems that were asked for, by id and parts: a sweep asks for the same one a thousand times. */
const loaded = new Map<string, Promise<System>>();

/**
 * A system with its dynamics, made once.
 *
 * @param id of the system
 * @param parts everything, where not said
 * @returns undefined where there is none of that name
 */
export function loadSystem(id: string, parts: SystemParts = {}): Promise<System> | undefined {
  const folder = folders.get(id);
  if (!folder)
    return isDescribed(id) ? own().then(({ loadOwn }) => loadOwn(id, systemViews, parts.derived)!) : undefined;
  const { jacobians = true, tape = true } = parts;
  const key = `${id} ${jacobians} ${tape}`;
  const known = loaded.get(key);
  if (known) return known;
  const system = systemIn(folder, jacobians, tape);
  loaded.set(key, system);
  // What could not be fetched is asked for again.
  system.catch(() => loaded.delete(key));
  return system;
}

async function systemIn(folder: SystemFolder, jacobians: boolean, tape: boolean): Promise<System> {
  const [values, slopes, data] = await Promise.all([
    folder.equations(),
    jacobians ? folder.jacobians() : undefined,
    tape ? folder.tape?.() : undefined,
  ]);
  return defineSystem(folder.view, values, slopes, data?.default as Tape | undefined);
}

/**
 * A system's equations as marked LaTeX.
 *
 * @param id of the system
 * @returns undefined where there is none of that name
 */
export function loadTypeset(id: string): Promise<Typeset> | undefined {
  const folder = folders.get(id);
  if (folder) return folder.typeset().then((module) => module.default as Typeset);
  return isDescribed(id) ? own().then(({ typesetOwn }) => typesetOwn(id, systemViews)!) : undefined;
}

/**
 * Meshes and stage of a system in the proportions of its parameters; one without a drawing is drawn as plain markers.
 *
 * @param meta of the system
 * @param parameters by name, SI; those that are missing or no numbers take their defaults. Same parameters, same bytes
 */
export async function loadDrawing(meta: SystemMeta, parameters: Readonly<Record<string, number>>): Promise<Drawing> {
  const [{ drawingFrom }, drawn] = await Promise.all([
    import('../geometry/drawings.ts'),
    folders.get(meta.id)?.drawing?.() ?? drawnOwn(meta.id),
  ]);
  return drawingFrom(meta, drawn?.draw(valueOf(meta, parameters)));
}

async function drawnOwn(id: string) {
  if (!isDescribed(id)) return undefined;
  const draw = await (await own()).drawOwn(id, systemViews);
  return draw && { draw };
}

/** Parameters that shape a system's meshes; undefined where any of them may. */
export const shapedBy = (id: string): SystemFolder['shapedBy'] => folders.get(id)?.shapedBy;
