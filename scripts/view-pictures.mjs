// npm run pictures -- views [name …]: every main view of the built page, light and dark, at four sizes, as
// docs/pictures/views/<view>-<size>-<theme>.webp, listed in docs/pictures/README.md. Tools are those of the page.
/* global window, document, setTimeout -- functions given to the page run there */
import { mkdirSync, readdirSync, writeFileSync } from 'node:fs';
import { Buffer } from 'node:buffer';
import { join } from 'node:path';
import { webp } from './case-pictures.mjs';
import { root } from './setup.mjs';

const SIZES = {
  desk: { width: 1440, height: 900 },
  laptop: { width: 1024, height: 768 },
  tablet: { width: 820, height: 1180 },
  phone: { width: 390, height: 844 },
};
/** Sizes at which the panels are tabs below the scene. */
const TABBED = ['tablet', 'phone'];
const THEMES = ['light', 'dark'];
const QUALITY = 0.62;
/** What stands on the stage: a case that every tool has something to say about, at a moment of it (s). */
const ON_STAGE = { id: 'balanced', at: 1.5 };
/** What is computed or drawn later has come when nothing has changed for this long (ms). */
const QUIET_MS = 700;
const LONGEST_MS = 20_000;

const id = (name) => `[data-testid="${name}"]`;

export async function viewPictures(browser, address, wanted) {
  mkdirSync(join(root, 'docs/pictures/views'), { recursive: true });
  for (const [form, size] of Object.entries(SIZES))
    for (const theme of THEMES) {
      const context = await browser.newContext({
        viewport: size,
        colorScheme: theme,
        reducedMotion: 'reduce',
        hasTouch: TABBED.includes(form),
        locale: 'en-US',
        timezoneId: 'UTC',
        bypassCSP: true,
      });
      const page = await context.newPage();
      page.on('pageerror', (error) => console.error(`page: ${error.message}`));
      await page.goto(address);
      await page.waitForFunction(() => window.ripstikScene?.stats().bodies > 0);
      const views = await viewsOf(page, form);
      for (const { name, open, close } of views) {
        const file = `${name}-${form}-${theme}`;
        if (name === 'scene') await putOnStage(page);
        if (wanted.length > 0 && !wanted.includes(name)) {
          // What a first visit is offered lies over all that follows.
          if (name === 'first-visit') await open().then(close);
          continue;
        }
        await open();
        await quiet(page);
        const png = await page.screenshot({ animations: 'disabled', caret: 'hide' });
        await close?.();
        const bytes = await webp(page, png, size, QUALITY);
        writeFileSync(join(root, 'docs/pictures/views', `${file}.webp`), bytes);
        console.log(`${file}  ${(bytes.length / 1000).toFixed(0)} kB`);
      }
      await context.close();
    }
  list();
}

/** In the order in which they are taken; the first visit comes before anything has been touched. */
async function viewsOf(page, form) {
  const click = (testId) => () => page.click(id(testId));
  const escape = () => page.keyboard.press('Escape');
  const tabs = TABBED.includes(form);
  const tools = await page.evaluate(
    (prefix) =>
      [...document.querySelectorAll(`[data-testid^="${prefix}-"]`)]
        .filter((b) => b.closest('.rail, .tabs'))
        .map((b) => b.dataset.testid.slice(prefix.length + 1)),
    tabs ? 'tab' : 'tool',
  );
  return [
    { name: 'first-visit', open: () => page.waitForSelector(id('offer')), close: click('offer-close') },
    { name: 'scene', open: async () => {} },
    { name: 'gallery', open: click('case-menu'), close: escape },
    { name: 'keys', open: click('keys'), close: escape },
    { name: 'control', open: () => showControl(page, tabs) },
    ...tools.map((tool) => ({
      name: `${tabs && tool === 'experiment' ? '' : 'tool-'}${tool}`,
      open: async () => {
        if (tool === 'import') await openFile(page, SLEIGH);
        await openTool(page, tool, tabs);
      },
    })),
    {
      name: 'data',
      open: async () => {
        await openFile(page, LOG);
        await openTool(page, 'plots', tabs);
      },
    },
  ];
}

async function putOnStage(page) {
  await page.evaluate(async ({ id: which, at }) => {
    const { state, actions } = window.ripstikApp;
    actions.loadCase(which);
    const met = () =>
      state.origin.value.id === which &&
      state.run.value?.kind === 'ended' &&
      state.motion.value?.written === state.draft.value;
    while (!met()) await new Promise((done) => setTimeout(done, 30));
    actions.pause();
    actions.seek(at);
    actions.set('view', 'side');
    actions.set('view', 'orbit');
  }, ON_STAGE);
}

/** A logger's file whose angles name no unit, and one that names no system's coordinates. */
const times = Array.from({ length: 120 }, (_, i) => i / 30);
const comma = (numbers) => numbers.map((x) => x.toFixed(2).replace('.', ',')).join(';');
const SLEIGH = {
  name: 'sleigh.csv',
  text: [
    'Zeit;x;y;theta;Temp',
    'ms;mm;mm;;°C',
    ...times.map((t) => comma([1000 * t, 900 * Math.sin(t), 450 * (1 - Math.cos(t)), 200 * Math.sin(t / 2), 21])),
  ].join('\n'),
};
const LOG = {
  name: 'motor log.csv',
  text: [
    'time [s],voltage [V],current [A],gyro z [deg/s]',
    ...times.map((t) => [t, 12 - Math.sin(t) / 4, 2 + Math.sin(3 * t), 40 * Math.sin(2 * t)].join()),
  ].join('\n'),
};

async function openFile(page, { name, text }) {
  await page.setInputFiles(id('open-file'), { name, mimeType: 'text/csv', buffer: Buffer.from(text) });
  await page.waitForFunction((title) => window.ripstikApp.state.motion.value?.title === title, name);
  await page.evaluate(() => {
    window.ripstikApp.actions.pause();
    window.ripstikApp.actions.seek(1.5);
  });
}

async function showControl(page, tabs) {
  if (tabs) await page.click(id('tab-experiment'));
  await page.locator(id('control')).evaluate((field) => {
    const section = field.closest('details');
    section.open = true;
    section.scrollIntoView({ block: 'start' });
  });
}

async function openTool(page, tool, tabs) {
  if (tabs) return page.click(id(`tab-${tool}`));
  const button = page.locator(id(`tool-${tool}`));
  if ((await button.getAttribute('aria-expanded')) !== 'true') await button.click();
}

/** Until neither the page's elements nor its scene have changed for a while. */
async function quiet(page) {
  await page.evaluate(
    async ([still, longest]) => {
      const state = () =>
        `${window.ripstikScene?.stats().frames} ${document.body.innerText.length} ${document.querySelectorAll('*').length} ${[...document.images].every((i) => i.complete)}`;
      const began = Date.now();
      for (let before = ''; before !== state() && Date.now() - began < longest;) {
        before = state();
        await new Promise((done) => setTimeout(done, still));
      }
    },
    [QUIET_MS, LONGEST_MS],
  );
}

function list() {
  const files = readdirSync(join(root, 'docs/pictures/views')).filter((name) => name.endsWith('.webp'));
  const views = [...new Set(files.map((name) => name.replace(/-[a-z]+-(light|dark)\.webp$/, '')))];
  const cell = (view, form, theme) => {
    const name = `${view}-${form}-${theme}.webp`;
    return files.includes(name) ? `[${theme}](views/${name})` : '';
  };
  const rows = views.map(
    (view) =>
      `| ${view.replace(/^tool-/, 'tool: ').replaceAll('-', ' ')} | ${Object.keys(SIZES)
        .map((form) =>
          THEMES.map((theme) => cell(view, form, theme))
            .filter(Boolean)
            .join(' · '),
        )
        .join(' | ')} |`,
  );
  writeFileSync(
    join(root, 'docs/pictures/README.md'),
    [
      '# Pictures',
      '',
      'Drawn by the program from the built page: `npm run pictures` makes those beside this page, `npm run pictures -- views` the main views below and this list, `npm run pictures -- cases` the scenes of [the cases](../cases.md).',
      '',
      `| view | ${Object.entries(SIZES)
        .map(([form, { width, height }]) => `${form}, ${width} × ${height}`)
        .join(' | ')} |`,
      '|---|---|---|---|---|',
      ...rows,
      '',
    ].join('\n'),
  );
}
