import { effect, type Signal } from '@preact/signals';
import type { Stage } from './app/stage.ts';
import type { App, Motion } from './app/types.ts';
import type { Cast, Frame, MeshPair } from './scene/contract.ts';
import type { SceneView } from './scene/scene.ts';

/** Which mesh a body wears: both casters wear one. */
const MESH_OF: Readonly<Record<string, string>> = { 'front-caster': 'caster', 'back-caster': 'caster' };
/** Parameters that shape the meshes; when one differs from its default they are made anew instead of loaded. */
const SHAPING = ['rodLength', 'rodRadius', 'plateLength', 'plateWidth', 'plateThickness', 'plateOffset', 'pivotDrop', 'casterAngle', 'casterTrail', 'casterDrop', 'wheelRadius'];

/** Joins the application to the scene: what is on the stage is drawn when it changes, and only then. */
export async function connectScene(canvas: HTMLCanvasElement, app: App, stage: Stage, problem: Signal<string | null>): Promise<void> {
  const { SceneView } = await import('./scene/scene.ts');
  let view: SceneView;
  try {
    view = new SceneView(canvas, {
      theme: app.state.theme.peek(),
      onContextLost: () => void (problem.value = 'The graphics processor gave up the 3-D view; it comes back by itself. Nothing is lost.'),
      onContextRestored: () => void (problem.value = null),
    });
  } catch (error) {
    problem.value = (error as Error).message;
    return;
  }
  (window as unknown as { ripstikScene: SceneView }).ripstikScene = view;
  fitToElement(canvas, view);
  const { state } = app;
  effect(() => view.setTheme(state.theme.value));
  effect(() => view.setSwitches({ trails: state.showTrails.value, forces: state.showForces.value }));
  effect(() => view.setFollow(state.follow.value));
  effect(() => view.setView(state.view.value));
  dress(app, view);
  effect(() => {
    const sampler = stage.sampler.value;
    const motion = state.motion.value;
    if (!sampler || !motion) return;
    const time = state.time.value;
    // A pause at the newest row of a growing run must redraw when rows come.
    void state.rowsVersion.value;
    if (!sampler.sample(time)) return;
    view.setFrame(frameOf(motion, time, sampler, state.showForces.value));
  });
  (window.requestIdleCallback ?? ((then: () => void) => setTimeout(then, 500)))(() => view.improve());
}

function frameOf(motion: Motion, time: number, sampler: NonNullable<Stage['sampler']['value']>, forces: boolean): Frame {
  return {
    time,
    poses: sampler.poses,
    wheelAngles: new Map(motion.system.contacts.map((contact, i) => [contact.body, sampler.wheelAngles[i]!])),
    forces: forces ? sampler.forces(time) : [],
    trails: sampler.tracks(),
  };
}

function fitToElement(canvas: HTMLCanvasElement, view: SceneView): void {
  new ResizeObserver(() => view.resize(canvas.clientWidth, canvas.clientHeight, devicePixelRatio)).observe(canvas);
  view.resize(canvas.clientWidth, canvas.clientHeight, devicePixelRatio);
}

/** Meshes follow the motion's proportions and the person's own files. */
function dress(app: App, view: SceneView): void {
  let wearing = '';
  let turn = 0;
  effect(() => {
    const motion = app.state.motion.value;
    const own = app.state.meshes.value;
    if (!motion) return;
    const key = JSON.stringify([motion.system.meta.id, SHAPING.map((name) => motion.parameters[name]), [...own]]);
    if (key === wearing) return;
    wearing = key;
    const now = ++turn;
    void castOf(motion, own).then(
      (cast) => {
        if (now !== turn) return;
        try {
          view.setCast(cast);
        } catch (error) {
          app.actions.report('error', 'The mesh could not be shown', [(error as Error).message, 'The bodies on the stage are as before.']);
        }
      },
      (error: unknown) => app.actions.report('error', 'The meshes could not be loaded', [String(error)]),
    );
  });
}

async function castOf(motion: Motion, own: ReadonlyMap<string, Partial<MeshPair>>): Promise<Cast> {
  const { meta } = motion.system;
  const isDefault = SHAPING.every((name) => motion.parameters[name] === meta.parameters.find((p) => p.name === name)?.default);
  const names = [...new Set(meta.bodies.map((b) => MESH_OF[b.id] ?? b.id))];
  const pairs = isDefault ? await loadModels(names) : await makeModels(motion.parameters);
  const radius = motion.parameters['wheelRadius'] ?? 0;
  const tilt = motion.parameters['casterAngle'] ?? 0;
  // World up at rest in the caster's frame leads from the skate point to the hub.
  const hub = [-radius * Math.sin(tilt), 0, radius * Math.cos(tilt)] as const;
  return {
    parts: meta.bodies.map(({ id, part }) => ({ id, part })),
    models: meta.bodies.map((b) => {
      const name = MESH_OF[b.id] ?? b.id;
      return { ...pairs.get(name)!, ...own.get(name) };
    }),
    hubs: meta.bodies.map(() => hub),
  };
}

async function loadModels(names: readonly string[]): Promise<Map<string, MeshPair>> {
  const text = async (file: string): Promise<string> => {
    const response = await fetch(`models/${file}`);
    if (!response.ok) throw new Error(`models/${file}: the server answered ${response.status}`);
    return response.text();
  };
  return new Map(await Promise.all(names.map(async (name) => [name, { mdl: await text(`${name}.mdl`), mat: await text(`${name}.mat`) }] as const)));
}

async function makeModels(parameters: Readonly<Record<string, number>>): Promise<Map<string, MeshPair>> {
  const { generateModels } = await import('./core/models/index.ts');
  return new Map(Object.entries(generateModels(parameters)));
}
