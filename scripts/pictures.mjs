// npm run pictures: draws docs/pictures from the built page, each at a definite time, in a headless browser.
// With names, only those: npm run pictures -- ridden-light phone-dark; the scenes of the cases: npm run pictures -- cases; every main view: npm run pictures -- views; the film of a ride: npm run pictures -- ride
/* global window, document, localStorage, Event, setTimeout -- functions given to the page run there */
import { existsSync, mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { findBrowser } from './browser.mjs';
import { serve } from './serve-dist.mjs';
import { Plain, build, built, install, main, root } from './setup.mjs';
import { casePictures, webp } from './case-pictures.mjs';
import { ridePicture } from './ride-picture.mjs';
import { viewPictures } from './view-pictures.mjs';

const DESK = { width: 1440, height: 900 };
const PHONE = { width: 390, height: 844 };
/** Pictures live in the repository: a README that loads slowly is not read. */
const LARGEST_KB = 150;
const QUALITY = 0.85;
/** A scene without a change for this long has drawn what it was asked for. */
const QUIET_MS = 400;

/** What each shows. `at` is a time in s; `sample` plays a file instead of a case. */
const PICTURES = {
  'ridden-light': { case: 'ridden', at: 4.3 },
  'ridden-dark': { case: 'ridden', at: 4.3, theme: 'dark' },
  'forces-light': { case: 'ridden', at: 2.05, view: 'side', forces: true },
  'caster-dark': { case: 'ridden', at: 2.05, view: 'caster', forces: true, theme: 'dark' },
  'hanging-light': { case: 'hanging', at: 0.55 },
  'file-light': { sample: 'falling-report', at: 0.22 },
  'phone-light': { case: 'ridden', at: 4.3, size: PHONE },
  'phone-dark': { case: 'ridden', at: 4.3, theme: 'dark', size: PHONE },
};

/** The case that the page opens with. */
const FIRST = 'ridden';

const id = (name) => `[data-testid="${name}"]`;

async function openPage(browser, address, { size = DESK, theme = 'light' }) {
  const context = await browser.newContext({
    viewport: size,
    deviceScaleFactor: 1,
    colorScheme: theme,
    reducedMotion: 'reduce', // the run does not play by itself, so the time is ours
    hasTouch: size === PHONE,
    locale: 'en-US',
    timezoneId: 'UTC',
    bypassCSP: true, // a still picture needs a style sheet of the browser's driver
  });
  const page = await context.newPage();
  page.on('pageerror', (error) => console.error(`page: ${error.message}`));
  await page.addInitScript(() => localStorage.setItem('ripstik.tour', 'seen'));
  await page.goto(address);
  await page.waitForFunction(() => window.ripstikScene !== undefined && window.ripstikScene.stats().bodies > 0);
  return page;
}

/** Puts a case or a sample on the stage and waits until all of it is there. */
async function putOnStage(page, picture) {
  if (picture.sample) {
    await page.click(id('sample-menu'));
    await page.click(id(`sample-${picture.sample}`));
    await page.waitForSelector(id('rows'));
    return;
  }
  await ended(page);
  if (picture.case === FIRST) return;
  await page.click(id('case-menu'));
  await page.click(id(`case-${picture.case}`));
  // The end that is shown may be that of the run before, until the first rows of the new one begin to play.
  await page.waitForFunction((at) => document.querySelector(at).getAttribute('aria-label') !== 'Play', id('play'), {
    timeout: 60_000,
  });
  await ended(page);
}

async function ended(page) {
  await page.waitForSelector(`${id('run-state')}[data-reason]`, { timeout: 60_000 });
}

/** Pauses, seeks, and sets the view as a person would. */
async function setStage(page, { at, view, forces }) {
  await page.keyboard.press('k');
  if (forces) await page.click(id('toggle-forces'));
  await page.locator(id('scrubber')).evaluate((input, time) => {
    input.value = String(time);
    input.dispatchEvent(new Event('input', { bubbles: true }));
  }, at);
  // The camera is placed where the board is now.
  await page.click(id(`view-${view ?? 'orbit'}`));
  await page.mouse.move(0, 0);
  await page.evaluate(() => document.activeElement?.blur());
}

/** Until no frame has been drawn for a while. */
async function drawn(page) {
  await page.evaluate(async (quiet) => {
    const frames = () => window.ripstikScene.stats().frames;
    for (let before = -1; before !== frames();) {
      before = frames();
      await new Promise((done) => setTimeout(done, quiet));
    }
  }, QUIET_MS);
}

async function take(browser, address, name) {
  const picture = PICTURES[name];
  const page = await openPage(browser, address, picture);
  await putOnStage(page, picture);
  await setStage(page, picture);
  await drawn(page);
  const shown = await page.locator(id('scrubber')).inputValue();
  if (Math.abs(Number(shown) - picture.at) > 1e-9)
    throw new Plain(`${name} stands at ${shown} s instead of ${picture.at} s`);
  const bytes = await webp(
    page,
    await page.screenshot({ animations: 'disabled', caret: 'hide' }),
    picture.size ?? DESK,
    QUALITY,
  );
  await page.context().close();
  writeFileSync(join(root, 'docs/pictures', `${name}.webp`), bytes);
  const kb = bytes.length / 1000;
  console.log(`${name}.webp  ${kb.toFixed(0)} kB`);
  return kb < LARGEST_KB;
}

main(async (given) => {
  const many = { cases: casePictures, views: viewPictures, ride: ridePicture }[given[0]];
  const names = many ? [] : given;
  const unknown = names.filter((name) => !(name in PICTURES));
  if (unknown.length)
    throw new Plain(`There is no picture ${unknown.join(', ')}; right would be ${Object.keys(PICTURES).join(', ')}.`);
  await install();
  if (!built() && !(await build())) throw new Plain('The build failed; what is wrong stands above.');
  if (!existsSync(join(root, 'public/data'))) throw new Plain('There are no samples yet: npm run samples');
  const executablePath = (await findBrowser()) || undefined;
  const { chromium } = await import('@playwright/test');
  mkdirSync(join(root, 'docs/pictures'), { recursive: true });
  const { server, port } = await serve({ port: 0, tries: 1 });
  const browser = await chromium.launch({
    executablePath,
    // As in the browser tests: drawn without a GPU, the same from run to run.
    args: [
      '--use-angle=swiftshader',
      '--enable-unsafe-swiftshader',
      '--force-color-profile=srgb',
      '--font-render-hinting=none',
    ],
  });
  let large = 0;
  try {
    if (many) await many(browser, `http://127.0.0.1:${port}/`, given.slice(1));
    else
      for (const name of names.length ? names : Object.keys(PICTURES))
        large += (await take(browser, `http://127.0.0.1:${port}/`, name)) ? 0 : 1;
  } finally {
    await browser.close();
    server.close();
    server.closeAllConnections();
  }
  if (large) console.error(`${large} of them above ${LARGEST_KB} kB`);
  return large ? 1 : 0;
});
