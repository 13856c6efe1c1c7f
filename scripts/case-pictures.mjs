// npm run pictures -- cases [id …]: the scene of every case at a telling moment, as docs/cases/<id>.webp and, small, in
// both themes, as public/cases/<id>-<theme>.webp for the gallery.
/* global window, document, setTimeout, Image -- functions given to the page run there */
import { Buffer } from 'node:buffer';
import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { root } from './setup.mjs';

const SIZE = { width: 640, height: 400 };
const CARD = { width: 320, height: 200 };
const QUALITY = 0.8;
const QUIET_MS = 300;

/** The scene alone fills the page. */
const SCENE_ONLY = `
  .stage { position: fixed !important; inset: 0; z-index: 1000; }
  .stage > :not(canvas) { display: none !important; }
  .messages, .tour, .first-minute { display: none !important; }`;

export async function casePictures(browser, address, wanted) {
  mkdirSync(join(root, 'public/cases'), { recursive: true });
  for (const theme of ['light', 'dark']) {
    const context = await browser.newContext({ viewport: SIZE, colorScheme: theme, reducedMotion: 'reduce', locale: 'en-US', timezoneId: 'UTC' });
    const page = await context.newPage();
    page.on('pageerror', (error) => console.error(`page: ${error.message}`));
    await page.goto(address);
    await page.waitForFunction(() => window.ripstikScene?.stats().bodies > 0);
    await page.addStyleTag({ content: SCENE_ONLY });
    const all = await page.evaluate(() => window.ripstikApp.cases.map(({ id: name, picture }) => ({ name, picture })));
    for (const { name, picture } of all.filter((c) => wanted.length === 0 || wanted.includes(c.name))) {
      await page.evaluate(async ([which, { share, view }]) => {
        const { state, actions } = window.ripstikApp;
        actions.loadCase(which);
        const until = async (met) => {
          while (!met()) await new Promise((done) => setTimeout(done, 30));
        };
        await until(() => state.origin.value.id === which && state.run.value?.kind === 'ended' && state.motion.value?.written === state.draft.value);
        actions.pause();
        actions.seek(state.motion.value.trajectory.start);
        state.view.value = view;
        // A view looks at the subject where it is.
        actions.seek(share * state.motion.value.trajectory.end);
        state.view.value = view === 'side' ? 'front' : 'side';
        state.view.value = view;
      }, [name, { share: 0.4, view: 'orbit', ...picture }]);
      await quiet(page);
      const png = await page.screenshot({ animations: 'disabled' });
      if (theme === 'light') writeFileSync(join(root, 'docs/cases', `${name}.webp`), await webp(page, png, SIZE));
      writeFileSync(join(root, 'public/cases', `${name}-${theme}.webp`), await webp(page, png, CARD));
      console.log(`${name} ${theme}`);
    }
    await context.close();
  }
}

/** Until no frame has been drawn for a while, and the meshes are those of the case. */
async function quiet(page) {
  await page.evaluate(async (still) => {
    const frames = () => window.ripstikScene.stats().frames;
    for (let before = -1; before !== frames(); ) {
      before = frames();
      await new Promise((done) => setTimeout(done, still));
    }
  }, QUIET_MS);
}

async function webp(page, png, { width, height }) {
  const url = await page.evaluate(async ([source, w, h, quality]) => {
    const image = new Image();
    image.src = source;
    await image.decode();
    const canvas = Object.assign(document.createElement('canvas'), { width: w, height: h });
    const context = canvas.getContext('2d');
    context.imageSmoothingQuality = 'high';
    context.drawImage(image, 0, 0, w, h);
    return canvas.toDataURL('image/webp', quality);
  }, [`data:image/png;base64,${png.toString('base64')}`, width, height, QUALITY]);
  return Buffer.from(url.split(',')[1], 'base64');
}
