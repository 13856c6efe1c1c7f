// Undo and redo: every change of the experiment can be taken back and done again, in any number, and nothing is lost by it.
import { expect, test, vi } from 'vitest';
import { builtInCases } from '../../../src/app/state/cases.ts';
import { createExperiment } from '../../../src/app/state/experiment.ts';
import { createHistory } from '../../../src/app/state/history.ts';
import { withEntry, withKey } from '../../../src/app/state/draft.ts';
import { systemMetas } from '../../../src/app/store.ts';

const [first, second] = builtInCases as [(typeof builtInCases)[0], (typeof builtInCases)[0]];

function make() {
  const experiment = createExperiment(first, systemMetas);
  let clock = 0;
  const moved = vi.fn();
  const history = createHistory(experiment, moved, () => clock);
  const set = (label: string, duration: number, after = 1000) => {
    clock += after;
    experiment.actions.edit(label, (draft) => withKey(draft, 'duration', duration));
  };
  return { ...experiment, history, moved, set, draft: () => experiment.state.draft.peek() };
}

test('any walk through the history ends where that many changes were in force', () => {
  const { history, set, draft, actions } = make();
  const states = [draft()];
  for (let k = 1; k <= 6; k++) {
    if (k === 4) actions.replace('another case', { draft: second.scenario, origin: second });
    else set(`change ${k}`, k);
    states.push(draft());
  }
  for (const at of [3, 5, 0, 6, 2, 4, 1]) {
    history.actions.goToEdit(at);
    expect(history.state.historyAt.value).toBe(at);
    expect(draft()).toBe(states[at]);
  }
  for (let k = 0; k < 9; k++) history.actions.undo();
  expect(draft()).toBe(first.scenario);
  for (let k = 0; k < 9; k++) history.actions.redo();
  expect(draft()).toBe(states[6]);
});

test('one gesture is one step; another thing, or a pause, begins the next', () => {
  const { history, set, actions } = make();
  for (let k = 1; k <= 5; k++) set('duration', k, 20);
  expect(history.state.history.value).toHaveLength(1);
  set('duration', 9, 1000);
  actions.edit('lean', (draft) => withEntry(draft, 'initial', 'alpha', 0.1));
  expect(history.state.history.value.map(({ label }) => label)).toEqual(['duration', 'duration', 'lean']);
});

test('a gesture that comes back to where it began leaves nothing to undo', () => {
  const { history, set, actions } = make();
  set('duration', 7, 20);
  actions.edit('duration', () => first.scenario);
  expect(history.state.history.value).toEqual([]);
});

test('a change after undoing takes the place of what was undone; each step says what it changed', () => {
  const { history, set, draft, moved } = make();
  set('a', 1);
  set('b', 2);
  history.actions.undo();
  expect(moved).toHaveBeenLastCalledWith(
    expect.objectContaining({ label: 'b', after: expect.objectContaining({ draft: draft() }) }),
  );
  set('c', 3);
  expect(history.state.history.value.map(({ label }) => label)).toEqual(['a', 'c']);
  history.actions.redo();
  expect(draft().duration).toBe(3);
  expect(moved).toHaveBeenCalledTimes(1);
});
