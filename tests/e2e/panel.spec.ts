import { expect, test } from '@playwright/test';
import { chooseCase, ended, openPage, seek, type as typeInto, VIEWPORT } from './helpers.ts';

test.use({ viewport: VIEWPORT });

test('fields read degrees and expressions, refuse nonsense, and show what the start became', async ({ page }) => {
  await openPage(page);
  await chooseCase(page, 'released');
  await ended(page, 'touchdown');
  await page.getByTestId('fold-right').click();
  const field = page.getByTestId('initial-alpha_fp');
  const plateAngle = async () => {
    await seek(page, 0);
    return page.getByTestId('now-alpha_fp');
  };

  // The board was put on its wheels: the height gave way.
  await expect(page.getByTestId('solved-Z')).toContainText(/→ 0\.\d+\s*m/);

  await typeInto(page, 'initial-alpha_fp', '45 deg');
  await expect(field).toHaveValue('45');
  await page.getByTestId('run').click();
  await expect(await plateAngle()).toHaveText('45.00');

  await typeInto(page, 'initial-alpha_fp', 'pi/8');
  await expect(field).toHaveValue('pi/8');
  await page.getByTestId('run').click();
  await expect(await plateAngle()).toHaveText('22.50');

  // Nonsense stays in its field with its reason; what is in force is the last good value.
  await typeInto(page, 'initial-alpha_fp', 'pi/(8');
  await expect(field).toHaveAttribute('aria-invalid', 'true');
  const error = page.locator(`[id="${await field.getAttribute('aria-describedby')}"]`);
  await expect(error).toBeVisible();
  await expect(error).not.toBeEmpty();
  await expect(page.getByText('1 field is not in force')).toBeVisible();
  await expect(await plateAngle()).toHaveText('22.50');

  await typeInto(page, 'initial-alpha_fp', '-10');
  await expect(field).not.toHaveAttribute('aria-invalid', 'true');
  await expect(error).toHaveCount(0);
  await page.getByTestId('run').click();
  await expect(await plateAngle()).toHaveText('−10.00');
});
