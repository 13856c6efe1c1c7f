import { expect, test, type Page } from '@playwright/test';
import { systemViews } from '../../src/core/systems/registry.ts';
import { LIMBS } from '../../src/core/systems/ripstik-rider/figure.ts';
import { differingPixels, drawn, ended, openPage, pause, picture, seek, type, VIEWPORT } from './helpers.ts';

test.use({ viewport: VIEWPORT });

const matrices = (page: Page, count: number): Promise<number[][]> =>
  page.evaluate((n) => Array.from({ length: n }, (_, i) => window.ripstikScene!.bodyMatrix(i)!), count);

/** Pieces on the stage; the board's first case has somebody on it. */
function drawnOf(id: string): number {
  return systemViews[id]!.meta.bodies.length + (id === 'ripstik-rider' ? LIMBS.length : 0);
}

test('every system runs in the page, and its bodies are drawn and move', async ({ page }) => {
  const watch = await openPage(page);
  let run = 1;
  for (const { meta, contacts } of Object.values(systemViews)) {
    if (meta.id !== 'ripstik') {
      await page.getByTestId('system').selectOption(meta.id);
      await ended(page, ++run, 'end');
      await expect(page.getByTestId(`initial-${meta.coordinates[0]!.name}`), meta.title).toBeVisible();
    }
    await expect
      .poll(() => page.evaluate(() => window.ripstikScene!.stats().bodies), `bodies of ${meta.title}`)
      .toBe(drawnOf(meta.id === 'ripstik' ? 'ripstik-rider' : meta.id));
    await seek(page, 0);
    const [first, before] = [await matrices(page, meta.bodies.length), await picture(page)];
    const empty = await page.evaluate(
      (n) => Array.from({ length: n }, (_, i) => i).filter((i) => !window.ripstikScene!.screenBox(i)),
      meta.bodies.length,
    );
    expect(empty, `bodies of ${meta.title} out of sight`).toEqual([]);
    await seek(page, 0.1);
    const later = await matrices(page, meta.bodies.length);
    const moved = later.filter((m, i) => m.some((x, k) => Math.abs(x - first[i]![k]!) > 1e-4)).length;
    expect(moved, `bodies of ${meta.title} that move`).toBeGreaterThan(0);
    expect(await differingPixels(page, before, await picture(page)), `picture of ${meta.title}`).toBeGreaterThan(0);
    await expect(page.getByTestId('toggle-forces')).toHaveCount(contacts.length > 0 ? 1 : 0);
    await expect(page.getByTestId('view-caster')).toHaveCount(meta.id.startsWith('ripstik') ? 1 : 0);
  }
  expect(watch.errors).toEqual([]);
});

test('another system takes nothing of what was edited of the one before', async ({ page }) => {
  await openPage(page);
  const other = Object.keys(systemViews).find((id) => !id.startsWith('ripstik'))!;
  await type(page, 'duration', '1.25');
  await page.getByTestId('view-caster').click();
  await page.getByTestId('system').selectOption(other);
  await ended(page, 2, 'end');
  await expect(page.getByTestId('duration')).not.toHaveValue('1.25');
  await expect(page.getByTestId('view-orbit')).toHaveAttribute('aria-pressed', 'true');
  await page.getByTestId('system').selectOption('ripstik');
  await ended(page, 3, 'end');
  await expect(page.getByTestId('duration')).toHaveValue('1.25');
  await expect(page.getByTestId('end-time')).toHaveText(/^1\.250\s/);
  await pause(page);
  await drawn(page);
});
