/** Pictures and 3-D files of the motion being watched, made beside the page's own view, which never notices. */
import { posesFor, withLimbs } from './figure.ts';
import { untracked } from '@preact/signals';
import { drawnSettings } from '../app/state/settings.ts';
import { keyTimes } from '../app/files/exportPlan.ts';
import { legendBar } from '../app/state/forceScale.ts';
import { ghostsAt, type GhostPoses } from '../app/runs/ghosts.ts';
import { Pace } from './pace.ts';
import type { GlbPlan, Shot, ShotPlan, ExportProgress } from '../app/files/exportRenderer.ts';
import type { App } from '../app/app.ts';
import type { Motion } from '../app/runs/motion.ts';
import { MotionSampler } from '../core/motion/motionSampler.ts';
import { openCapture } from '../scene/export/capture.ts';
import type { Dressed, SceneView } from '../scene/contract.ts';

function watched(app: App, dressed: Dressed): Motion {
  const motion = app.state.motion.peek();
  if (!motion || motion.trajectory.length === 0 || dressed.system !== motion.system.meta.id)
    throw new Error('There is no motion on the stage.');
  return motion;
}

const samplerOf = (motion: Motion): MotionSampler =>
  new MotionSampler(motion.system, motion.parameters, motion.trajectory, motion.constraints);

/** Pinned runs stand in the picture as they do on the page; their samplers are the picture's own. */
async function ghostPoses({ state }: App, pace: Pace): Promise<(time: number) => readonly GhostPoses[]> {
  const samplers = new Map<Motion, MotionSampler>();
  for (const { motion, ghost } of state.pinned.peek()) {
    if (!ghost) continue;
    samplers.set(motion, samplerOf(motion));
    await caughtUp(samplers.get(motion)!, motion.trajectory.start, pace);
  }
  return (time) => ghostsAt(state, { samplerOf: (motion) => samplers.get(motion) ?? samplerOf(motion) }, time);
}

/** Paths and rolled wheels over all rows there are: a sampler follows a long run in parts. */
async function caughtUp(sampler: MotionSampler, time: number, pace: Pace): Promise<void> {
  while (sampler.behind && sampler.sample(time)) if (pace.over) await pace.breathe();
}

export async function openShot(
  app: App,
  page: SceneView,
  dressed: Dressed,
  plan: ShotPlan,
  signal?: AbortSignal,
): Promise<Shot> {
  const { state } = app;
  const motion = watched(app, dressed);
  const sampler = samplerOf(motion);
  const pace = new Pace(signal);
  await caughtUp(sampler, plan.from, pace);
  const ghosts = await ghostPoses(app, pace);
  const switches = untracked(() => drawnSettings(state));
  const { forces, metresPerNewton: perNewton } = switches;
  const capture = await openCapture({
    ...plan,
    theme: state.theme.peek(),
    closeUp: state.showInset.peek() && dressed.cast!.stage.closeUp !== null ? plan.closeUpTitle : null,
    legend: forces && motion.system.contacts.length > 0 ? (pixels) => legendOf(perNewton, pixels) : null,
  });
  const { view } = capture;
  let last = Number.NaN;
  const put = (time: number): void => {
    if (time === last) return;
    last = time;
    sampler.sample(time);
    view.setTrails(sampler.tracks());
    view.setFrame({
      time,
      poses: posesFor(dressed.cast!, motion, sampler.poses),
      wheelAngles: sampler.wheelAngles,
      forces: forces ? sampler.forces(time) : [],
    });
    view.setGhosts(withLimbs(ghosts(time), dressed.cast));
  };
  try {
    view.setModels(dressed.models, dressed.cast!);
    view.setSwitches(switches);
    view.setFollow(plan.follow);
    const asOnPage = plan.view === 'page';
    view.setView(asOnPage ? state.view.peek() : (plan.view as Exclude<typeof plan.view, 'page'>));
    put(asOnPage ? state.time.peek() : plan.from);
    if (asOnPage) view.setPlacement(page.placement());
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

function legendOf(metresPerNewton: number, pixelsPerMetre: number): { pixels: number; label: string } | null {
  const bar = legendBar(metresPerNewton, pixelsPerMetre);
  return bar && { pixels: bar.pixels, label: `${bar.newtons}\u2009N` };
}

export async function writeGlb(
  app: App,
  dressed: Dressed,
  plan: GlbPlan,
  { signal, onKey }: ExportProgress,
): Promise<Blob> {
  const motion = watched(app, dressed);
  const { glbOf } = await import('../scene/export/gltf.ts');
  const pace = new Pace(signal);
  const sampler = samplerOf(motion);
  await caughtUp(sampler, plan.from, pace);
  const times = keyTimes(motion.trajectory.column('t')!, plan);
  return glbOf({
    title: motion.title,
    models: dressed.models,
    cast: dressed.cast!,
    theme: app.state.theme.peek(),
    times,
    generator: plan.generator,
    extras: {
      title: motion.title,
      system: motion.system.meta.id,
      start: times[0] ?? 0,
      parameters: motion.parameters,
      scenario: motion.written ?? motion.scenario,
    },
    at(time) {
      sampler.sample(time);
      return { poses: posesFor(dressed.cast!, motion, sampler.poses), wheelAngles: sampler.wheelAngles };
    },
    pause(keys) {
      if (!pace.over) return null;
      onKey(keys);
      return pace.breathe();
    },
  });
}
