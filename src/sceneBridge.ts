import { effect, type Signal } from '@preact/signals';
import type { Stage } from './app/stage.ts';
import type { App, Motion } from './app/types.ts';
import type { BodyModel, CasterGeometry, MeshPair, SceneView } from './scene/contract.ts';

/** Which mesh a body wears: both casters wear one. */
const MESH_OF: Readonly<Record<string, string>> = { 'front-caster': 'caster', 'back-caster': 'caster' };
/** Parameters that shape the meshes; when one differs from its default they are made anew instead of loaded. */
const SHAPING = ['rodLength', 'rodRadius', 'plateLength', 'plateWidth', 'plateThickness', 'plateOffset', 'pivotDrop', 'casterAngle', 'casterTrail', 'casterDrop', 'wheelRadius'];

/** Joins the application to the scene: what is on the stage is drawn when it changes, and only then. */
export async function connectScene(canvas: HTMLCanvasElement, app: App, stage: Stage, problem: Signal<string | null>): Promise<void> {
  const { createScene } = await import('./scene/scene.ts');
  const { state } = app;
  const stillness = matchMedia('(prefers-reduced-motion: reduce)');
  let view: SceneView;
  try {
    view = createScene(canvas, {
      theme: state.theme.peek(),
      reducedMotion: stillness.matches,
      onContextLost: () => void (problem.value = 'The graphics processor gave up the 3-D view; it comes back by itself. Nothing is lost.'),
      onContextRestored: () => void (problem.value = null),
    });
  } catch (error) {
    problem.value = (error as Error).message;
    return;
  }
  (window as unknown as { ripstikScene: SceneView }).ripstikScene = view;
  fitToElement(canvas, view);
  stillness.addEventListener('change', () => view.setReducedMotion(stillness.matches));
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
    view.setTrails(sampler.tracks());
    view.setFrame({ time, poses: sampler.poses, wheelAngles: sampler.wheelAngles, forces: state.showForces.value ? sampler.forces(time) : [] });
  });
}

function fitToElement(canvas: HTMLCanvasElement, view: SceneView): void {
  new ResizeObserver(() => view.resize(canvas.clientWidth, canvas.clientHeight, devicePixelRatio)).observe(canvas);
  view.resize(canvas.clientWidth, canvas.clientHeight, devicePixelRatio);
}

/** Meshes follow the motion's proportions and the person's own files. */
function dress(app: App, view: SceneView): void {
  let wearing = '';
  let turn = 0;
  /** The person's files that last fitted; a bad one gives way to them. */
  let good = app.state.meshes.peek();
  effect(() => {
    const motion = app.state.motion.value;
    const own = app.state.meshes.value;
    if (!motion) return;
    const key = JSON.stringify([motion.system.meta.id, SHAPING.map((name) => motion.parameters[name]), [...own]]);
    if (key === wearing) return;
    wearing = key;
    const now = ++turn;
    void pairsOf(motion, own).then(
      (pairs) => {
        if (now !== turn) return;
        try {
          view.setModels(pairs, geometryOf(motion), bodiesOf(motion));
          good = own;
        } catch (error) {
          app.state.meshes.value = good;
          app.actions.report('error', 'The mesh could not be shown', [(error as Error).message, 'The bodies on the stage are as before.']);
        }
      },
      (error: unknown) => app.actions.report('error', 'The meshes could not be loaded', [String(error)]),
    );
  });
}

const bodiesOf = (motion: Motion): BodyModel[] => motion.system.meta.bodies.map(({ id, part }) => ({ id, part, model: MESH_OF[id] ?? id }));

function geometryOf({ parameters }: Motion): CasterGeometry {
  const of = (name: string): number => parameters[name] ?? 0;
  return { casterAngle: of('casterAngle'), wheelRadius: of('wheelRadius'), casterTrail: of('casterTrail'), casterDrop: of('casterDrop') };
}

/** The mesh pairs by name: the shipped files for the default proportions, made anew for others, and the person's own on top. */
async function pairsOf(motion: Motion, own: ReadonlyMap<string, Partial<MeshPair>>): Promise<Record<string, MeshPair>> {
  const { meta } = motion.system;
  const isDefault = SHAPING.every((name) => motion.parameters[name] === meta.parameters.find((p) => p.name === name)?.default);
  const names = [...new Set(bodiesOf(motion).map((b) => b.model))];
  const pairs = isDefault ? await loadModels(names) : await makeModels(motion.parameters);
  return Object.fromEntries(names.map((name) => [name, { ...pairs.get(name)!, ...own.get(name) }]));
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
