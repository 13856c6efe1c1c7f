// What a browser has stored and what links say of the page: the text itself is permanent.
import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest';
import type { App } from '../../../src/app/app.ts';
import { Autosave } from '../../../src/app/persistence/autosave.ts';
import { linkOf } from '../../../src/app/persistence/links.ts';
import { decodeLink } from '../../../src/core/scenario/link.ts';
import { settingValues } from '../../../src/app/state/settings.ts';
import { systemMetas } from '../../../src/app/store.ts';
import { appOf, storageOf } from '../appOf.ts';

/** As the page first stored it, before there was a table of settings. */
const STORED = {
  fresh:
    '{"version":1,"system":"ripstik","drafts":[{"draft":null,"origin":"ridden"}],"file":null,"settings":{"theme":"dark","tool":"now","view":"orbit","follow":true,"showTrails":true,"showForces":false,"loop":false,"speed":1,"plots":{"own":null,"degrees":true,"wrapped":false},"look":{"names":false,"frames":false,"inset":false,"level":true,"quality":"auto"}}}',
  edited:
    '{"version":1,"system":"chaplygin-sleigh","drafts":[{"draft":null,"origin":"ridden"},{"draft":{"version":1,"system":"bicycle","initial":{"speed":4.6,"roll_dot":0.5},"method":{"rtol":1e-10},"duration":3},"origin":"bicycle-stable"},{"draft":null,"origin":"chaplygin-sleigh"}],"file":null,"settings":{"theme":"light","tool":"plots","view":"side","follow":false,"showTrails":false,"showForces":true,"loop":true,"speed":0.25,"plots":{"own":{"key":"a/b","panes":[{"title":"Path","x":"X","y":["Y"],"equal":true}]},"degrees":false,"wrapped":true},"look":{"names":true,"frames":true,"inset":true,"level":false,"quality":"low"}}}',
  own: '{"version":1,"system":"stiff-decay","drafts":[{"draft":null,"origin":"ridden"},{"draft":{"version":1,"system":"bicycle","initial":{"speed":4.6,"roll_dot":0.5},"method":{"rtol":1e-10},"duration":3},"origin":"bicycle-stable"},{"draft":null,"origin":"chaplygin-sleigh"},{"draft":null,"origin":{"title":"Mine","scenario":{"version":1,"system":"stiff-decay","duration":2}}}],"file":null,"settings":{"theme":"light","tool":"plots","view":"side","follow":false,"showTrails":false,"showForces":true,"loop":true,"speed":0.25,"plots":{"own":{"key":"a/b","panes":[{"title":"Path","x":"X","y":["Y"],"equal":true}]},"degrees":false,"wrapped":true},"look":{"names":true,"frames":true,"inset":true,"level":false,"quality":"low"}}}',
};
const LINKS = {
  fresh: 'v=1&case=ridden&tool=now&sum=141k9ic',
  edited:
    'v=1&case=chaplygin-sleigh&tool=plots&view=side&plots=%7B%22own%22%3A%7B%22key%22%3A%22a%2Fb%22%2C%22panes%22%3A%5B%7B%22title%22%3A%22Path%22%2C%22x%22%3A%22X%22%2C%22y%22%3A%5B%22Y%22%5D%2C%22equal%22%3Atrue%7D%5D%7D%2C%22degrees%22%3Afalse%2C%22wrapped%22%3Atrue%7D&sum=1ee0rsy',
  own: 'v=1&title=Mine&system=stiff-decay&duration=2&tool=plots&view=side&plots=%7B%22own%22%3A%7B%22key%22%3A%22a%2Fb%22%2C%22panes%22%3A%5B%7B%22title%22%3A%22Path%22%2C%22x%22%3A%22X%22%2C%22y%22%3A%5B%22Y%22%5D%2C%22equal%22%3Atrue%7D%5D%7D%2C%22degrees%22%3Afalse%2C%22wrapped%22%3Atrue%7D&sum=1patnpc',
};
const TOOLS = ['now', 'plots'];

beforeEach(() => {
  vi.useFakeTimers();
  vi.stubGlobal('addEventListener', () => undefined);
  vi.stubGlobal('document', { addEventListener: () => undefined });
});
afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

function saving(texts: Record<string, string> = {}) {
  const app = appOf({ dark: true, roomy: true });
  const browser = storageOf(texts);
  const autosave = new Autosave(app, browser.storage, systemMetas, TOOLS);
  autosave.restore();
  autosave.watch();
  const stored = () => {
    vi.runAllTimers();
    return browser.texts['work'];
  };
  return { app, autosave, browser, stored };
}

function change({ actions }: App): void {
  actions.chooseSystem('bicycle');
  actions.edit('duration', (draft) => ({ ...draft, duration: 3 }));
  actions.loadCase('chaplygin-sleigh');
  actions.setAll({
    theme: 'light',
    tool: 'plots',
    view: 'side',
    follow: false,
    showTrails: false,
    showForces: true,
    loop: true,
    speed: 0.25,
    plots: {
      own: { key: 'a/b', panes: [{ title: 'Path', x: 'X', y: ['Y'], equal: true }] },
      degrees: false,
      wrapped: true,
    },
    showNames: true,
    showFrames: true,
    showInset: true,
    levelHorizon: false,
    quality: 'low',
    metresPerNewton: 0.1,
    dragPushes: true,
  });
}

describe('stored text and links', () => {
  test('are to the letter what they were', () => {
    const { app, stored } = saving();
    expect(stored()).toBe(STORED.fresh);
    expect(linkOf(app)).toBe(LINKS.fresh);
    change(app);
    expect(stored()).toBe(STORED.edited);
    expect(linkOf(app)).toBe(LINKS.edited);
    app.actions.loadScenario({ version: 1, system: 'stiff-decay', duration: 2 }, 'Mine');
    expect(stored()).toBe(STORED.own);
    expect(linkOf(app)).toBe(LINKS.own);
  });

  test.each(Object.entries(STORED))('%s: put back whole, and stored again as it was', (_, text) => {
    const { app, stored } = saving({ work: text });
    app.actions.set('theme', app.state.theme.value === 'dark' ? 'light' : 'dark');
    app.actions.set('theme', app.state.theme.value === 'dark' ? 'light' : 'dark');
    expect(stored()).toBe(text);
  });

  test('settings that are stored come back; the others are at their start', () => {
    const { app } = saving({ work: STORED.edited });
    expect(settingValues(app.state)).toMatchObject({
      theme: 'light',
      showNames: true,
      levelHorizon: false,
      quality: 'low',
      metresPerNewton: 0.01,
      dragPushes: false,
    });
    expect(app.state.draft.value.system).toBe('chaplygin-sleigh');
    app.actions.chooseSystem('bicycle');
    expect(app.state.draft.value.duration).toBe(3);
  });
});

describe('work that a link took the place of', () => {
  test('stays stored until something is edited', () => {
    const { app, autosave, stored } = saving({ work: STORED.edited });
    const before = autosave.restore()!;
    app.actions.loadCase('ridden');
    const onEdit = vi.fn();
    autosave.suspend(before, onEdit);
    app.actions.set('speed', 0.5);
    expect(JSON.parse(stored()!)).toMatchObject({ system: 'chaplygin-sleigh', settings: { speed: 0.5 } });
    app.actions.edit('nothing', (draft) => draft);
    expect(onEdit).not.toHaveBeenCalled();
    expect(autosave.suspendedWork).toBe(before);
    app.actions.edit('duration', (draft) => ({ ...draft, duration: 1 }));
    expect(onEdit).toHaveBeenCalledOnce();
    expect(autosave.suspendedWork).toBeNull();
    expect(JSON.parse(stored()!)).toMatchObject({ system: 'ripstik' });
  });

  test('comes back', async () => {
    const { app, autosave, stored } = saving({ work: STORED.edited });
    const before = autosave.restore()!;
    app.actions.loadCase('ridden');
    autosave.suspend(before, () => undefined);
    await autosave.restoreWork(before);
    expect(app.state.draft.value.system).toBe('chaplygin-sleigh');
    expect(stored()).toBe(STORED.edited);
  });
});

test('a title of one’s own is stored and linked beside the case', () => {
  const { app, stored } = saving();
  app.actions.loadCase('released');
  app.actions.rename('Let go & caught');
  const text = stored()!;
  expect(text).toContain('{"case":"released","title":"Let go & caught"}');
  const again = saving({ work: text });
  expect(again.app.state.origin.value).toMatchObject({ id: 'released', title: 'Let go & caught' });
  const link = decodeLink(linkOf(app), { systems: systemMetas, cases: app.cases });
  expect(link).toMatchObject({ caseId: 'released', title: 'Let go & caught', altered: false });
});

test('what cannot be used stays stored until something is edited', () => {
  const { app, stored } = saving({ work: '{"version":9}' });
  expect(app.state.messages.value.at(-1)!.kind).toBe('warning');
  app.actions.set('speed', 0.5);
  expect(stored()).toBe('{"version":9}');
  app.actions.edit('duration', (draft) => ({ ...draft, duration: 1 }));
  expect(JSON.parse(stored()!)).toMatchObject({ version: 1 });
});

test('a draft that cannot run is not stored: the last good one stays', () => {
  const { app, stored } = saving();
  const good = stored();
  app.actions.edit('duration', (draft) => ({ ...draft, duration: -1 }));
  expect(app.state.draftErrors.value.size).toBe(1);
  expect(stored()).toBe(good);
});
