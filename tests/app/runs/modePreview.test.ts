// A mode takes the stage for a while; what it suspends comes back as it was.
import { expect, test } from 'vitest';
import type { ModeRequest } from '../../../src/app/runs/modePreview.ts';
import { UNRECORDED } from '../../../src/app/runs/motion.ts';
import { speedFor } from '../../../src/app/runs/modePreview.ts';
import { speeds } from '../../../src/app/state/playbackClock.ts';
import { modeMotion } from '../../../src/core/control/linearization/modeTrajectory.ts';
import { Trajectory } from '../../../src/core/motion/trajectory.ts';
import { appOf } from '../appOf.ts';

const request: ModeRequest = {
  scenario: { version: 1, system: 'stiff-decay' },
  title: 'a mode',
  mode: {
    states: ['y', 'y_dot'],
    A: [
      [0, 1],
      [-4, 0],
    ],
    eigenvalue: [0, 2],
    shape: [1, 0],
    q: [0],
    v: [0],
  },
  motionOf: modeMotion,
};

function playing() {
  const app = appOf();
  const system = app.systemOf('stiff-decay')!;
  app.actions.showMotion({
    source: 'file',
    title: 'a file',
    system,
    parameters: {},
    trajectory: Trajectory.of(['t', 'y'], [Float64Array.of(0, 1, 2), Float64Array.of(1, 2, 3)]),
    ...UNRECORDED,
  });
  app.actions.seek(1);
  app.actions.setAll({ speed: 0.25, loop: false });
  return app;
}

test('what stood on the stage comes back, with its time, speed and loop', () => {
  const app = playing();
  const before = app.state.motion.value!;
  app.actions.showMode(request, true);
  const preview = app.state.modePreview.value!;
  expect(app.state.motion.value).toMatchObject({ source: 'mode', title: 'a mode' });
  expect(preview).toMatchObject({
    request,
    growth: true,
    suspended: { motion: before, time: 1, speed: 0.25, loop: false },
  });
  expect(app.state.loop.value).toBe(true);
  app.actions.showMode(request, false);
  expect(app.state.modePreview.value).toMatchObject({ growth: false, suspended: { motion: before, time: 1 } });
  app.actions.leaveMode();
  expect(app.state.motion.value).toBe(before);
  expect(app.state.modePreview.value).toBeNull();
  expect([app.state.time.value, app.state.speed.value, app.state.loop.value, app.state.playing.value]).toEqual([
    1,
    0.25,
    false,
    false,
  ]);
});

test('another motion ends it, and the speed and loop from before are back', () => {
  const app = playing();
  const file = app.state.motion.value!;
  app.actions.showMode(request, true);
  app.actions.showMotion({ ...file, title: 'another' });
  expect(app.state.modePreview.value).toBeNull();
  expect([app.state.speed.value, app.state.loop.value]).toEqual([0.25, false]);
});

test('a mode of a scenario that is wrong is told, and leaves the stage as it is', () => {
  const app = playing();
  const before = app.state.motion.value;
  app.actions.showMode({ ...request, scenario: { version: 1, system: 'stiff-decay', duration: -1 } }, true);
  expect(app.state.messages.value.at(-1)!.title).toBe('The mode cannot be shown');
  expect([app.state.motion.value, app.state.modePreview.value]).toEqual([before, null]);
});

test('the speed of the list at which one watches for about five seconds', () => {
  for (const speed of speeds) expect(speedFor(5 * speed, speeds)).toBe(speed);
});
