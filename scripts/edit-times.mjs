// npm run edit-times: from a key in a field to the first frame of the run that follows, for every number of the board, and
// for a parameter of each case; median and 95th percentile, ms, beside those of a frame in which nothing changed. Printed, not
// asserted: they are those of this machine.
// With parts of names, only those fields of the board: npm run edit-times -- gravity initial.alpha; "cases" for the cases alone,
// and behind it parts of their names for these alone: npm run edit-times -- cases balanced.
/* global window, document, requestAnimationFrame, localStorage, KeyboardEvent, MessageChannel -- functions given to the page run there */
import { findBrowser } from './browser.mjs';
import { serve } from './serve-dist.mjs';
import { build, built, install, main } from './setup.mjs';

const VIEWPORT = { width: 1000, height: 640 };
/** Edits of each field. */
const TIMES = 8;
/** Where the motion stands, s: what follows has to be computed so far. */
const AT = 1;
/** A field that no run follows for so long is left out, ms. */
const LONGEST_MS = 4000;

/** What the page is given once: a wait until what a frame draws has been handed over. A task that begins after it tells. */
function followFrames() {
  const { port1, port2 } = new MessageChannel();
  const waiting = [];
  port1.onmessage = () => waiting.splice(0).forEach((done) => done());
  window.afterFrame = () =>
    new Promise((done) => {
      waiting.push(done);
      requestAnimationFrame(() => port2.postMessage(null));
    });
}

/** Steps a field up and down again; how long each took, or null where no run followed. Runs in the page. */
async function stepField({ path, times, at, longest }) {
  const { state, actions } = window.ripstikApp;
  const frame = window.afterFrame;
  const input = document.querySelector(`[data-path="${path}"]`);
  const waits = [];
  let [known, came] = [state.motion.value.id, null];
  const stop = state.motion.subscribe((motion) => {
    if (motion.id !== known) came = window.ripstikScene.stats().frames;
    known = motion.id;
  });
  for (let k = 0; k < times; k++) {
    actions.pause();
    actions.seek(at);
    for (let i = 0; i < 5; i++) await frame();
    came = null;
    const from = window.performance.now();
    input.dispatchEvent(
      new KeyboardEvent('keydown', { key: k % 2 ? 'ArrowDown' : 'ArrowUp', bubbles: true, cancelable: true }),
    );
    while (came === null || window.ripstikScene.stats().frames <= came) {
      await frame();
      if (window.performance.now() - from > longest) {
        stop();
        return null;
      }
    }
    waits.push(window.performance.now() - from);
    while (state.run.value?.kind === 'computing') await frame();
  }
  stop();
  return waits;
}

/** How long a frame takes in which nothing changed. Runs in the page. */
async function drawAgain(times) {
  const { ripstikScene: scene, performance, afterFrame } = window;
  const waits = [];
  for (let k = 0; k < times; k++) {
    const [from, { frames }] = [performance.now(), scene.stats()];
    scene.requestRender();
    while (scene.stats().frames <= frames) await afterFrame();
    waits.push(performance.now() - from);
  }
  return waits;
}

const rank = (list, share) =>
  [...list].sort((a, b) => a - b)[Math.min(list.length - 1, Math.floor(share * list.length))];

function print(name, waits) {
  const figures = waits
    ? `${rank(waits, 0.5).toFixed(0).padStart(6)} ${rank(waits, 0.95).toFixed(0).padStart(6)}`
    : '     –      –';
  console.log(`${name.padEnd(44)} ${figures}`);
}

async function open(browser, address, id) {
  const page = await browser.newPage({ viewport: VIEWPORT, reducedMotion: 'reduce', locale: 'en-US' });
  await page.addInitScript(() => localStorage.setItem('ripstik.tour', 'seen'));
  await page.addInitScript(followFrames);
  await page.goto(address);
  await page.waitForFunction(() => window.ripstikScene?.stats().bodies > 0);
  await page.evaluate((name) => window.ripstikApp.actions.loadCase(name), id);
  await page.waitForFunction(
    () => document.querySelector('[data-path^="parameters."]') && window.ripstikApp.state.run.value?.kind === 'ended',
  );
  return page;
}

const stepped = (page, path) => page.evaluate(stepField, { path, times: TIMES, at: AT, longest: LONGEST_MS });
const paths = (page) =>
  page.evaluate(() =>
    [...document.querySelectorAll('.experiment .box [data-path]')].map((input) => input.dataset.path),
  );

main(async (wanted) => {
  await install();
  if (!built()) await build();
  const { chromium } = await import('@playwright/test');
  const executablePath = await findBrowser();
  const browser = await chromium.launch({
    ...(executablePath ? { executablePath } : {}),
    args: ['--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
  });
  const { server, port } = await serve({ port: 0 });
  const address = `http://127.0.0.1:${port}/`;
  const onlyCases = wanted[0] === 'cases';
  const wantedCases = onlyCases ? wanted.slice(1) : [];
  try {
    if (!onlyCases) console.log(`${'field of the ridden board'.padEnd(44)} median    p95, ms`);
    const board = await open(browser, address, 'ridden');
    if (!onlyCases) print('a frame in which nothing changed', await board.evaluate(drawAgain, 40));
    const all = [];
    const fields = onlyCases ? [] : (await paths(board)).filter((one) => !/^(inputs|control\.reference)\./.test(one));
    for (const path of fields.filter((one) => wanted.length === 0 || wanted.some((part) => one.includes(part)))) {
      const waits = await stepped(board, path);
      all.push(...(waits ?? []));
      print(path, waits);
    }
    if (!onlyCases) print('all of them', all);
    const cases = await board.evaluate(() => window.ripstikApp.cases.map(({ id }) => id));
    await board.close();
    if (wanted.length > 0 && !onlyCases) return 0;
    console.log(`\n${'first parameter of the case'.padEnd(44)} median    p95, ms`);
    for (const id of cases.filter(
      (one) => wantedCases.length === 0 || wantedCases.some((part) => one.includes(part)),
    )) {
      const page = await open(browser, address, id);
      const [path] = (await paths(page)).filter((one) => one.startsWith('parameters.'));
      print(id, path ? await stepped(page, path) : null);
      await page.close();
    }
  } finally {
    await browser.close();
    server.close();
  }
  return 0;
});
