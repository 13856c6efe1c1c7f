/** Pictures and 3-D files of the motion being watched, made beside the page's own view, which never notices. */
import type { GlbPlan, Shot, ShotPlan } from './app/studio.ts';
import type { App, Motion } from './app/types.ts';
import { MotionSampler } from './core/trajectory/motionSampler.ts';
import { openCapture } from './scene/capture.ts';
import type { Dressed, SceneView } from './scene/contract.ts';

function watched(app: App, dressed: Dressed): Motion {
  const motion = app.state.motion.peek();
  if (!motion || motion.trajectory.length === 0 || dressed.system !== motion.system.meta.id) throw new Error('There is no motion on the stage.');
  return motion;
}

const samplerOf = (motion: Motion): MotionSampler => new MotionSampler(motion.system, motion.parameters, motion.trajectory, motion.constraints);

export function openShot(app: App, page: SceneView, dressed: Dressed, plan: ShotPlan): Shot {
  const { state } = app;
  const sampler = samplerOf(watched(app, dressed));
  const forces = state.showForces.peek();
  const capture = openCapture({ ...plan, theme: state.theme.peek() });
  const { view } = capture;
  const put = (time: number): void => {
    sampler.sample(time);
    view.setTrails(sampler.tracks());
    view.setFrame({ time, poses: sampler.poses, wheelAngles: sampler.wheelAngles, forces: forces ? sampler.forces(time) : [] });
  };
  try {
    view.setModels(dressed.models, dressed.cast!);
    view.setSwitches({ trails: state.showTrails.peek(), forces });
    view.setFollow(plan.follow);
    const asOnPage = plan.view === 'page';
    view.setView(asOnPage ? state.view.peek() : (plan.view as Exclude<typeof plan.view, 'page'>));
    put(asOnPage ? state.time.peek() : plan.from);
    if (asOnPage) {
      const { camera, target } = page.placement();
      view.setPlacement(camera, target);
    }
  } catch (error) {
    capture.dispose();
    throw error;
  }
  return {
    canvas: capture.canvas,
    draw(time, caption) {
      put(time);
      capture.draw(caption);
    },
    dispose: () => capture.dispose(),
  };
}

/** Keyframe times (s): the run's rows within the range, or so many a second. */
function keyTimes(motion: Motion, { from, to, rate }: GlbPlan): Float64Array {
  const rows = motion.trajectory.column('t')!;
  if (rate === null) return rows.filter((t, i) => t >= from && t <= to && (i === 0 || t > rows[i - 1]!));
  return Float64Array.from({ length: Math.max(1, Math.floor((to - from) * rate + 1e-9) + 1) }, (_, k) => from + k / rate);
}

export async function writeGlb(app: App, dressed: Dressed, plan: GlbPlan): Promise<Uint8Array<ArrayBuffer>> {
  const motion = watched(app, dressed);
  const { glbOf } = await import('./scene/gltf.ts');
  const sampler = samplerOf(motion);
  const times = keyTimes(motion, plan);
  const width = sampler.poses.length;
  const wheels = sampler.wheelAngles.length;
  const poses = new Float64Array(width * times.length);
  const wheelAngles = new Float64Array(wheels * times.length);
  times.forEach((t, k) => {
    sampler.sample(t);
    poses.set(sampler.poses, width * k);
    wheelAngles.set(sampler.wheelAngles, wheels * k);
  });
  return glbOf({
    title: motion.title, models: dressed.models, cast: dressed.cast!, theme: app.state.theme.peek(), times, poses, wheelAngles, wheels,
    generator: plan.generator,
    extras: { title: motion.title, system: motion.system.meta.id, start: times[0] ?? 0, parameters: motion.parameters, scenario: motion.written ?? motion.scenario },
  });
}
