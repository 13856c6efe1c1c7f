/** A lesson in the page: wrong and right answers, a plot, progress after a reload; one of one's own by drop and by link; axe in both themes. */
import AxeBuilder from '@axe-core/playwright';
import { expect, test } from '@playwright/test';
import { openWithoutScene } from '../../../tests/browser/helpers.ts';

test.use({ permissions: ['clipboard-read', 'clipboard-write'] });

test('a lesson is read, answered and kept; one of one’s own comes by drop and by link', async ({ page }) => {
  await openWithoutScene(page);
  await page.getByTestId('tool-lessons').click();
  await page.getByTestId('lesson-1-rolling').click();
  const question = page.getByTestId('question-0');
  const answer = async (text: string, told: RegExp): Promise<void> => {
    await question.getByRole('textbox').fill(text);
    await question.getByRole('button', { name: 'Check' }).click();
    await expect(question.getByRole('status')).toHaveText(told);
  };
  await answer('5 m', /^Not yet/);
  await answer('600 cm', /^Right: 6\.000 m/);
  await page.getByTestId('lesson-show').nth(1).click();
  await expect(page.getByTestId('lesson-plot')).toBeVisible();
  for (const colorScheme of ['light', 'dark'] as const) {
    await page.emulateMedia({ colorScheme });
    await page.evaluate((theme) => {
      (
        window as unknown as { ripstikApp: { actions: { set(name: string, value: string): void } } }
      ).ripstikApp.actions.set('theme', theme);
    }, colorScheme);
    const { violations } = await new AxeBuilder({ page })
      .include('[data-testid="lesson"]')
      .withTags(['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa'])
      .analyze();
    expect(
      violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html).join(' ')}`),
      colorScheme,
    ).toEqual([]);
  }
  await page.reload();
  await page.getByTestId('lessons-back').or(page.getByTestId('lesson-1-rolling')).first().waitFor();
  await expect(page.getByTestId('lessons')).toContainText('1 of 3 answered');

  const own = await page.evaluateHandle(() => {
    const carried = new DataTransfer();
    carried.items.add(new File(['# Week 3\n\nRead *this*.\n\n```live\ntitle: x\ncase: nowhere\n```\n'], 'week3.md'));
    return carried;
  });
  await page.dispatchEvent('body', 'drop', { dataTransfer: own });
  await expect(page.getByTestId('lesson').getByRole('heading', { name: 'Week 3' })).toBeVisible();
  await expect(page.getByTestId('lesson-faults')).toContainText('line 5: there is no case "nowhere"');
  await page.getByTestId('lesson-link').click();
  await expect(page.getByTestId('lesson')).toContainText('The link is copied');
  const link = await page.evaluate(() => navigator.clipboard.readText());
  await page.getByTestId('lessons-back').click();
  await page.goto('about:blank');
  await page.goto(link);
  await expect(page.getByTestId('lesson').getByRole('heading', { name: 'Week 3' })).toBeVisible();
});
