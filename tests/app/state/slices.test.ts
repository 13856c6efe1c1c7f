// The slices alone: what their actions do to their state.
import { effect, type ReadonlySignal } from '@preact/signals';
import { describe, expect, test, vi } from 'vitest';
import { createPush } from '../../../src/app/push/pushState.ts';
import type { Motion } from '../../../src/app/runs/motion.ts';
import { createStage } from '../../../src/app/runs/stageState.ts';
import { createExportService } from '../../../src/app/files/exportService.ts';
import type { ExportRenderer } from '../../../src/app/files/exportRenderer.ts';
import { builtInCases, firstCaseOf } from '../../../src/app/state/cases.ts';
import { createDialogs } from '../../../src/app/state/dialogs.ts';
import { createExperiment } from '../../../src/app/state/experiment.ts';
import { createMessages } from '../../../src/app/state/messages.ts';
import { createPlayback } from '../../../src/app/state/playback.ts';
import { createSettings, drawnSettings, settingValues } from '../../../src/app/state/settings.ts';
import { SETTINGS, settingIds } from '../../../src/app/state/settingsTable.ts';
import { createEvent } from '../../../src/app/state/signals.ts';
import { systemMetas } from '../../../src/app/store.ts';
import { Trajectory } from '../../../src/core/motion/trajectory.ts';

/** How often a signal changes while something is done. */
function changes(signal: ReadonlySignal<unknown>, act: () => void): number {
  let runs = -1;
  const stop = effect(() => {
    void signal.value;
    runs++;
  });
  act();
  stop();
  return runs;
}

describe('the experiment', () => {
  const [first, second] = builtInCases as [(typeof builtInCases)[0], (typeof builtInCases)[0]];
  const make = () => {
    const experiment = createExperiment(first, systemMetas);
    const edits: string[] = [];
    experiment.edited.subscribe(({ label }) => edits.push(label));
    return { ...experiment, edits };
  };

  test('changes through one door, which says what was changed, from what, to what', () => {
    const { state, actions, edited, edits } = make();
    const seen = vi.fn();
    edited.subscribe(seen);
    actions.edit('duration', (draft) => ({ ...draft, duration: 3 }));
    expect(state.draft.value).toEqual({ ...first.scenario, duration: 3 });
    expect(seen).toHaveBeenCalledWith({
      label: 'duration',
      before: { draft: first.scenario, origin: first },
      after: { draft: state.draft.value, origin: first },
    });
    actions.replace('another case', { draft: second.scenario, origin: second });
    expect(state.origin.value).toBe(second);
    expect(edits).toEqual(['duration', 'another case']);
  });

  test('what changes nothing is no edit', () => {
    const { state, actions, edits } = make();
    expect(changes(state.draft, () => actions.edit('nothing', (draft) => draft))).toBe(0);
    actions.replace('the same', { draft: first.scenario, origin: first });
    expect(edits).toEqual([]);
  });

  test('the draft and where it came from change at one moment', () => {
    const { state, actions } = make();
    const pairs: string[] = [];
    const stop = effect(() => void pairs.push(`${state.draft.value.system} ${state.origin.value.scenario.system}`));
    const bicycle = firstCaseOf(systemMetas['bicycle']!);
    actions.replace('', { draft: bicycle.scenario, origin: bicycle });
    stop();
    expect(pairs).toEqual([`${first.scenario.system} ${first.scenario.system}`, 'bicycle bicycle']);
  });

  test('remembers the draft of each system, and says what is wrong with the present one', () => {
    const { state, actions } = make();
    actions.edit('duration', (draft) => ({ ...draft, duration: 3 }));
    const bicycle = firstCaseOf(systemMetas['bicycle']!);
    actions.replace('', { draft: bicycle.scenario, origin: bicycle });
    expect([...state.drafts.value.keys()]).toEqual([first.scenario.system, 'bicycle']);
    expect(state.drafts.value.get(first.scenario.system)!.draft.duration).toBe(3);
    actions.edit('duration', (draft) => ({ ...draft, duration: -1 }));
    expect([...state.draftErrors.value.keys()]).toEqual(['duration']);
  });
});

describe('settings', () => {
  test('begin as the table says, or as the browser asks', () => {
    const { state } = createSettings({ theme: 'dark', tool: null });
    expect(settingValues(state)).toEqual({
      ...Object.fromEntries(settingIds.map((id) => [id, SETTINGS[id].initial])),
      theme: 'dark',
    });
  });

  test('several change at one moment', () => {
    const { state, actions } = createSettings();
    expect(changes(state.speed, () => actions.setAll({ speed: 2, loop: true }))).toBe(1);
    expect([state.speed.value, state.loop.value, state.view.value]).toEqual([2, true, 'orbit']);
    actions.toggle('loop');
    expect(state.loop.value).toBe(false);
  });

  test('what the scene draws by follows them', () => {
    const { state, actions } = createSettings();
    let drawn = drawnSettings(state);
    const stop = effect(() => void (drawn = drawnSettings(state)));
    actions.toggle('showForces');
    actions.set('metresPerNewton', 0.1);
    stop();
    expect(drawn).toEqual({
      trails: true,
      forces: true,
      names: false,
      frames: false,
      level: true,
      metresPerNewton: 0.1,
    });
  });

  test.each(settingIds)('%s: its initial value passes its own check, and another’s does not', (id) => {
    const { initial, check } = SETTINGS[id];
    expect(check(initial, { toolIds: [] })).toEqual(initial);
    for (const wrong of [undefined, 'nothing of the kind', {}, [], NaN])
      expect(check(wrong, { toolIds: [] })).toBeUndefined();
  });

  test('no two have one place in the storage, in links or in the scene', () => {
    for (const key of ['stored', 'linked', 'drawn'] as const) {
      const places = settingIds.flatMap((id) => SETTINGS[id][key] ?? []);
      expect(new Set(places).size).toBe(places.length);
    }
  });
});

describe('playback', () => {
  vi.stubGlobal('requestAnimationFrame', () => 0);
  vi.stubGlobal('cancelAnimationFrame', () => undefined);
  const make = () => {
    const stage = createStage();
    const playback = createPlayback(stage.state, createSettings().state);
    const trajectory = Trajectory.of(['t'], [Float64Array.of(1, 2, 3, 4)]);
    const motion = { id: 1, trajectory } as unknown as Motion;
    return { stage, playback, put: () => stage.actions.put({ motion, run: null, statistics: null }) };
  };

  test('without a motion goes nowhere', () => {
    const { playback } = make();
    playback.actions.play();
    playback.actions.stepRows(1);
    playback.actions.seek(3);
    expect([playback.state.playing.value, playback.state.time.value]).toEqual([false, 0]);
  });

  test('stays within the motion; between two rows a step goes to the next of them', () => {
    const { playback, put } = make();
    put();
    const { state, actions } = playback;
    const after = (act: () => void): number => {
      act();
      return state.time.value;
    };
    expect(after(() => actions.seek(9))).toBe(4);
    expect(after(() => actions.seek(-9))).toBe(1);
    expect(after(() => actions.seek(2.4))).toBe(2.4);
    expect(after(() => actions.stepRows(1))).toBe(3);
    actions.seek(2.4);
    expect(after(() => actions.stepRows(-1))).toBe(2);
    expect(after(() => actions.stepRows(-9))).toBe(1);
  });

  test('at its end begins anew, but waits while rows still come', () => {
    const { stage, playback, put } = make();
    put();
    playback.actions.seek(4);
    stage.actions.setRun({ kind: 'computing', progress: 0.5 });
    playback.actions.togglePlaying();
    expect([playback.state.playing.value, playback.state.time.value]).toEqual([true, 4]);
    playback.actions.togglePlaying();
    stage.actions.setRun({ kind: 'ended', reason: 'end', message: '', time: 4 });
    playback.actions.play();
    expect([playback.state.playing.value, playback.state.time.value]).toEqual([true, 1]);
  });
});

test('the stage: a motion and what is known of it change at one moment', () => {
  const { state, actions } = createStage();
  const motion = { id: 7 } as Motion;
  const seen: unknown[] = [];
  const stop = effect(() => void seen.push([state.motion.value?.id, state.run.value?.kind]));
  actions.put({ motion, run: { kind: 'computing', progress: 0 }, statistics: null });
  stop();
  expect(seen).toEqual([
    [undefined, undefined],
    [7, 'computing'],
  ]);
  expect(changes(state.rowsVersion, actions.grew)).toBe(1);
});

test('messages: the newest five, each with a number of its own', () => {
  const { state, actions } = createMessages();
  for (let i = 1; i <= 7; i++) actions.report('info', `${i}`, []);
  expect(state.messages.value.map(({ title }) => title)).toEqual(['3', '4', '5', '6', '7']);
  actions.dismiss(state.messages.value[1]!.id);
  expect(state.messages.value.map(({ title }) => title)).toEqual(['3', '5', '6', '7']);
});

test('messages: a newer one on the same topic takes the place of the old', () => {
  const { state, actions } = createMessages();
  actions.report('error', 'The run could not go on', ['first']);
  actions.report('info', 'Opened a.json', [], undefined, 'opened');
  actions.report('error', 'The run could not go on', ['second']);
  actions.report('info', 'Opened b.json', [], undefined, 'opened');
  expect(state.messages.value.map(({ title, details }) => [title, ...details])).toEqual([
    ['The run could not go on', 'second'],
    ['Opened b.json'],
  ]);
});

test('one dialog at a time; one push', () => {
  const { state, actions } = createDialogs();
  actions.openDialog('keys');
  actions.openDialog('export');
  expect(state.dialog.value).toBe('export');
  actions.closeDialog();
  expect(state.dialog.value).toBeNull();
  const push = createPush();
  push.actions.setPush({ body: 'rod', point: [0, 0, 0], target: [1, 0, 0], stiffness: 1, damping: 0 });
  expect(push.state.push.value?.body).toBe('rod');
});

test('the renderer of exports is there while the scene offers it', () => {
  const service = createExportService();
  expect(service.available.value).toBe(false);
  expect(() => service.renderer()).toThrow('no scene');
  const renderer = {} as ExportRenderer;
  service.offer(renderer);
  expect([service.available.value, service.renderer()]).toEqual([true, renderer]);
  service.offer(null);
  expect(service.available.value).toBe(false);
});

test('an event is heard by who listens, once each time, and by nobody after', () => {
  const event = createEvent<number>();
  event.emit(0);
  const heard: number[] = [];
  const stop = event.subscribe((n) => heard.push(n));
  event.emit(1);
  event.emit(2);
  stop();
  event.emit(3);
  expect(heard).toEqual([1, 2]);
});
