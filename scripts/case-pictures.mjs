// npm run pictures -- cases [id …]: the scene of every case at a telling moment, as docs/cases/<id>.webp and, small, in
// both themes, as public/cases/<id>-<theme>.webp for the gallery; beside it <id>-<theme>-loop.webp, what happens about that
// moment as a strip of frames, which the gallery plays.
/* global window, document, setTimeout, Image, WheelEvent -- functions given to the page run there */
import { Buffer } from 'node:buffer';
import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { root } from './setup.mjs';

const SIZE = { width: 640, height: 400 };
const CARD = { width: 360, height: 225 };
/** One below the other: the gallery's style sheet names their number too. */
const LOOP = { width: 224, height: 140, frames: 16, seconds: 2.4 };
const QUALITY = { full: 0.8, card: 0.66, loop: 0.4 };
/** What the orbit controls make of a wheel's 100 pixels. */
const ZOOM_STEP = 0.95;
const QUIET_MS = 300;

/** The scene alone fills the page. */
const SCENE_ONLY = `
  .stage { position: fixed !important; inset: 0; z-index: 1000; }
  .stage > :not(canvas) { display: none !important; }
  .messages, .tour, .offer { display: none !important; }`;

export async function casePictures(browser, address, wanted) {
  mkdirSync(join(root, 'public/cases'), { recursive: true });
  for (const theme of ['light', 'dark']) {
    const context = await browser.newContext({
      viewport: SIZE,
      colorScheme: theme,
      reducedMotion: 'reduce',
      locale: 'en-US',
      timezoneId: 'UTC',
      bypassCSP: true,
    });
    const page = await context.newPage();
    page.on('pageerror', (error) => console.error(`page: ${error.message}`));
    await page.goto(address);
    await page.waitForFunction(() => window.ripstikScene?.stats().bodies > 0);
    await page.addStyleTag({ content: SCENE_ONLY });
    const all = await page.evaluate(() =>
      window.ripstikApp.cases.map(({ id, picture = {}, figures = [] }) => ({ id, picture, figures })),
    );
    for (const { id, picture, figures } of all.filter((c) => wanted.length === 0 || wanted.includes(c.id))) {
      await runCase(page, id);
      const png = await shoot(page, picture);
      if (theme === 'light') save('docs/cases', id, await webp(page, png, SIZE, QUALITY.full));
      save('public/cases', `${id}-${theme}`, await webp(page, png, CARD, QUALITY.card));
      save('public/cases', `${id}-${theme}-loop`, await loop(page, picture));
      if (theme === 'light') {
        for (const [i, figure] of figures.entries())
          save('docs/cases', `${id}-${i + 1}`, await webp(page, await shoot(page, figure), SIZE, QUALITY.full));
      }
      console.log(`${id} ${theme}`);
    }
    await context.close();
  }
}

const save = (folder, name, bytes) => writeFileSync(join(root, folder, `${name}.webp`), bytes);

async function runCase(page, id) {
  await page.evaluate(async (which) => {
    const { state, actions } = window.ripstikApp;
    actions.loadCase(which);
    const met = () =>
      state.origin.value.id === which &&
      state.run.value?.kind === 'ended' &&
      state.motion.value?.written === state.draft.value;
    while (!met()) await new Promise((done) => setTimeout(done, 30));
    actions.pause();
    actions.seek(state.motion.value.trajectory.start);
  }, id);
  // A view fits the bodies as they stand at first: they have to be there.
  await quiet(page);
}

/** A picture of the scene as a PNG; `time`, `view` and `distance` as a case has them. */
async function shoot(page, { time, view = 'orbit', distance = 1 }) {
  await page.evaluate(
    ([at, name]) => {
      const { state, actions } = window.ripstikApp;
      actions.seek(at ?? 0.4 * state.motion.value.trajectory.end);
      // A view looks at the subject where it is when it is chosen.
      actions.set('view', name === 'side' ? 'front' : 'side');
      actions.set('view', name);
    },
    [time, view],
  );
  const steps = Math.log(distance) / -Math.log(ZOOM_STEP);
  await page
    .locator('[data-testid="scene"]')
    .evaluate(
      (canvas, deltaY) => canvas.dispatchEvent(new WheelEvent('wheel', { deltaY, bubbles: true, cancelable: true })),
      100 * steps,
    );
  await quiet(page);
  return page.screenshot({ animations: 'disabled' });
}

/** What happens about a picture's moment, seen as it was: frames one below the other, as WebP. */
async function loop(page, { time }) {
  const url = await page.evaluate(
    ([at, { width, height, frames, seconds }, quality]) => {
      const { state, actions } = window.ripstikApp;
      const { start, end } = state.motion.value.trajectory;
      const long = Math.min(seconds, end - start);
      const from = Math.min(Math.max((at ?? 0.4 * end) - long / 2, start), end - long);
      const strip = Object.assign(document.createElement('canvas'), { width, height: height * frames });
      const context = strip.getContext('2d');
      context.imageSmoothingQuality = 'high';
      const canvas = document.querySelector('[data-testid="scene"]');
      for (let k = 0; k < frames; k++) {
        actions.seek(from + (long * k) / (frames - 1));
        // Paths have been followed to their ends by now: nothing is waited for.
        window.ripstikScene.draw();
        context.drawImage(canvas, 0, k * height, width, height);
      }
      return strip.toDataURL('image/webp', quality);
    },
    [time, LOOP, QUALITY.loop],
  );
  return Buffer.from(url.split(',')[1], 'base64');
}

/** Until no frame has been drawn for a while, and the meshes are those of the case. */
async function quiet(page) {
  await page.evaluate(async (still) => {
    const frames = () => window.ripstikScene.stats().frames;
    for (let before = -1; before !== frames();) {
      before = frames();
      await new Promise((done) => setTimeout(done, still));
    }
  }, QUIET_MS);
}

/** A PNG as WebP of this size, made by the browser. */
export async function webp(page, png, { width, height }, quality) {
  const url = await page.evaluate(
    async ([source, w, h, share]) => {
      const image = new Image();
      image.src = source;
      await image.decode();
      const canvas = Object.assign(document.createElement('canvas'), { width: w, height: h });
      const context = canvas.getContext('2d');
      context.imageSmoothingQuality = 'high';
      context.drawImage(image, 0, 0, w, h);
      return canvas.toDataURL('image/webp', share);
    },
    [`data:image/png;base64,${png.toString('base64')}`, width, height, quality],
  );
  return Buffer.from(url.split(',')[1], 'base64');
}
