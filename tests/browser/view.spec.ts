import { expect, test, type Page } from '@playwright/test';
import {
  chooseCase,
  differingPixels,
  drawn,
  ended,
  exportCsv,
  measured,
  numberIn,
  openPage,
  pause,
  picture,
  screenBox,
  seek,
  VIEWPORT,
} from './helpers.ts';

test.use({ viewport: VIEWPORT });

const frames = (page: Page): Promise<number> => page.evaluate(() => window.ripstikScene!.stats().frames);

/** The middle of the front plate in the page's pixels. */
async function plate(page: Page): Promise<{ x: number; y: number }> {
  const canvas = (await page.getByTestId('scene').boundingBox())!;
  return page.evaluate(
    ({ left, top }) => {
      const scene = window.ripstikScene!;
      const box = scene.screenBox(1)!;
      // A place that is the plate's and nothing else's.
      for (let k = 1; k < 20; k++)
        for (let j = 1; j < 20; j++) {
          const [x, y] = [box.left + ((box.right - box.left) * k) / 20, box.top + ((box.bottom - box.top) * j) / 20];
          if (scene.pick(x, y)?.body === 1) return { x: left + x, y: top + y };
        }
      throw new Error('the front plate is nowhere to be seen');
    },
    { left: canvas.x, top: canvas.y },
  );
}

test('views, names, axes, the inset and the legend are a press away, and an idle stage draws nothing', async ({
  page,
}) => {
  const watch = await openPage(page);
  await seek(page, 3);
  const plain = await picture(page);

  await page.getByTestId('view-menu').click();
  await expect(page.getByTestId('look-names')).toBeFocused();
  await page.keyboard.press('Space');
  await page.getByTestId('look-frames').check();
  await page.keyboard.press('Escape');
  await expect(page.getByTestId('view-menu')).toBeFocused();
  await drawn(page);
  expect(await differingPixels(page, await picture(page), plain), 'names and axes').toBeGreaterThan(300);
  await page.keyboard.press('n');
  await page.keyboard.press('a');
  await drawn(page);

  await page.keyboard.press('p');
  await expect(page.getByTestId('inset')).toBeVisible();
  await page.getByTestId('toggle-forces').click();
  await expect(page.getByTestId('force-legend')).toContainText('N');
  await drawn(page);
  const calls = await page.evaluate(() => window.ripstikScene!.stats().calls);
  await page.keyboard.press('p');
  await expect(page.getByTestId('inset')).toHaveCount(0);
  await drawn(page);
  expect(
    await page.evaluate(() => window.ripstikScene!.stats().calls),
    'the inset costs nothing when it is off',
  ).toBeLessThan(calls);

  const before = await picture(page);
  await page.keyboard.press('6');
  await expect(page.getByTestId('view-rider')).toHaveAttribute('aria-pressed', 'true');
  await page.waitForTimeout(400);
  expect(await differingPixels(page, await picture(page), before), 'from aboard').toBeGreaterThan(5000);
  await page.keyboard.press('1');
  await page.waitForTimeout(600);

  const idle = await frames(page);
  await page.waitForTimeout(800);
  expect(await frames(page), 'pictures drawn while nothing moves').toBe(idle);
  expect(watch.errors).toEqual([]);
});

test('a detailed look mirrors a room, and every shader of it compiles', async ({ page }) => {
  const watch = await openPage(page);
  await seek(page, 3);
  await pause(page);
  await drawn(page);
  const plain = await picture(page);
  await page.getByTestId('view-menu').click();
  const studio = page.waitForResponse(/\/studio-/);
  await page.getByTestId('look-quality').selectOption('high');
  await page.keyboard.press('Escape');
  await studio;
  const changed = async () => differingPixels(page, await picture(page), plain, await screenBox(page, 0));
  await expect.poll(changed, 'what is lit and mirrored').toBeGreaterThan(300);
  expect(watch.errors).toEqual([]);
});

test('the board stays in the picture when the stage becomes narrow', async ({ page }) => {
  await openPage(page);
  await pause(page);
  for (const size of [
    { width: 1000, height: 760 },
    { width: 800, height: 900 },
  ]) {
    await page.setViewportSize(size);
    await drawn(page);
    const canvas = (await page.getByTestId('scene').boundingBox())!;
    for (const body of [0, 1, 2, 3, 4]) {
      const box = await screenBox(page, body);
      expect(box.left, `body ${body} at ${size.width}`).toBeGreaterThanOrEqual(0);
      expect(box.right, `body ${body} at ${size.width}`).toBeLessThanOrEqual(canvas.width);
    }
  }
});

test('a body is taken hold of with Shift or the switch, pulled, and let go', async ({ page }) => {
  await openPage(page);
  await seek(page, 2);
  const plain = await picture(page);
  const at = await plate(page);
  await page.keyboard.down('Shift');
  await page.mouse.move(at.x, at.y);
  await page.mouse.down();
  await page.mouse.move(at.x + 60, at.y - 70, { steps: 3 });
  await drawn(page);
  expect(await differingPixels(page, await picture(page), plain), 'the pull is drawn').toBeGreaterThan(80);
  await page.mouse.up();
  // A push that misses moves nothing, the camera least.
  const seenFrom = () =>
    page.evaluate(() => {
      const { camera, target } = window.ripstikScene!.placement();
      return camera.map((x, i) => (x - target[i]!).toFixed(6)).join(' ');
    });
  const stood = await seenFrom();
  await page.mouse.move(at.x, at.y + 150);
  await page.mouse.down();
  await page.mouse.move(at.x + 60, at.y + 100, { steps: 2 });
  await page.mouse.up();
  await page.keyboard.up('Shift');
  await drawn(page);
  expect(await seenFrom()).toBe(stood);
  await expect(page.getByTestId('toggle-push')).toBeVisible();
});

test('a balanced board is pushed by hand while it rides, resists, and rides on to the end', async ({ page }) => {
  const watch = await openPage(page);
  await chooseCase(page, 'balanced');
  await ended(page, 2, 'end');
  await page.getByTestId('duration').fill('10');
  await page.getByTestId('duration').press('Enter');
  await ended(page, 3, 'end');
  await pause(page);
  const end = await numberIn(page, 'end-time');
  const unpushed = await exportCsv(page);
  await seek(page, 4);
  const at = await plate(page);
  await page.keyboard.down('Shift');
  await page.mouse.move(at.x, at.y);
  await page.mouse.down();
  await page.mouse.move(at.x + 9, at.y - 8, { steps: 2 });
  // Let go in the page, by the first frame after 4.3 s: how long a hand is on it decides what becomes of the board.
  await page.waitForFunction(() => {
    if (!(parseFloat(document.querySelector('[data-testid=time]')!.textContent!) > 4.3)) return false;
    const canvas = document.querySelector('[data-testid=scene]')!;
    for (let pointerId = 0; pointerId < 8; pointerId++)
      canvas.dispatchEvent(new PointerEvent('pointerup', { pointerId }));
    return true;
  });
  await page.mouse.up();
  await page.keyboard.up('Shift');
  await expect(page.getByTestId('run-state')).toHaveAttribute('data-reason', 'end', { timeout: 20_000 });
  await pause(page);
  expect(await numberIn(page, 'end-time'), 'there is always some time left for it').toBeGreaterThanOrEqual(end);
  for (const name of ['pushed', 'released'])
    await expect(page.locator('.scrub-line').getByRole('button', { name })).toBeVisible();
  const pushed = await exportCsv(page);
  const column = ({ columns, rows }: typeof pushed, name: string) => rows.map((row) => row[columns.indexOf(name)]!);
  const difference = (name: string, from: number, to: number) => {
    const [a, b, t] = [column(pushed, name), column(unpushed, name), column(pushed, 't')];
    return Math.max(...a.map((x, i) => (i < b.length && t[i]! >= from && t[i]! <= to ? Math.abs(x - b[i]!) : 0)));
  };
  const roll = column(pushed, 'alpha').map((alpha, i) => Math.abs(alpha + column(pushed, 'alpha_fp')[i]!));
  measured(
    `the hand moves alpha_fp by ${difference('alpha_fp', 4, end).toExponential(1)} rad; the front plate rolls to ${Math.max(...roll.slice(400)).toExponential(1)} rad and ends at ${roll.at(-1)!.toExponential(1)}`,
  );
  expect(difference('alpha_fp', 0, 3.99), 'what was before the hand stays to the last bit').toBe(0);
  expect(difference('alpha_fp', 4, end), 'the hand moved it').toBeGreaterThan(1e-4);
  expect(roll.at(-1)!, 'the regulator holds it').toBeLessThan(0.01);
  expect(pushed.text).toContain('# pushes: [');
  expect(watch.errors).toEqual([]);
});

test('a mode is shown as motion, and the run comes back as it was', async ({ page }) => {
  const watch = await openPage(page);
  await seek(page, 3);
  const title = await page.locator('.caption-title').innerText();
  await page.getByRole('button', { name: 'Analysis' }).click();
  await expect(page.getByTestId('analysis')).toHaveAttribute('data-state', 'ready', { timeout: 20_000 });
  await page.getByTestId('show-open-0').click();
  await expect(page.locator('.caption-title')).toContainText('Mode');
  const positions = () => page.evaluate(() => window.ripstikScene!.bodyMatrix(1)!.join());
  const first = await positions();
  await expect.poll(positions).not.toBe(first);
  await page.getByTestId('mode-back').click();
  await expect(page.locator('.caption-title')).toHaveText(title);
  await expect(page.getByTestId('time')).toHaveText(/^3\.000/);
  expect(watch.errors).toEqual([]);
});
