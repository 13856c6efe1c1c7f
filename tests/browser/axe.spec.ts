// No view breaks a rule of WCAG 2.1 A or AA that a machine can check: every tool, dialog and message, light and dark, desk and phone.
import AxeBuilder from '@axe-core/playwright';
import { expect, test, type Page } from '@playwright/test';
import { withoutScene } from './helpers.ts';

const RULES = ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa'];
/** Of these, what depends on colours: all that another theme can break. */
const COLOURS = ['color-contrast', 'link-in-text-block'];

// The scene is one named picture to assistive technology, drawn or not; undrawn, the page under it is looked at sooner.
test.beforeEach(({ context }) => withoutScene(context));

async function open(page: Page): Promise<void> {
  await page.goto('./');
  await expect(page.getByTestId('run-state')).toHaveAttribute('data-reason', 'end');
}

/** What is wrong in a part of the page, or in all of it. */
async function check(page: Page, view: string, part = 'html'): Promise<string[]> {
  const dark = (await page.locator('html').getAttribute('data-theme')) === 'dark';
  const axe = new AxeBuilder({ page }).include(part);
  const { violations } = await (dark ? axe.withRules(COLOURS) : axe.withTags(RULES)).analyze();
  return violations.flatMap(({ id, nodes }) =>
    nodes.map(
      ({ target, failureSummary }) =>
        `${view}: ${id} at ${target.join(' ')}: ${(failureSummary ?? '').split('\n').slice(1, 3).join('; ').trim()}`,
    ),
  );
}

/** Ids of all that the page has a button for: `tool` in the rail, `tab` in the phone's sheet. */
const named = async (page: Page, kind: 'tool' | 'tab'): Promise<string[]> => {
  const ids = await page
    .locator(`button[data-testid^="${kind}-"]`)
    .evaluateAll((all, from) => all.map((one) => one.getAttribute('data-testid')!.slice(from)), kind.length + 1);
  expect(ids.length).toBeGreaterThan(5);
  return ids;
};

/** What is loaded later has arrived. */
const settled = (page: Page) => expect(page.getByText('Loading', { exact: true })).toHaveCount(0);

for (const theme of ['light', 'dark'] as const) {
  test.describe(theme, () => {
    test.use({ colorScheme: theme, viewport: { width: 1280, height: 800 } });

    test('first view, every tool, menus, dialogs, messages', async ({ page }) => {
      await open(page);
      const found = await check(page, 'first view');
      for (const id of await named(page, 'tool')) {
        if ((await page.getByTestId(`tool-${id}`).getAttribute('aria-expanded')) !== 'true')
          await page.getByTestId(`tool-${id}`).click();
        await settled(page);
        found.push(...(await check(page, id, `#tool-panel-${id}`)));
      }
      // Every part of the panel unfolded, a field refused, the draft told to be wrong.
      await page.evaluate(() =>
        document.querySelectorAll<HTMLDetailsElement>('.experiment details').forEach((part) => (part.open = true)),
      );
      await page.getByTestId('duration').fill('soon');
      await page.getByTestId('duration').press('Tab');
      found.push(...(await check(page, 'panel unfolded', '.panel.left')));
      await page.getByTestId('case-menu').click();
      found.push(...(await check(page, 'gallery', 'dialog')));
      await page.keyboard.press('Escape');
      await page.getByTestId('export-menu').click();
      found.push(...(await check(page, 'menu', '.top')));
      await page.keyboard.press('Escape');
      await page.evaluate(() => {
        location.hash = 'v=1&case=nowhere&sum=0';
      });
      await expect(page.getByTestId('message')).toBeVisible();
      found.push(...(await check(page, 'message', '.messages')));
      await page.getByTestId('keys').click();
      await expect(page.getByTestId('keys-dialog')).toBeVisible();
      found.push(...(await check(page, 'keys', 'dialog')));
      await page.getByTestId('help-terms').click();
      await expect(page.getByTestId('terms')).toBeVisible();
      found.push(...(await check(page, 'words', 'dialog')));
      expect(found).toEqual([]);
    });
  });

  test.describe(`${theme}, phone`, () => {
    test.use({ colorScheme: theme, viewport: { width: 390, height: 800 }, hasTouch: true });

    test('every tab of the sheet', async ({ page }) => {
      await open(page);
      const found = await check(page, 'first view');
      for (const id of await named(page, 'tab')) {
        await page.getByTestId(`tab-${id}`).click();
        await settled(page);
        found.push(...(await check(page, `tab ${id}`, '.sheet')));
      }
      expect(found).toEqual([]);
    });
  });
}

test.describe('small and enlarged', () => {
  test('320 px wide: nothing is lost to the side', async ({ page }) => {
    await page.setViewportSize({ width: 320, height: 640 });
    await open(page);
    for (const id of await named(page, 'tab')) {
      await page.getByTestId(`tab-${id}`).click();
      await settled(page);
      expect(await outside(page), id).toEqual([]);
    }
  });

  test('text at 200 %: every control is still there', async ({ page }) => {
    // As a browser zooms: half the width, every pixel twice as large.
    await page.setViewportSize({ width: 640, height: 400 });
    await open(page);
    expect(await outside(page)).toEqual([]);
    for (const id of ['play', 'share', 'export-menu', 'case-menu', 'theme', 'keys', 'run']) {
      await page.getByTestId(id).scrollIntoViewIfNeeded();
      await expect(page.getByTestId(id)).toBeInViewport({ ratio: 0.9 });
    }
  });
});

/** Controls that stand beyond the right edge with no way to scroll to them. */
function outside(page: Page): Promise<string[]> {
  return page.evaluate(() => {
    const scrolls = (element: Element | null): boolean => {
      for (let e = element; e && e !== document.body; e = e.parentElement)
        if (/auto|scroll/.test(getComputedStyle(e).overflowX) && e.scrollWidth > e.clientWidth) return true;
      return false;
    };
    return [...document.querySelectorAll<HTMLElement>('button, input, select, summary, a[href]')]
      .filter(
        (e) =>
          e.checkVisibility({ visibilityProperty: true }) &&
          !e.classList.contains('hidden') &&
          !e.classList.contains('skip'),
      )
      .filter((e) => {
        const box = e.getBoundingClientRect();
        return box.width > 0 && (box.right > innerWidth + 1 || box.left < -1) && !scrolls(e.parentElement);
      })
      .map((e) => e.dataset['testid'] ?? (e.textContent || e.className));
  });
}
