// A session by keyboard alone: choose a case, change a number, run, seek, open a tool, save a CSV. Focus is seen and goes in order.
import { expect, test, type Page } from '@playwright/test';
import { tableOf, withoutScene } from './helpers.ts';

test.use({ viewport: { width: 1280, height: 760 } });
test.beforeEach(({ context }) => withoutScene(context));

interface Focus {
  testId: string | null;
  region: string;
  /** Something about it or around it shows that it has the focus, and it is on the screen. */
  seen: boolean;
}

const REGIONS = ['skips', 'top', 'left', 'stage', 'right', 'transport', 'status'];

const focus = (page: Page): Promise<Focus> =>
  page.evaluate((regions) => {
    const e = document.activeElement as HTMLElement;
    const marks = [e, e.parentElement!, e.parentElement!.parentElement!].some((one) => {
      const style = getComputedStyle(one);
      return (style.outlineStyle !== 'none' && parseFloat(style.outlineWidth) > 0) || style.boxShadow !== 'none';
    });
    // A mark in a drawing wears a ring of its own.
    const ring = e.querySelector(':scope > .halo');
    const ringed = ring !== null && getComputedStyle(ring).stroke !== 'none';
    const box = e.getBoundingClientRect();
    const inView = box.right > 0 && box.left < innerWidth && box.bottom > 0 && box.top < innerHeight;
    const region = regions.find((name) => e.closest(`.${name}`)) ?? '';
    // The slider's own thumb carries its mark, which style queries do not reach.
    return {
      testId: e.dataset['testid'] ?? null,
      region,
      seen: inView && (marks || ringed || (e.matches('input[type=range]') && e.matches(':focus-visible'))),
    };
  }, REGIONS);

/** Presses Tab until a control has the focus; every stop on the way must be seen. */
async function tabTo(page: Page, testId: string, key: 'Tab' | 'Shift+Tab' = 'Tab'): Promise<Focus[]> {
  const way: Focus[] = [];
  for (let i = 0; i < 200; i++) {
    await page.keyboard.press(key);
    const now = await focus(page);
    expect(now, `stop ${i + 1} on the way to ${testId}`).toMatchObject({ seen: true });
    way.push(now);
    if (now.testId === testId) return way;
  }
  throw new Error(`${testId} is not reached by ${key}`);
}

test('a session without a pointer', async ({ page }) => {
  await page.goto('./');
  await expect(page.getByTestId('run-state')).toHaveAttribute('data-reason', 'end');

  // The first stop leads past the bars.
  await page.keyboard.press('Tab');
  expect(await focus(page)).toMatchObject({ testId: 'skip-stage', seen: true });

  // A case out of the gallery, which gives the focus back.
  await tabTo(page, 'case-menu');
  await page.keyboard.press('Enter');
  await expect(page.getByTestId('gallery-search')).toBeFocused();
  await page.keyboard.press('ArrowDown');
  await expect(page.getByTestId('case-ridden')).toBeFocused();
  await page.keyboard.press('End');
  await page.keyboard.press('Enter');
  await expect(page.getByTestId('case-menu')).toBeFocused();
  await expect(page.getByTestId('case-menu')).toHaveAccessibleName('Cases: Bicycle under a limp rider');

  // A number, and the run.
  await tabTo(page, 'duration');
  await page.keyboard.press('Control+A');
  await page.keyboard.type('2');
  await page.keyboard.press('Control+Enter');
  await expect(page.getByTestId('end-time')).toHaveText(/^2\.000\s/);
  await expect(page.getByTestId('announcer')).toHaveText(/Run ended at 2\.000 seconds/);

  // Playback by its keys, from the field that has just been left.
  await tabTo(page, 'run');
  await page.keyboard.press('k');
  await page.keyboard.press('Home');
  await expect(page.getByTestId('time')).toHaveText(/^0\.000\s/);
  await page.keyboard.press('Shift+ArrowRight');
  await page.keyboard.press('Shift+ArrowRight');
  await page.keyboard.press('ArrowRight');
  await expect(page.getByTestId('time')).toHaveText(/^0\.210\s/);

  // A tool: opened, gone into, folded with Escape, which gives the focus back to its button.
  await tabTo(page, 'tool-analysis');
  await page.keyboard.press('Enter');
  await expect(page.getByTestId('tool-panel-analysis')).toBeVisible();
  // What is computed has come, and moves nothing any more.
  await expect(page.getByTestId('orders')).toBeVisible();
  await expect(page.getByTestId('reach-summary')).toBeVisible();
  await tabTo(page, 'fold-right', 'Shift+Tab');
  await page.keyboard.press('Escape');
  await expect(page.getByTestId('tool-analysis')).toBeFocused();
  await expect(page.getByTestId('tool-panel-analysis')).toBeHidden();

  // The time line itself.
  await tabTo(page, 'scrubber');
  await page.keyboard.press('End');
  await expect(page.getByTestId('time')).toHaveText(/^2\.000\s/);

  // The help sheet closes on Escape and gives the focus back; then the numbers as a file.
  await tabTo(page, 'keys', 'Shift+Tab');
  await page.keyboard.press('Enter');
  await expect(page.getByTestId('keys-dialog')).toBeVisible();
  await page.keyboard.press('Escape');
  await expect(page.getByTestId('keys')).toBeFocused();
  await tabTo(page, 'export-menu', 'Shift+Tab');
  await page.keyboard.press('ArrowDown');
  await expect(page.getByTestId('export-csv')).toBeFocused();
  const download = page.waitForEvent('download');
  await page.keyboard.press('Enter');
  const { rows } = await tableOf(await download);
  expect(rows).toHaveLength(201);
});

test('the Tab key goes through the page as one reads it', async ({ page }) => {
  await page.goto('./');
  await expect(page.getByTestId('run-state')).toHaveAttribute('data-reason', 'end');
  const regions = (await tabTo(page, 'loop')).map(({ region }) => region);
  expect(regions.filter((name, i) => name !== regions[i - 1])).toEqual(REGIONS.slice(0, 6));
  // The way past the bars.
  await page.evaluate(() => (document.activeElement as HTMLElement).blur());
  await page.getByTestId('skip-playback').focus();
  await page.keyboard.press('Enter');
  await page.keyboard.press('Tab');
  expect((await focus(page)).region).toBe('transport');
});

test('run states and events are announced once', async ({ page }) => {
  await page.addInitScript(() => {
    const said: string[] = [];
    Object.assign(window, { said });
    document.addEventListener('DOMContentLoaded', () => {
      new MutationObserver(() => {
        const now = document.querySelector('[data-testid=announcer]')?.textContent ?? '';
        if (now !== '' && now !== said.at(-1)) said.push(now);
      }).observe(document.body, { childList: true, subtree: true, characterData: true });
    });
  });
  await page.goto('./#v=1&case=released&sum=0');
  await expect(page.getByTestId('run-state')).toHaveAttribute('data-reason', 'touchdown');
  const said = () => page.evaluate(() => (window as unknown as { said: string[] }).said);
  await expect.poll(said).toContainEqual(expect.stringMatching(/^touchdown at /));
  const all = await said();
  expect(all.filter((words) => words.startsWith('Run ended'))).toHaveLength(1);
  expect(all.filter((words) => words.startsWith('touchdown at'))).toHaveLength(1);
  // A refusal is an alert of its own, said by itself and not by the announcer too.
  await page.evaluate(() => {
    location.hash = 'v=1&case=nowhere&sum=0';
  });
  await expect(page.getByRole('alert').filter({ hasText: 'no case is called' })).toHaveCount(1);
  expect((await said()).filter((words) => words.includes('nowhere'))).toEqual([]);
});
