import { signal } from '@preact/signals';
import { expect, test } from 'vitest';
import { Kept, MOST_KEPT } from '../../../src/app/runs/pinnedRuns.ts';
import { Messages } from '../../../src/app/state/messages.ts';
import type { AppState, Message, Motion } from '../../../src/app/types.ts';
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
    constraints: null,
    scenario: null,
    written: null,
    adjustments: [],
    issues: [],
    marks: [],
    judgement: null,
  };
}

function bench() {
  const messages = signal<readonly Message[]>([]);
  const state = {
    motion: signal<Motion | null>(null),
    run: signal(null),
    statistics: signal(null),
    kept: signal([]),
  } as unknown as AppState;
  return { state, kept: new Kept(state, new Messages(messages)), titles: () => messages.value.map((m) => m.title) };
}

const names = (kept: Kept) => kept.runs.value.map((r) => r.name);

test('keeps what is on the stage once, each under a name and a style of its own', () => {
  const { state, kept, titles } = bench();
  expect(kept.keep()).toBeNull();
  for (const id of [1, 2, 3]) {
    state.motion.value = motion(id);
    expect(kept.keep()).not.toBeNull();
  }
  expect(kept.keep()).toBeNull();
  expect(titles()).toEqual(['There is nothing to keep', 'This run is kept already']);
  expect(names(kept)).toEqual(['Board', 'Board (2)', 'Board (3)']);
  expect(kept.runs.value.map((r) => r.style)).toEqual([0, 1, 2]);
  expect(kept.ofStage()?.motion.id).toBe(3);
});

test('what is removed comes back to its place, in its style unless that is taken', () => {
  const { state, kept } = bench();
  for (const id of [1, 2, 3]) {
    state.motion.value = motion(id);
    kept.keep();
  }
  kept.remove(2);
  expect(kept.runs.value.map((r) => r.id)).toEqual([1, 3]);
  kept.undo();
  expect(kept.runs.value.map((r) => [r.id, r.style])).toEqual([
    [1, 0],
    [2, 1],
    [3, 2],
  ]);
  kept.undo();
  expect(kept.runs.value).toHaveLength(3);
  kept.remove(2);
  state.motion.value = motion(9);
  kept.keep();
  kept.undo();
  expect(kept.runs.value.map((r) => [r.id, r.style])).toEqual([
    [1, 0],
    [2, 3],
    [3, 2],
    [4, 1],
  ]);
});

test('an empty name is none', () => {
  const { state, kept } = bench();
  state.motion.value = motion(1);
  kept.keep();
  kept.change(1, { name: '  wide  ' });
  expect(names(kept)).toEqual(['wide']);
  kept.change(1, { name: ' ', visible: false });
  expect(kept.runs.value[0]).toMatchObject({ name: 'wide', visible: false });
});

test('there is an end to it: as many as curves are told apart, as much as memory is promised', () => {
  const { state, kept, titles } = bench();
  for (let id = 1; id <= MOST_KEPT; id++) {
    state.motion.value = motion(id);
    kept.keep();
  }
  state.motion.value = motion(99);
  expect(kept.keep()).toBeNull();
  kept.remove(1);
  // 20 million rows of two columns are 320 MB.
  const large = motion(100);
  Object.defineProperty(large.trajectory, 'length', { value: 20e6 });
  state.motion.value = large;
  expect(kept.keep()).toBeNull();
  expect(titles()).toEqual(['No more runs can be kept', 'This run is too large to keep']);
});

test('a run kept while it computes learns how it ended', () => {
  const { state, kept } = bench();
  state.motion.value = motion(1);
  state.run.value = { kind: 'computing', progress: 0.1 };
  kept.keep();
  expect(kept.runs.value[0]!.ending).toBeNull();
  const ending = { kind: 'ended', reason: 'touchdown', message: '', time: 0.5 } as const;
  state.run.value = ending;
  expect(kept.runs.value[0]!.ending).toBe(ending);
});
