import { expect, test } from '@playwright/test';
import { ripstikMeta } from '../../src/core/systems/ripstik/meta.ts';
import { BODIES, differingPixels, openPage, picture, screenBox, showOnly, VIEWPORT } from './helpers.ts';

test.use({ viewport: VIEWPORT });

const all = ripstikMeta.bodies.map((_, i) => i);

test('the built page under a sub-path draws five bodies and somebody on them, and asks no one else for anything', async ({
  page,
}) => {
  const watch = await openPage(page);
  expect(new URL(page.url()).pathname).toBe('/lab/');
  const bodies = () => page.evaluate(() => window.ripstikScene!.stats().bodies);
  expect(await bodies()).toBeGreaterThan(BODIES);
  const ridden = await picture(page);
  await showOnly(page, all);
  expect(await differingPixels(page, await picture(page), ridden), 'somebody on the board').toBeGreaterThan(1000);

  // The board by itself fills the picture.
  await page.getByTestId('view-menu').click();
  await page.getByTestId('look-rider').selectOption('never');
  await page.keyboard.press('Escape');
  await expect.poll(bodies).toBe(5);
  await showOnly(page, all);
  const whole = await picture(page);
  await showOnly(page, []);
  const empty = await picture(page);
  expect(await differingPixels(page, whole, empty), 'the whole board against the empty scene').toBeGreaterThan(1000);

  for (const body of all) {
    const name = ripstikMeta.bodies[body]!.label;
    const box = await screenBox(page, body);
    await showOnly(page, [body]);
    expect(
      await differingPixels(page, await picture(page), empty, box),
      `${name} alone against the empty scene`,
    ).toBeGreaterThan(40);
    await showOnly(
      page,
      all.filter((other) => other !== body),
    );
    expect(
      await differingPixels(page, await picture(page), whole, box),
      `the board without its ${name}`,
    ).toBeGreaterThan(40);
  }
  // Nothing stays behind: shown again, the picture is the first one.
  await showOnly(page, all);
  expect(await differingPixels(page, await picture(page), whole)).toBe(0);

  expect(BODIES).toBe(5);
  expect(watch.errors, 'errors on the console').toEqual([]);
  expect(await page.evaluate(() => window.cspViolations), 'violations of the content security policy').toEqual([]);
  expect(watch.foreign, 'requests to other origins').toEqual([]);
});
