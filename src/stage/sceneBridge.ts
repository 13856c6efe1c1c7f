import { effect, signal, type Signal } from '@preact/signals';
import { bodyPoint, bodyVelocity, canPush, firmness, springForce } from '../app/push/pointerPush.ts';
import { drawnSettings } from '../app/state/settings.ts';
import { ghostsAt } from '../app/runs/ghosts.ts';
import type { ExportRenderer } from '../app/files/exportRenderer.ts';
import type { Stage } from '../app/runs/stage.ts';
import type { App } from '../app/app.ts';
import { loadDrawing, shapedBy } from '../core/systems/registry.ts';
import { drawnAs, posesFor, withLimbs } from './figure.ts';
import type { Dressed, MeshPair, SceneOptions, SceneView } from '../scene/contract.ts';

/** Joins the application to the scene: what is on the stage is drawn when it changes, and only then. */
export async function connectScene(
  canvas: HTMLCanvasElement,
  app: App,
  stage: Stage,
  problem: Signal<string | null>,
): Promise<void> {
  const { createScene } = await import('../scene/scene.ts');
  const { state, actions, exportService } = app;
  const stillness = matchMedia('(prefers-reduced-motion: reduce)');
  let view: SceneView;
  try {
    view = createScene(canvas, {
      theme: state.theme.peek(),
      reducedMotion: stillness.matches,
      onContextLost: () =>
        void (problem.value = 'The graphics processor gave up the 3-D view; it comes back by itself. Nothing is lost.'),
      onContextRestored: () => void (problem.value = null),
      onScale: (pixels) => actions.setPixelsPerMetre(pixels),
      onCoarse: (coarse) => actions.setCoarse(coarse),
      ...pointerPush(app),
    });
  } catch (error) {
    problem.value = (error as Error).message;
    return;
  }
  (window as unknown as { ripstikScene: SceneView }).ripstikScene = view;
  fitToElement(canvas, view);
  stillness.addEventListener('change', () => view.setReducedMotion(stillness.matches));
  effect(() => view.setTheme(state.theme.value));
  connectSettings(app, view);
  effect(() => view.setFollow(state.follow.value));
  effect(() => view.setView(state.view.value));
  const dressed = dress(app, view);
  const renderer: ExportRenderer = {
    open: async (plan, signal) => (await import('./exportScene.ts')).openShot(app, view, dressed.peek(), plan, signal),
    glb: async (plan, progress) => (await import('./exportScene.ts')).writeGlb(app, dressed.peek(), plan, progress),
  };
  effect(() => exportService.offer(dressed.value.cast ? renderer : null));
  const followed = signal(0);
  let following = false;
  /** Rows that could not be followed at once are in the next frame: one look a frame, however often the time changes. */
  const followOn = (): void => {
    if (following) return;
    following = true;
    requestAnimationFrame(() => {
      following = false;
      followed.value++;
    });
  };
  effect(() => {
    const sampler = stage.sampler.value;
    const motion = state.motion.value;
    // Until the meshes of another system are there, the last picture of the one before stays.
    if (!sampler || !motion || dressed.value.system !== motion.system.meta.id) return;
    const time = state.time.value;
    // A pause at the newest row of a growing run must redraw when rows come.
    void state.rowsVersion.value;
    void followed.value;
    if (!sampler.sample(time)) return;
    if (sampler.behind) followOn();
    view.setTrails(sampler.tracks());
    view.setFrame({
      time,
      poses: posesFor(dressed.value.cast!, motion, sampler.poses),
      wheelAngles: sampler.wheelAngles,
      forces: state.showForces.value ? sampler.forces(time) : [],
    });
    drawPush(app, view, sampler.poses);
  });
  effect(() =>
    view.setGhosts(
      dressed.value.system === state.motion.value?.system.meta.id
        ? withLimbs(ghostsAt(state, stage, state.time.value), dressed.value.cast)
        : [],
    ),
  );
  effect(() => view.setGates(state.gates.value));
  effect(() => {
    void state.push.value;
    const sampler = stage.sampler.peek();
    if (sampler) drawPush(app, view, sampler.poses);
  });
}

function connectSettings({ state }: App, view: SceneView): void {
  effect(() => view.setSwitches(drawnSettings(state)));
  effect(() => view.setQuality(state.quality.value));
  effect(() =>
    view.setHasty(state.run.value?.kind === 'computing' && state.motion.value?.written?.control?.type === 'ride'),
  );
  effect(() => view.setInset(state.insetBox.value));
  effect(() =>
    view.setPushByDrag(!canPush(state.motion.value) ? 'never' : state.dragPushes.value ? 'always' : 'shift'),
  );
}

/** What the pointer does to a body in the scene becomes the state's push. */
function pointerPush({ state, actions }: App): Pick<SceneOptions, 'onPushStart' | 'onPushMove' | 'onPushEnd'> {
  // Between two pictures the pointer goes along with the camera, as it does to the eye.
  const moving = (velocity: readonly [number, number, number]) => ({ velocity, since: state.time.peek() });
  const REST = [0, 0, 0] as const;
  return {
    onPushStart({ body, point, world }) {
      const motion = state.motion.peek();
      const id = motion?.system.meta.bodies[body]?.id;
      if (motion && id !== undefined) {
        const along = state.follow.peek() || state.view.peek() === 'rider';
        actions.setPush({
          body: id,
          point,
          target: world,
          moving: moving(along ? bodyVelocity(motion, state.time.peek(), body) : REST),
          ...firmness(motion),
        });
      }
    },
    onPushMove(target, velocity) {
      const push = state.push.peek();
      if (push) actions.setPush({ ...push, target, moving: moving(velocity) });
    },
    onPushEnd: () => actions.setPush(null),
  };
}

/** The spring from where the pushed point is now to the pointer. */
function drawPush({ state }: App, view: SceneView, poses: Float64Array): void {
  const push = state.push.peek();
  const body = push ? (state.motion.peek()?.system.meta.bodies.findIndex(({ id }) => id === push.body) ?? -1) : -1;
  if (!push || body < 0) return view.setHandle(null);
  const from = bodyPoint(poses, body, push.point);
  const force = springForce(push, from);
  view.setHandle({ from, to: push.target, label: `${force.toFixed(force < 9.95 ? 1 : 0)}\u2009N` });
}

function fitToElement(canvas: HTMLCanvasElement, view: SceneView): void {
  new ResizeObserver(() => view.resize(canvas.clientWidth, canvas.clientHeight, devicePixelRatio)).observe(canvas);
  view.resize(canvas.clientWidth, canvas.clientHeight, devicePixelRatio);
}

/** Resolves once the next frame has been handed over. */
const pictureDrawn = (): Promise<void> =>
  new Promise((done) => {
    requestAnimationFrame(() => setTimeout(done));
    setTimeout(done, 200); // a page that is hidden has no frames
  });

/** Meshes follow the motion's proportions and the person's own files. Says whose are on the stage; a new object with every change. */
function dress(app: App, view: SceneView): Signal<Dressed> {
  const dressed = signal<Dressed>({ system: null, models: {}, cast: null });
  let wearing = '';
  let turn = 0;
  /** The person's files that last fitted; a bad one gives way to them. */
  let good = app.state.meshes.peek();
  effect(() => {
    const motion = app.state.motion.value;
    const own = app.state.meshes.value;
    if (!motion) return;
    const { id } = motion.system.meta;
    const drawn = drawnAs(motion, app.state.showRider.value);
    if (motion.system.meta.bodies.length === 0) {
      // Data: nothing is drawn, and what would come of a motion before does not come.
      wearing = '';
      turn++;
      dressed.value = { system: null, models: {}, cast: null };
      return;
    }
    const shape = shapedBy(id)?.map((name) => motion.parameters[name]) ?? motion.parameters;
    const key = JSON.stringify([id, drawn.id, shape, [...own]]);
    if (key === wearing) return;
    wearing = key;
    const now = ++turn;
    // New proportions follow their first picture: the motion answers at once, and only the last of many edits is drawn anew.
    const ready = dressed.peek().system === id ? pictureDrawn() : Promise.resolve();
    void ready
      .then(() => (now === turn ? loadDrawing(drawn, motion.parameters) : null))
      .then(
        (drawing) => {
          if (now !== turn || !drawing) return;
          const { pairs, bodies, fixtures, stage, limbs } = drawing;
          try {
            const worn = Object.entries(pairs).map(([name, pair]) => [name, { ...pair, ...own.get(`${id}/${name}`) }]);
            const named = bodies.map((body, i) => ({
              ...body,
              figure: i >= motion.system.meta.bodies.length,
              label: body.limb ? '' : (drawn.bodies.find((b) => b.id === body.id)?.label ?? body.id),
            }));
            const [models, cast] = [
              Object.fromEntries(worn) as Record<string, MeshPair>,
              { id: drawn.id, bodies: named, fixtures, stage, ...(limbs ? { limbs } : {}) },
            ];
            view.setModels(models, cast);
            good = own;
            dressed.value = { system: id, models, cast };
          } catch (error) {
            app.actions.setMeshes(good);
            app.actions.report('error', 'The mesh could not be shown', [
              (error as Error).message,
              'The bodies on the stage are as before.',
            ]);
          }
        },
        (error: unknown) => app.actions.report('error', 'The meshes could not be loaded', [String(error)]),
      );
  });
  return dressed;
}
