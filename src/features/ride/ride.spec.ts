import { spawnSync } from 'node:child_process';
import { mkdtempSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { expect, test } from '@playwright/test';
import { exportCsv, measured, openPage, seek, VIEWPORT } from '../../../tests/browser/helpers.ts';

test.use({ viewport: VIEWPORT });

test('a course is ridden with keys, and how fast keys reach the picture is told', async ({ page }) => {
  const watch = await openPage(page);
  await page.keyboard.press('u');
  const ride = page.getByTestId('ride-view');
  await expect(ride).toHaveAttribute('data-phase', 'riding', { timeout: 60_000 });
  // With legs and hips too: the ride begins again.
  await page.getByTestId('ride-more').click();
  await page.getByTestId('ride-free').check();
  await expect(ride).toHaveAttribute('data-kind', 'body');
  await expect(ride).toHaveAttribute('data-phase', 'riding', { timeout: 60_000 });
  await page.getByTestId('ride-more').click();
  await page.keyboard.down('ArrowUp');
  await expect(ride).toHaveAttribute('data-speed', /^1\.[3-5]/, { timeout: 30_000 });
  await page.keyboard.press('ArrowLeft');
  await page.keyboard.press('ArrowRight');
  await expect(ride).toHaveAttribute('data-passed', /^[2-4]$/, { timeout: 60_000 });
  await page.keyboard.up('ArrowUp');
  for (const key of ['c', 'q', 'e']) await page.keyboard.press(key, { delay: 500 });
  for (let i = 0; i < 8; i++)
    for (const key of ['ArrowLeft', 'ArrowRight']) await page.keyboard.press(key, { delay: 90 + 10 * i });
  await page.keyboard.down('ArrowDown');
  await expect(ride).toHaveAttribute('data-speed', /^-?0\.[01]/, { timeout: 30_000 });
  const read = (name: string) => ride.getAttribute(`data-${name}`);
  const latency = Number(await read('latency'));
  measured(
    `ride: from key to picture ${latency.toFixed(1)} ms on the median, ${await read('dropped')} of ${await read('frames')} frames dropped`,
  );
  expect(latency).toBeGreaterThan(0);
  await page.keyboard.press('Escape');
  await expect(ride).toHaveCount(0);
  // A run like any: the scenario that its file carries gives the same rows in the command line, to the last bit.
  await expect(page.getByTestId('ride-marks').locator('.ride-mark')).not.toHaveCount(0);
  const { text, columns, rows } = await exportCsv(page);
  const folder = mkdtempSync(join(tmpdir(), 'ride-'));
  writeFileSync(join(folder, 'ride.json'), /^# scenario: (.*)$/m.exec(text)![1]!);
  const args = ['--import', 'tsx', 'src/cli/main.ts', 'simulate', join(folder, 'ride.json')];
  const { stdout, stderr } = spawnSync(process.execPath, args, { encoding: 'utf8', maxBuffer: 1e9 });
  const [head, ...lines] = stdout.split('\n').filter((line) => line !== '' && !line.startsWith('#'));
  const names = (head ?? stderr).split(',');
  expect(names).toContain('beta_dot');
  const repeated = lines.map((line) => line.split(',').map(Number));
  const ridden = rows.map((row) => names.map((name) => row[columns.indexOf(name)]));
  for (const name of ['crouch', 'twist'])
    expect(Math.max(...rows.map((row) => Math.abs(row[columns.indexOf(name)]!))), name).toBeGreaterThan(0.05);
  // Left between two rows, the run has one more at its end.
  expect(repeated.length - ridden.length).toBeLessThanOrEqual(1);
  expect(ridden).toEqual(repeated.slice(0, ridden.length));

  // From a moment of it the ride is ridden on: up to there it is what it was.
  await seek(page, 3);
  await page.keyboard.press('u');
  await expect(ride).toHaveAttribute('data-phase', 'over');
  await page.getByTestId('ride-take-over').click();
  await expect(ride).toHaveAttribute('data-phase', 'riding', { timeout: 60_000 });
  await page.keyboard.press('ArrowLeft', { delay: 300 });
  await expect(ride).toHaveAttribute('data-time', /^[4-9]/, { timeout: 60_000 });
  await page.keyboard.press('Escape');
  const on = await exportCsv(page);
  const upTo = (all: readonly number[][]) => all.filter((row) => row[0]! <= 3);
  expect(upTo(rows).length).toBeGreaterThan(250);
  expect(upTo(on.rows)).toEqual(upTo(rows));
  expect(on.rows).not.toEqual(rows.slice(0, on.rows.length));
  expect(watch.errors).toEqual([]);
});
