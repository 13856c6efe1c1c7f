/** What the frame of the page offers; features add theirs, and `createUi` joins them. */
import type { Command, Key, KeyLine } from '../../app/commands.ts';
import { viewsOf } from '../../app/runs/views.ts';
import type { App } from '../../app/app.ts';
import { speeds } from '../../app/state/playbackClock.ts';
import type { SwitchId, ViewName } from '../../app/state/settingsTable.ts';
import type { Feature } from '../feature.ts';
import { fieldCommands } from '../kit/fieldCommands.ts';
import { text } from '../words.ts';

/** Shift and an arrow go this far, s. */
const JUMP = 0.1;

const lines = Object.fromEntries(Object.entries(text.keyLines).map(([id, what]) => [id, { what }])) as Record<
  keyof typeof text.keyLines,
  KeyLine
>;
const on = (line: KeyLine, key: string, rest: Omit<Key, 'key' | 'line'> = {}): Key => ({ key, line, ...rest });

const hasMotion = ({ state }: App): boolean => state.motion.value !== null;
const by = (seconds: number) => (app: App) => app.actions.seek(app.state.time.peek() + seconds);

const playback: readonly Command[] = [
  {
    id: 'play',
    label: ({ state }) => (state.playing.value ? text.transport.pause : text.transport.play),
    keys: [on(lines.play, ' ')],
    enabled: hasMotion,
    perform: ({ actions }) => actions.togglePlaying(),
  },
  {
    id: 'step-back',
    label: text.transport.back,
    keys: [on(lines.step, 'ArrowLeft'), on(lines.stepToo, ',')],
    enabled: hasMotion,
    perform: ({ actions }) => actions.stepRows(-1),
  },
  {
    id: 'step-forward',
    label: text.transport.forward,
    keys: [on(lines.step, 'ArrowRight'), on(lines.stepToo, '.')],
    enabled: hasMotion,
    perform: ({ actions }) => actions.stepRows(1),
  },
  {
    id: 'tenth-back',
    label: lines.tenth.what,
    keys: [on(lines.tenth, 'ArrowLeft', { shift: true })],
    perform: by(-JUMP),
  },
  {
    id: 'tenth-forward',
    label: lines.tenth.what,
    keys: [on(lines.tenth, 'ArrowRight', { shift: true })],
    perform: by(JUMP),
  },
  {
    id: 'to-start',
    label: lines.ends.what,
    keys: [on(lines.ends, 'Home')],
    perform: ({ state, actions }) => actions.seek(state.motion.peek()?.trajectory.start ?? 0),
  },
  {
    id: 'to-end',
    label: lines.ends.what,
    keys: [on(lines.ends, 'End')],
    perform: ({ state, actions }) => actions.seek(state.motion.peek()?.trajectory.end ?? 0),
  },
  { id: 'slower', label: lines.speed.what, keys: [on(lines.speed, 'j')], perform: slower },
  { id: 'pause', label: text.transport.pause, keys: [on(lines.speed, 'k')], perform: ({ actions }) => actions.pause() },
  { id: 'faster', label: lines.speed.what, keys: [on(lines.speed, 'l')], perform: faster },
  switchOf('loop', 'loop', text.transport.loop),
];

/** Plays, or goes on playing, one speed slower. */
function slower({ state, actions }: App): void {
  const next = speeds.filter((speed) => speed < state.speed.peek()).at(-1);
  if (next !== undefined) actions.set('speed', next);
  if (!state.playing.peek()) actions.play();
}

/** Plays, then speeds up. */
function faster({ state, actions }: App): void {
  const next = speeds.find((speed) => speed > state.speed.peek());
  if (!state.playing.peek()) actions.play();
  else if (next !== undefined) actions.set('speed', next);
}

const VIEW_KEYS: Readonly<Record<ViewName, string>> = {
  orbit: '1',
  front: '2',
  side: '3',
  top: '4',
  caster: '5',
  rider: '6',
};

const views = (Object.keys(VIEW_KEYS) as ViewName[]).map((view): Command => ({
  id: `view-${view}`,
  label: text.view.names[view],
  keys: [on(lines.views, VIEW_KEYS[view])],
  enabled: ({ state, systemOf }) =>
    viewsOf((state.motion.value?.system ?? systemOf(state.draft.value.system))?.meta.views).includes(view),
  perform: ({ actions }) => actions.set('view', view),
}));

function switchOf(id: string, setting: SwitchId, label: string, ...keys: Key[]): Command {
  return { id, label, keys, perform: ({ actions }) => actions.toggle(setting) };
}

/** In the order of the sheet. */
const pageCommands: readonly Command[] = [
  ...playback,
  ...views,
  switchOf('follow', 'follow', text.view.follow, on(lines.follow, 'f')),
  switchOf('trails', 'showTrails', text.view.trails),
  switchOf('forces', 'showForces', text.view.forces),
  switchOf('inset', 'showInset', text.viewMenu.inset, on(lines.show, 'p')),
  switchOf('names', 'showNames', text.viewMenu.names, on(lines.show, 'n')),
  switchOf('frames', 'showFrames', text.viewMenu.frames, on(lines.show, 'a')),
  switchOf('level', 'levelHorizon', text.viewMenu.level),
  {
    id: 'theme',
    label: ({ state }) => text.top.theme(state.theme.value),
    perform: ({ state, actions }) => actions.set('theme', state.theme.peek() === 'dark' ? 'light' : 'dark'),
  },
];

/** Last on the sheet, after what the features add. */
const lastCommands: readonly Command[] = [
  {
    id: 'run',
    label: text.run,
    keys: [on(lines.run, 'Enter', { place: 'field' }), on(lines.run, 'Enter', { control: true })],
    perform: ({ actions }) => actions.run(),
  },
  {
    id: 'undo',
    label: ({ state }) => text.history.undo(state.history.value[state.historyAt.value - 1]?.label),
    keys: [on(lines.undo, 'z', { control: true, textual: true })],
    enabled: ({ state }) => state.historyAt.value > 0,
    perform: ({ actions }) => actions.undo(),
  },
  {
    id: 'redo',
    label: ({ state }) => text.history.redo(state.history.value[state.historyAt.value]?.label),
    keys: [
      on(lines.redo, 'z', { control: true, shift: true, textual: true }),
      on(lines.redo, 'y', { control: true, textual: true }),
    ],
    enabled: ({ state }) => state.historyAt.value < state.history.value.length,
    perform: ({ actions }) => actions.redo(),
  },
  ...fieldCommands,
  {
    id: 'keys',
    label: text.top.help,
    keys: [on(lines.keys, '?')],
    perform: ({ actions }) => actions.openDialog('keys'),
  },
];

/** The one list of commands: the page's, and those of its features. */
export const commandsOf = (features: readonly Pick<Feature, 'commands'>[]): readonly Command[] => [
  ...pageCommands,
  ...features.flatMap(({ commands }) => commands ?? []),
  ...lastCommands,
];
