import { expect, test } from 'vitest';
import { PinnedRuns, MOST_PINNED } from '../../../src/app/runs/pinnedRuns.ts';
import { createMessages } from '../../../src/app/state/messages.ts';
import { UNRECORDED, type Motion } from '../../../src/app/runs/motion.ts';
import { createStage } from '../../../src/app/runs/stageState.ts';
import { ripstikView } from '../../../src/core/systems/ripstik/view.ts';
import { Trajectory } from '../../../src/core/motion/trajectory.ts';

function motion(id: number, rows = 3, columns = 2): Motion {
  const trajectory = new Trajectory(['t', ...Array.from({ length: columns - 1 }, (_, i) => `c${i}`)], 1);
  trajectory.append(
    trajectory.columns.map(() => Float64Array.from({ length: rows }, (_, i) => i)),
    rows,
  );
  return {
    id,
    source: 'run',
    title: 'Board',
    system: ripstikView,
    parameters: {},
    trajectory,
    ...UNRECORDED,
  };
}

function bench() {
  const messages = createMessages();
  const { state, actions } = createStage();
  return {
    stage: actions,
    pinned: new PinnedRuns(state, messages.actions),
    titles: () => messages.state.messages.value.map((m) => m.title),
  };
}

const names = (pinned: PinnedRuns) => pinned.runs.value.map((r) => r.name);

test('pins what is on the stage once, each under a name and a style of its own', () => {
  const { stage, pinned, titles } = bench();
  expect(pinned.pin()).toBeNull();
  for (const id of [1, 2, 3]) {
    stage.setMotion(motion(id));
    expect(pinned.pin()).not.toBeNull();
  }
  expect(pinned.pin()).toBeNull();
  expect(titles()).toEqual(['There is nothing to pin', 'This run is pinned already']);
  expect(names(pinned)).toEqual(['Board', 'Board (2)', 'Board (3)']);
  expect(pinned.runs.value.map((r) => r.style)).toEqual([0, 1, 2]);
  expect(pinned.ofStage()?.motion.id).toBe(3);
});

test('what is removed comes back to its place, in its style unless that is taken', () => {
  const { stage, pinned } = bench();
  for (const id of [1, 2, 3]) {
    stage.setMotion(motion(id));
    pinned.pin();
  }
  pinned.remove(2);
  expect(pinned.runs.value.map((r) => r.id)).toEqual([1, 3]);
  pinned.undo();
  expect(pinned.runs.value.map((r) => [r.id, r.style])).toEqual([
    [1, 0],
    [2, 1],
    [3, 2],
  ]);
  pinned.undo();
  expect(pinned.runs.value).toHaveLength(3);
  pinned.remove(2);
  stage.setMotion(motion(9));
  pinned.pin();
  pinned.undo();
  expect(pinned.runs.value.map((r) => [r.id, r.style])).toEqual([
    [1, 0],
    [2, 3],
    [3, 2],
    [4, 1],
  ]);
});

test('an empty name is none', () => {
  const { stage, pinned } = bench();
  stage.setMotion(motion(1));
  pinned.pin();
  pinned.change(1, { name: '  wide  ' });
  expect(names(pinned)).toEqual(['wide']);
  pinned.change(1, { name: ' ', visible: false });
  expect(pinned.runs.value[0]).toMatchObject({ name: 'wide', visible: false });
});

test('there is an end to it: as many as curves are told apart, as much as memory is promised', () => {
  const { stage, pinned, titles } = bench();
  for (let id = 1; id <= MOST_PINNED; id++) {
    stage.setMotion(motion(id));
    pinned.pin();
  }
  stage.setMotion(motion(99));
  expect(pinned.pin()).toBeNull();
  pinned.remove(1);
  // 20 million rows of two columns are 320 MB.
  const large = motion(100);
  Object.defineProperty(large.trajectory, 'length', { value: 20e6 });
  stage.setMotion(large);
  expect(pinned.pin()).toBeNull();
  expect(titles()).toEqual(['No more runs can be pinned', 'This run is too large to pin']);
});

test('a run pinned while it computes learns how it ended', () => {
  const { stage, pinned } = bench();
  stage.setMotion(motion(1));
  stage.setRun({ kind: 'computing', progress: 0.1 });
  pinned.pin();
  expect(pinned.runs.value[0]!.ending).toBeNull();
  const ending = { kind: 'ended', reason: 'touchdown', message: '', time: 0.5 } as const;
  stage.setRun(ending);
  expect(pinned.runs.value[0]!.ending).toBe(ending);
});
