/** What leaves the page: pictures, videos and 3-D files of the run, read back without the program's own code. */
import { readFileSync } from 'node:fs';
import { expect, test, type Page } from '@playwright/test';
import { ALL_FORMATS, BufferSource, EncodedPacketSink, Input } from 'mediabunny';
import { ripstikMeta } from '../../core/systems/ripstik/meta.ts';
import { readGlb, validateGlb } from '../../../tests/browser/glb.ts';
import {
  COORDINATES,
  csvOf,
  differingPixels,
  drawn,
  drop,
  exportCsv,
  measured,
  openPage,
  picture,
  posesOf,
  seek,
  VIEWPORT,
  type Row,
} from '../../../tests/browser/helpers.ts';

test.use({ viewport: VIEWPORT });

async function openDialog(page: Page, tab: string): Promise<void> {
  await page.getByTestId('export-menu').click();
  await page.getByTestId('export-more').click();
  await page.getByTestId(`export-tab-${tab}`).click();
}

async function fill(page: Page, field: string, value: number): Promise<void> {
  await page.getByTestId(field).fill(String(value));
  await page.getByTestId(field).press('Tab');
}

async function ownSize(page: Page, prefix: string): Promise<void> {
  await page.getByTestId(`${prefix}-size`).selectOption('-1');
  await fill(page, `${prefix}-width`, 160);
  await fill(page, `${prefix}-height`, 90);
}

async function save(page: Page, button: string): Promise<{ name: string; bytes: Buffer }> {
  const [file] = await Promise.all([page.waitForEvent('download'), page.getByTestId(button).click()]);
  return { name: file.suggestedFilename(), bytes: readFileSync(await file.path()) };
}

/** Width, height, opacity of the first pixel, and how many colours a PNG has. */
const look = (page: Page, png: Buffer) =>
  page.evaluate(async (base64) => {
    const image = await createImageBitmap(
      new Blob([Uint8Array.from(atob(base64), (c) => c.charCodeAt(0))], { type: 'image/png' }),
    );
    const context = new OffscreenCanvas(image.width, image.height).getContext('2d')!;
    context.drawImage(image, 0, 0);
    const { data } = context.getImageData(0, 0, image.width, image.height);
    return {
      width: image.width,
      height: image.height,
      corner: data[3]!,
      colours: new Set(new Uint32Array(data.buffer)).size,
    };
  }, png.toString('base64'));

/** A video's packets in Node, its frames by the browser's own decoder: moments (µs) and the pixels that differ between the first frame and the last. */
async function decode(page: Page, bytes: Buffer) {
  const input = new Input({ formats: ALL_FORMATS, source: new BufferSource(bytes) });
  const track = (await input.getPrimaryVideoTrack())!;
  const config = (await track.getDecoderConfig())!;
  const packets: { type: 'key' | 'delta'; timestamp: number; data: string }[] = [];
  for await (const { type, timestamp, data } of new EncodedPacketSink(track).packets())
    packets.push({ type, timestamp: Math.round(1e6 * timestamp), data: Buffer.from(data).toString('base64') });
  const description = config.description ? Buffer.from(config.description as Uint8Array).toString('base64') : null;
  const frames = await page.evaluate(
    async ({ codec, description, packets }) => {
      const plain = (text: string) => Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
      const pictures: { timestamp: number; data: Uint8ClampedArray; width: number; height: number }[] = [];
      const decoder = new VideoDecoder({
        output: (frame) => {
          const { displayWidth: width, displayHeight: height, timestamp } = frame;
          const context = new OffscreenCanvas(width, height).getContext('2d')!;
          context.drawImage(frame, 0, 0);
          pictures.push({ timestamp, width, height, data: context.getImageData(0, 0, width, height).data });
          frame.close();
        },
        error: (error) => {
          throw error;
        },
      });
      decoder.configure({ codec, ...(description ? { description: plain(description) } : {}) });
      for (const { type, timestamp, data } of packets)
        decoder.decode(new EncodedVideoChunk({ type, timestamp, data: plain(data) }));
      await decoder.flush();
      const [first, last] = [pictures[0]!, pictures.at(-1)!];
      let differing = 0;
      for (let o = 0; o < first.data.length; o += 4)
        if ([0, 1, 2].some((c) => Math.abs(first.data[o + c]! - last.data[o + c]!) > 40)) differing++;
      return { times: pictures.map((p) => p.timestamp), width: first.width, height: first.height, differing };
    },
    { codec: config.codec, description, packets },
  );
  return { ...frames, duration: await input.computeDuration() };
}

test('pictures at a chosen size; the page’s own view stays as it is', async ({ page }) => {
  const watch = await openPage(page);
  await seek(page, 2);
  const before = await picture(page);
  await openDialog(page, 'picture');
  await ownSize(page, 'png');
  const opaque = await save(page, 'save-png');
  expect(opaque.name).toMatch(/^[a-z0-9-]+\.png$/);
  expect(await look(page, opaque.bytes)).toMatchObject({ width: 160, height: 90, corner: 255 });
  await page.getByTestId('png-background').selectOption('transparent');
  await page.getByTestId('png-fine').uncheck();
  const clear = await look(page, (await save(page, 'save-png')).bytes);
  expect(clear.corner).toBe(0);
  expect(clear.colours).toBeGreaterThan(50);
  await page.keyboard.press('Escape');
  await expect(page.getByTestId('export-dialog')).toBeHidden();
  await page.evaluate(() => window.ripstikScene!.requestRender());
  await drawn(page);
  expect(
    await differingPixels(page, before, await picture(page), { left: 250, top: 60, right: 500, bottom: 200 }),
  ).toBe(0);
  expect(watch.errors).toEqual([]);
  expect(await page.evaluate(() => window.cspViolations)).toEqual([]);
});

test('a video has the frames and the duration asked for, and moves as the run does', async ({ page }) => {
  const watch = await openPage(page);
  await openDialog(page, 'video');
  await ownSize(page, 'video');
  await fill(page, 'export-from', 1);
  await fill(page, 'export-to', 2);
  await page.getByTestId('video-fps').selectOption('24');
  await page.getByTestId('video-speed').selectOption('2');
  await page.getByTestId('video-follow').uncheck();
  await page.getByTestId('video-caption').uncheck();
  await expect(page.getByTestId('video-facts')).toContainText('12 frames, 0.50 s');
  const moving = await decode(page, (await save(page, 'save-video')).bytes);
  expect(moving).toMatchObject({ width: 160, height: 90 });
  expect(moving.times).toHaveLength(12);
  // WebM counts milliseconds.
  moving.times.forEach((time, k) => expect(Math.abs(time - (1e6 * k) / 24)).toBeLessThanOrEqual(1000));
  expect(moving.duration).toBeCloseTo(0.5, 2);
  expect(moving.differing).toBeGreaterThan(50);

  // A long one is cancelled; nothing is saved.
  await fill(page, 'export-from', 0);
  await page.getByTestId('video-fps').selectOption('60');
  await page.getByTestId('video-speed').selectOption('0.015625');
  const none = page.waitForEvent('download', { timeout: 1500 }).then(
    () => true,
    () => false,
  );
  await page.getByTestId('save-video').click();
  await expect(page.getByTestId('export-progress')).toContainText(/[1-9]\d* of 7680 frames/);
  await page.getByTestId('export-cancel').click();
  await expect(page.getByTestId('export-progress')).toBeHidden();
  expect(await none).toBe(false);
  await page.keyboard.press('Escape');

  // Nothing moves in this file, nor in its video; what was chosen is remembered.
  const rows = [0, 0.25, 0.5].map((t): Row => ({
    t,
    ...Object.fromEntries(COORDINATES.map((name) => [name, name === 'Z' ? 0.1 : 0])),
  }));
  await drop(page, 'still.csv', csvOf(rows, ['t', ...COORDINATES]));
  await expect(page.getByTestId('time')).toContainText('0.000');
  await expect.poll(() => page.evaluate(() => window.ripstikScene!.bodyPosition(0)![2])).toBeCloseTo(0.1, 6);
  await page.getByTestId('export-menu').click();
  await page.getByTestId('export-more').click();
  await page.getByTestId('video-fps').selectOption('24');
  await page.getByTestId('video-speed').selectOption('1');
  await expect(page.getByTestId('video-width')).toHaveValue('160');
  const still = await decode(page, (await save(page, 'save-video')).bytes);
  expect(still.times).toHaveLength(12);
  expect(still.differing).toBe(0);
  expect(watch.errors).toEqual([]);
});

test('without WebCodecs the browser’s own recorder makes the video: as long as asked for, and its frames move', async ({
  page,
}) => {
  const watch = await openPage(page, () => Reflect.deleteProperty(window, 'VideoEncoder'));
  await openDialog(page, 'video');
  await ownSize(page, 'video');
  await fill(page, 'export-from', 1);
  await fill(page, 'export-to', 2);
  await page.getByTestId('video-fps').selectOption('24');
  await page.getByTestId('video-speed').selectOption('1');
  await page.getByTestId('video-follow').uncheck();
  await expect(page.getByTestId('video-codec')).toContainText('no video encoder for pages');
  const { name, bytes } = await save(page, 'save-video');
  expect(name).toMatch(/\.(webm|mp4)$/);
  const recorded = await decode(page, bytes);
  measured(
    `the browser’s recorder: ${name.split('.').at(-1)}, ${recorded.times.length} of 24 frames, ${recorded.duration.toFixed(3)} s`,
  );
  expect(recorded).toMatchObject({ width: 160, height: 90 });
  expect(recorded.times.length).toBeGreaterThan(1);
  expect(recorded.times.length).toBeLessThanOrEqual(24);
  if (recorded.times.length === 24) {
    recorded.times.forEach((time, k) => expect(Math.abs(time - (1e6 * k) / 24)).toBeLessThanOrEqual(1000));
    expect(recorded.duration).toBeCloseTo(1, 2);
  }
  expect(recorded.times[0]).toBe(0);
  expect(recorded.duration).toBeGreaterThan(0.99);
  expect(recorded.differing).toBeGreaterThan(50);
  expect(watch.errors).toEqual([]);
});

test('the GLB validates and its keyframes are the run’s rows', async ({ page }) => {
  const watch = await openPage(page);
  const { columns, rows } = await exportCsv(page);
  await openDialog(page, 'glb');
  await fill(page, 'export-to', 3);
  const { bytes } = await save(page, 'save-glb');
  const { issues } = await validateGlb(bytes);
  expect(issues.messages.filter(({ severity }) => severity < 2)).toEqual([]);
  const { json, track } = readGlb(bytes);
  expect(json.asset.extras.scenario).toMatchObject({ system: 'ripstik' });
  const moving = [...new Set(json.animations[0]!.channels.map(({ target }) => json.nodes[target.node]!.name))].filter(
    (name) => !name.endsWith('-wheel'),
  );
  // The board's bodies, and then somebody who stands on it.
  expect(moving.slice(0, 6)).toEqual([...ripstikMeta.bodies.map(({ id }) => id), 'rider']);
  const used = rows.filter((row) => row[0]! <= 3);
  const tracks = moving.map((name) => [track(name, 'translation')!, track(name, 'rotation')!] as const);
  for (const pair of tracks) for (const { times } of pair) expect(times).toHaveLength(used.length);
  let largest = 0;
  used.forEach((row, k) => {
    const poses = posesOf(Object.fromEntries(columns.map((name, i) => [name, row[i]!])));
    poses.forEach((pose, body) => {
      const [position, turn] = tracks[body]!;
      const [x, y, z, w] = turn.values.subarray(4 * k, 4 * k + 4) as unknown as [number, number, number, number];
      const read = [
        ...position.values.subarray(3 * k, 3 * k + 3),
        1 - 2 * (y * y + z * z),
        2 * (x * y - w * z),
        2 * (x * z + w * y),
        2 * (x * y + w * z),
        1 - 2 * (x * x + z * z),
        2 * (y * z - w * x),
        2 * (x * z - w * y),
        2 * (y * z + w * x),
        1 - 2 * (x * x + y * y),
      ];
      read.forEach(
        (value, i) => (largest = Math.max(largest, Math.abs(value - pose[i]!) / Math.max(1, Math.abs(pose[i]!)))),
      );
    });
  });
  expect(largest).toBeLessThan(1e-6);
  expect(watch.errors).toEqual([]);
});
