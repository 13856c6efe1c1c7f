// npm run pictures -- ride: a short film of a scripted ride, docs/pictures/ride.webp, drawn by the page frame by frame.
/* global window, document, localStorage, Event, HTMLCanvasElement -- functions given to the page run there */
import { Buffer } from 'node:buffer';
import { mkdtempSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { Plain, root } from './setup.mjs';

/** The ride: pushed off, a turn to each side with hips and shoulders ahead, a crouch, pumped. */
const RIDE = {
  version: 1,
  system: 'ripstik-rider',
  parameters: { wheelDrag: 0.5 },
  initial: { beta: '1 deg' },
  release: ['crouch', 'twist'],
  control: {
    type: 'ride',
    commands: [
      [0.1, 'start'],
      [3, 'left', 0.8],
      [5, 'right', 0.8],
      [8, 'straight'],
      [8.2, 'crouch', 0.8],
      [9.2, 'crouch', 0],
      [9.4, 'pump'],
    ],
  },
  method: { rtol: 1e-6, atol: 1e-8 },
  duration: 11,
};
const SIZE = { width: 420, height: 320 };
const [FROM, UNTIL, STEP] = [2.6, 10.8, 0.2];
/** Between frames as they are shown, ms: a little faster than it was. */
const SHOWN_MS = 100;
const QUALITY = 0.45;
const LARGEST_KB = 400;

const id = (name) => `[data-testid="${name}"]`;

export async function ridePicture(browser, address) {
  const context = await browser.newContext({
    viewport: { width: 1000, height: 700 },
    reducedMotion: 'reduce',
    locale: 'en-US',
  });
  const page = await context.newPage();
  await page.addInitScript(() => localStorage.setItem('ripstik.tour', 'seen'));
  await page.goto(address);
  await page.waitForFunction(() => window.ripstikScene?.stats().bodies > 0);
  const file = join(mkdtempSync(join(tmpdir(), 'ride-')), 'ride.json');
  writeFileSync(file, JSON.stringify(RIDE));
  await page.locator('input[type=file]').first().setInputFiles(file);
  await page.waitForFunction(
    ([end, until]) => parseFloat(document.querySelector(end).textContent) === until,
    [id('end-time'), RIDE.duration],
    { timeout: 60_000 },
  );
  await page.keyboard.press('k');
  await page.click(id('view-orbit'));
  const frames = [];
  for (let t = FROM; t <= UNTIL; t += STEP) frames.push(await frameAt(page, t));
  await context.close();
  const bytes = film(frames);
  writeFileSync(join(root, 'docs/pictures/ride.webp'), bytes);
  const kb = bytes.length / 1000;
  console.log(`ride.webp  ${kb.toFixed(0)} kB, ${frames.length} frames`);
  if (kb > LARGEST_KB) throw new Plain(`the film is larger than ${LARGEST_KB} kB: fewer frames, or a lower quality`);
}

/** One frame as a WebP picture, its middle cut out of the scene. */
async function frameAt(page, time) {
  const url = await page.evaluate(
    ([scrubber, t, { width, height }, quality]) => {
      const input = document.querySelector(scrubber);
      input.value = String(t);
      input.dispatchEvent(new Event('input', { bubbles: true }));
      window.ripstikScene.draw();
      const scene = [...document.querySelectorAll('canvas')].find(
        (one) => one instanceof HTMLCanvasElement && one.getContext('webgl2'),
      );
      const scale = Math.min(scene.width / width, scene.height / height);
      const [w, h] = [width * scale, height * scale];
      const canvas = Object.assign(document.createElement('canvas'), { width, height });
      const context = canvas.getContext('2d');
      context.imageSmoothingQuality = 'high';
      context.drawImage(scene, (scene.width - w) / 2, (scene.height - h) / 2, w, h, 0, 0, width, height);
      return canvas.toDataURL('image/webp', quality);
    },
    [id('scrubber'), time, SIZE, QUALITY],
  );
  return Buffer.from(url.split(',')[1], 'base64');
}

const u24 = (x) => Buffer.from([x & 255, (x >> 8) & 255, (x >> 16) & 255]);

function chunk(name, ...parts) {
  const data = Buffer.concat(parts);
  const head = Buffer.alloc(8);
  head.write(name, 'latin1');
  head.writeUInt32LE(data.length, 4);
  return Buffer.concat([head, data, Buffer.alloc(data.length % 2)]);
}

/** The chunks of a still picture that hold its pixels: all but the header of an extended one. */
function pixelsOf(still) {
  const kept = [];
  for (let at = 12; at + 8 <= still.length;) {
    const size = still.readUInt32LE(at + 4);
    const end = at + 8 + size + (size % 2);
    const name = still.toString('latin1', at, at + 4);
    if (name === 'VP8 ' || name === 'VP8L' || name === 'ALPH') kept.push(still.subarray(at, end));
    at = end;
  }
  return Buffer.concat(kept);
}

/** Stills as an animation that goes on for ever (WebP container specification: VP8X, ANIM, an ANMF for each frame). */
function film(stills) {
  const size = Buffer.concat([u24(SIZE.width - 1), u24(SIZE.height - 1)]);
  const frames = stills.map((still) =>
    chunk('ANMF', u24(0), u24(0), size, u24(SHOWN_MS), Buffer.from([2]), pixelsOf(still)),
  );
  const body = Buffer.concat([
    Buffer.from('WEBP', 'latin1'),
    chunk('VP8X', Buffer.from([2, 0, 0, 0]), size),
    chunk('ANIM', Buffer.alloc(4), Buffer.alloc(2)),
    ...frames,
  ]);
  const head = Buffer.alloc(8);
  head.write('RIFF', 'latin1');
  head.writeUInt32LE(body.length, 4);
  return Buffer.concat([head, body]);
}
