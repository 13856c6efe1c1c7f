// The gallery as a person uses it, and the first minute: an offer, a tour of five steps, never shown again.
import AxeBuilder from '@axe-core/playwright';
import { expect, test, type Page } from '@playwright/test';
import { cases } from '../../core/systems/registry.ts';
import { withoutScene } from '../../../tests/browser/helpers.ts';

test.use({ viewport: { width: 1280, height: 760 } });
test.beforeEach(({ context }) => withoutScene(context));

async function open(page: Page): Promise<void> {
  await page.goto('./');
  await expect(page.getByTestId('run-state')).toHaveAttribute('data-reason', 'end');
}

test('every case is a card with its picture; a search narrows them, one click runs', async ({ page }) => {
  await open(page);
  await page.getByTestId('case-menu').click();
  const gallery = page.getByTestId('gallery');
  await expect(gallery.locator('[data-testid^="case-"]')).toHaveCount(cases.length);
  const pictures = await gallery.locator('img').evaluateAll((all) =>
    Promise.all(
      all.map(async (image) => {
        (image as HTMLImageElement).loading = 'eager';
        await (image as HTMLImageElement).decode();
        return [(image as HTMLImageElement).naturalWidth, (image as HTMLImageElement).src.endsWith('-light.webp')];
      }),
    ),
  );
  expect(new Set(pictures.map(String))).toEqual(new Set(['360,true']));
  await gallery.getByTestId('gallery-search').fill('stiff decay');
  await expect(gallery.locator('.card')).toHaveCount(1);
  await expect(gallery.getByTestId('gallery-mathematics').locator('.card-choice')).toHaveCount(3);
  await gallery.getByTestId('gallery-search').fill('zebra');
  await expect(gallery.getByRole('status')).toHaveText('No case matches “zebra”.');
  await gallery.getByTestId('gallery-search').fill('cart LQR');
  await page.getByTestId('case-cart-pendulum-lqr').click();
  await expect(gallery).toHaveCount(0);
  await expect(page.getByTestId('case-menu')).toHaveAccessibleName('Cases: Inverted pendulum balanced');
  await expect(page.getByTestId('end-time')).toHaveText(/^30\.000\s/);
});

test('by keys: arrows over the cards, Enter runs, Escape leaves, focus returns', async ({ page }) => {
  await open(page);
  await page.getByTestId('case-menu').press('Enter');
  await expect(page.getByTestId('gallery-search')).toBeFocused();
  await page.keyboard.press('ArrowDown');
  await expect(page.getByTestId('case-ridden')).toBeFocused();
  await page.keyboard.press('ArrowRight');
  await expect(page.getByTestId('case-released')).toBeFocused();
  const before = (await page.locator('.card:focus').boundingBox())!;
  await page.keyboard.press('ArrowDown');
  const below = (await page.locator('.card:focus').boundingBox())!;
  expect(below.x).toBeCloseTo(before.x, 0);
  expect(below.y).not.toBeCloseTo(before.y, 0);
  await page.keyboard.press('ArrowUp');
  await expect(page.getByTestId('case-released')).toBeFocused();
  await page.keyboard.press('Escape');
  await expect(page.getByTestId('gallery')).toHaveCount(0);
  await expect(page.getByTestId('case-menu')).toBeFocused();
  await page.keyboard.press('Enter');
  await page.getByTestId('gallery-search').fill('released at 1');
  await page.keyboard.press('Enter');
  await expect(page.getByTestId('run-state')).toHaveAttribute('data-reason', 'touchdown');
  await expect(page.getByTestId('case-menu')).toBeFocused();
});

test('the bicycle’s forward speed is a field of the start', async ({ page }) => {
  await open(page);
  await page.getByTestId('case-menu').click();
  await page.getByTestId('case-bicycle-stable').click();
  const speed = page.getByTestId('initial-speed');
  await expect(speed).toHaveValue('4.6');
  await speed.fill('3');
  await speed.press('Tab');
  await page.getByTestId('case-menu').click();
  await page.keyboard.press('Escape');
  expect(
    await page.evaluate(
      () =>
        (window as unknown as { ripstikApp: { state: { draft: { value: { initial: object } } } } }).ripstikApp.state
          .draft.value.initial,
    ),
  ).toMatchObject({ speed: 3 });
});

test.describe('first minute', () => {
  test.use({ storageState: { cookies: [], origins: [] } });

  /** Whether the card of the tour stands over what it speaks of. */
  const covers = (page: Page) =>
    page.evaluate(() => {
      const [card, mark] = ['.tour', '.tour-mark'].map((name) => document.querySelector(name)?.getBoundingClientRect());
      return (
        !card ||
        !mark ||
        (card.left < mark.right && mark.left < card.right && card.top < mark.bottom && mark.top < card.bottom)
      );
    });

  async function walk(page: Page): Promise<void> {
    for (let step = 1; step <= 5; step++) {
      const tour = page.getByTestId('tour');
      await expect(tour).toContainText(`Step ${step} of 5`);
      await expect(tour.getByRole('heading')).toBeFocused();
      await expect.poll(() => covers(page), `step ${step} leaves free what it speaks of`).toBe(false);
      await page.getByTestId('tour-next').click();
    }
    await expect(page.getByTestId('tour')).toHaveCount(0);
  }

  test('the offer, the tour, and never again', async ({ page }) => {
    await open(page);
    await page.getByTestId('offer-tour').click();
    await walk(page);
    await page.reload();
    await expect(page.getByTestId('run-state')).toHaveAttribute('data-reason', 'end');
    await expect(page.getByTestId('offer')).toHaveCount(0);
    // From the sheet of keys it comes again; Escape ends it anywhere.
    await page.getByTestId('keys').click();
    await page.getByTestId('take-tour').click();
    await page.getByTestId('tour-next').click();
    await expect(page.getByTestId('tour')).toContainText('Step 2 of 5');
    await page.keyboard.press('Escape');
    await expect(page.getByTestId('tour')).toHaveCount(0);
    await expect(page.getByTestId('keys')).toBeFocused();
  });

  test('one thing to try: the balanced board', async ({ page }) => {
    await open(page);
    await page.getByTestId('offer-try').click();
    await expect(page.getByTestId('case-menu')).toHaveAccessibleName('Cases: Balanced by its steering motors');
    await expect(page.getByTestId('offer')).toHaveCount(0);
  });

  test('on a phone, and where nothing may be stored', async ({ page }) => {
    await page.addInitScript(() =>
      Object.defineProperty(window, 'localStorage', {
        get: () => {
          throw new DOMException('forbidden', 'SecurityError');
        },
      }),
    );
    await page.setViewportSize({ width: 390, height: 800 });
    await open(page);
    await page.getByTestId('offer-tour').click();
    await walk(page);
    await expect(page.getByTestId('offer')).toHaveCount(0);
  });

  for (const colorScheme of ['light', 'dark'] as const) {
    test(`offer, tour and gallery keep to WCAG AA, ${colorScheme}`, async ({ page }) => {
      await page.emulateMedia({ colorScheme });
      await open(page);
      const wrong = async (part: string) =>
        (
          await new AxeBuilder({ page }).include(part).withTags(['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa']).analyze()
        ).violations.map(({ id, nodes }) => `${part}: ${id} at ${nodes[0]!.target.join(' ')}`);
      await expect(page.getByTestId('offer')).toBeVisible();
      const found = await wrong('.offer');
      await page.getByTestId('offer-tour').click();
      found.push(...(await wrong('.tour')));
      await page.getByTestId('tour-skip').click();
      await page.getByTestId('case-menu').click();
      await expect(page.getByTestId('gallery').locator('.card').first()).toBeVisible();
      found.push(...(await wrong('dialog')));
      expect(found).toEqual([]);
    });
  }
});
