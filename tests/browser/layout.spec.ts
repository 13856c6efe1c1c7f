// What lies over the scene never overlaps, at four sizes; a phone shows scene, caption, playback and four fields at once.
import { expect, test, type Page } from '@playwright/test';
import { openWithoutScene } from './helpers.ts';

const SIZES = [
  { width: 1440, height: 900 },
  { width: 1024, height: 768 },
  { width: 820, height: 1180 },
  { width: 390, height: 844 },
];

/** Pairs over the scene that overlap, and what reaches beyond it. */
const overlaps = (page: Page): Promise<string[]> =>
  page.evaluate(() => {
    const stage = document.querySelector('.stage')!.getBoundingClientRect();
    const parts = [...document.querySelectorAll('.caption, .inset, .force-legend, .views > *')]
      .map((element) => ({ name: element.className, box: element.getBoundingClientRect() }))
      .filter(({ box }) => box.width > 0 && box.height > 0);
    const beyond = parts
      .filter(
        ({ box }) =>
          box.left < stage.left - 1 ||
          box.right > stage.right + 1 ||
          box.top < stage.top - 1 ||
          box.bottom > stage.bottom + 1,
      )
      .map(({ name }) => `${name} leaves the stage`);
    const over = parts.flatMap(({ name, box: a }, i) =>
      parts
        .slice(i + 1)
        .filter(
          ({ box: b }) => a.left < b.right - 1 && b.left < a.right - 1 && a.top < b.bottom - 1 && b.top < a.bottom - 1,
        )
        .map((other) => `${name} over ${other.name}`),
    );
    return [...beyond, ...over];
  });

test('caption, inset, legend and buttons keep apart at four sizes; a phone shows four fields', async ({ page }) => {
  await openWithoutScene(page);
  await page.evaluate(() => {
    const { actions } = (window as unknown as { ripstikApp: { actions: Record<string, (...all: unknown[]) => void> } })
      .ripstikApp;
    actions.loadCase!('falling-report'); // the longest caption
    actions.set!('showInset', true);
    actions.set!('showForces', true);
  });
  await expect(page.locator('.caption-title')).toContainText('Falling board');
  for (const size of SIZES) {
    await page.setViewportSize(size);
    await expect.poll(() => overlaps(page), `${size.width} × ${size.height}`).toEqual([]);
  }
  for (const part of ['.caption-title', '.transport']) await expect(page.locator(part)).toBeInViewport({ ratio: 0.99 });
  expect((await page.locator('.stage').boundingBox())!.height).toBeGreaterThan(240);
  await page
    .locator('.start-row')
    .first()
    .evaluate((row) => row.scrollIntoView({ block: 'start' }));
  const fields = await page.locator('.sheet').evaluate((sheet) => {
    const view = sheet.querySelector('.scroll')!.getBoundingClientRect();
    return [...sheet.querySelectorAll('input, select')]
      .map((field) => field.getBoundingClientRect())
      .filter(({ top, bottom, height }) => height > 0 && top >= view.top && bottom <= view.bottom + 1).length;
  });
  expect(fields, 'fields seen at once').toBeGreaterThanOrEqual(4);
});
