import type { SystemMeta } from '../systems/types.ts';
import { boardBodies, boardStage } from './board.ts';
import type { Drawing, Model, Sketch, Stage, Value, Wearer } from './drawing.ts';
import { bicycle } from './drawings/bicycle.ts';
import { casterboardRobot } from './drawings/casterboardRobot.ts';
import { casterRotation } from './drawings/casterRotation.ts';
import { chaplyginSleigh } from './drawings/chaplyginSleigh.ts';
import { cartPendulum, wheelPendulum } from './drawings/pendulums.ts';
import { plain } from './drawings/plain.ts';
import { rollingWheel } from './drawings/rollingWheel.ts';
import { stiffDecay } from './drawings/stiffDecay.ts';
import { generateModels } from './index.ts';
import { type Body, writeMaterials, writeMesh } from './wavefront.ts';

/** How each system looks, by its id; one line per system. One without a line is drawn as plain markers. */
const sketches: Readonly<Record<string, (p: Value) => Sketch>> = {
  'stiff-decay': stiffDecay,
  'caster-rotation': casterRotation,
  'cart-pendulum': cartPendulum,
  'rolling-wheel': rollingWheel,
  'wheel-pendulum': wheelPendulum,
  'casterboard-robot': casterboardRobot,
  bicycle,
  'chaplygin-sleigh': chaplyginSleigh,
};

/** Meshes and stage of a system in the proportions of its parameters (SI; missing ones take their defaults). Same parameters, same bytes. */
export function drawingOf(meta: SystemMeta, parameters: Readonly<Record<string, number>>): Drawing {
  if (meta.id === 'ripstik')
    return { pairs: generateModels(parameters), bodies: boardBodies(parameters), fixtures: [], stage: boardStage };
  const value: Value = (name, otherwise = 0) => {
    const given = parameters[name];
    if (given !== undefined && Number.isFinite(given)) return given;
    return meta.parameters.find((p) => p.name === name)?.default ?? otherwise;
  };
  return drawingFrom(meta, (sketches[meta.id] ?? plain(meta.bodies.map((b) => b.id)))(value));
}

function drawingFrom(meta: SystemMeta, sketch: Sketch): Drawing {
  const drawn = { ...sketch.fixtures, ...sketch.bodies };
  const pairs: Record<string, Model> = {};
  for (const [name, { about, parts }] of Object.entries(drawn)) pairs[name] = textOf({ name, about, parts });
  const bodies = meta.bodies.map(({ id, part }): Wearer => ({ id, part, model: id }));
  const undrawn = bodies.find(({ id }) => !sketch.bodies[id]);
  if (undrawn) throw new Error(`the drawing of ${meta.id} has no body ${undrawn.id}`);
  const { subject, ...stage } = sketch.stage ?? {};
  const common: Stage = { subject: 0, facing: 'nose', still: false, floor: 0, closeUp: null };
  return {
    pairs,
    bodies,
    fixtures: Object.keys(sketch.fixtures ?? {}).map((id): Wearer => ({ id, part: 'board', model: id })),
    stage: {
      ...common,
      ...stage,
      subject: Math.max(
        0,
        bodies.findIndex(({ id }) => id === subject),
      ),
    },
  };
}

const textOf = (body: Body): Model => ({ mdl: writeMesh(body), mat: writeMaterials(body) });
