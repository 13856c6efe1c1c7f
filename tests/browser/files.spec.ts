import { expect, test, type Page } from '@playwright/test';
import {
  COORDINATES,
  csvOf,
  differingPixels,
  drop,
  FIRST_END,
  largestDifference,
  openPage,
  pause,
  picture,
  posesOf,
  posesOnStage,
  seek,
  VIEWPORT,
  type Row,
} from './helpers.ts';

test.use({ viewport: VIEWPORT });

/** Every coordinate differs from every other and from row to row, so that no two can be mixed up unseen. */
const motion: readonly Row[] = [
  {
    t: 0,
    X: 0.1,
    Y: -0.2,
    Z: 0.16,
    alpha: 0.11,
    psi: -0.07,
    theta: 0.4,
    alpha_fp: 0.3,
    alpha_bp: -0.22,
    theta_fc: 0.5,
    theta_bc: -0.6,
  },
  {
    t: 0.5,
    X: 0.6,
    Y: 0.3,
    Z: 0.19,
    alpha: -0.14,
    psi: 0.09,
    theta: 1.1,
    alpha_fp: -0.25,
    alpha_bp: 0.35,
    theta_fc: -0.7,
    theta_bc: 0.8,
  },
  {
    t: 1,
    X: 1.2,
    Y: 0.9,
    Z: 0.21,
    alpha: 0.05,
    psi: 0.02,
    theta: 1.6,
    alpha_fp: 0.1,
    alpha_bp: 0.15,
    theta_fc: 0.2,
    theta_bc: 0.1,
  },
];
const mixedOrder = ['theta_bc', 'Z', 'alpha_fp', 'Y', 't', 'psi', 'theta', 'alpha', 'X', 'theta_fc', 'alpha_bp'];
const inDegrees = ['alpha_fp', 'theta', 'theta_bc', 'alpha'];

const message = (page: Page) => page.getByTestId('message');
const endTime = (page: Page) => page.getByTestId('end-time');

test('a dropped CSV puts each body where its row says, and the picture moves', async ({ page }) => {
  const watch = await openPage(page);
  await drop(page, 'mixed.csv', csvOf(motion, mixedOrder, inDegrees));
  await expect(endTime(page)).toHaveText(/^1\.000\s/);
  await expect(page.getByTestId('rows')).toHaveText('3 rows');

  await seek(page, 0);
  expect(largestDifference(await posesOnStage(page), posesOf(motion[0]!)), 'poses at the first row').toBeLessThan(1e-6);
  const first = await picture(page);

  await seek(page, 0.5);
  expect(largestDifference(await posesOnStage(page), posesOf(motion[1]!)), 'poses at the middle row').toBeLessThan(
    1e-6,
  );
  expect(await differingPixels(page, first, await picture(page))).toBeGreaterThan(1000);

  // By keys as well: a row on, to the end and back to the start.
  await page.keyboard.press('ArrowRight');
  await expect(page.getByTestId('time')).toHaveText(/^1\.000\s/);
  expect(largestDifference(await posesOnStage(page), posesOf(motion[2]!)), 'poses at the last row').toBeLessThan(1e-6);
  await page.keyboard.press('Home');
  await expect(page.getByTestId('time')).toHaveText(/^0\.000\s/);
  expect(largestDifference(await posesOnStage(page), posesOf(motion[0]!)), 'poses back at the first row').toBeLessThan(
    1e-6,
  );
  expect(watch.errors).toEqual([]);
});

test('a chosen file opens as a dropped one does', async ({ page }) => {
  await openPage(page);
  await page.getByTestId('open-file').setInputFiles({
    name: 'chosen.csv',
    mimeType: 'text/csv',
    buffer: Buffer.from(csvOf(motion, ['t', ...COORDINATES])),
  });
  await expect(endTime(page)).toHaveText(/^1\.000\s/);
  await seek(page, 0.5);
  expect(largestDifference(await posesOnStage(page), posesOf(motion[1]!))).toBeLessThan(1e-6);
});

test('an unusable CSV names line and column and leaves the run in place', async ({ page }) => {
  const watch = await openPage(page);
  await seek(page, 3);
  const before = await posesOnStage(page);
  const everyRowBad = csvOf(motion, ['t', ...COORDINATES])
    .split('\n')
    .map((line, i) => (i === 0 ? line : line.replace(/,[^,]*$/, ',abc')))
    .slice(0, 4)
    .join('\n');
  await drop(page, 'bad.csv', everyRowBad);

  await expect(message(page)).toHaveCount(1);
  await expect(message(page)).toHaveRole('alert');
  await expect(message(page)).toContainText('bad.csv');
  await expect(message(page)).toContainText('lines 2 to 4, column theta_bc');
  await expect(message(page)).toContainText('"abc"');
  // A file that is no motion at all.
  await drop(page, 'letter.csv', 'Dear reader,\nthere are no numbers here\n');
  await expect(message(page)).toHaveCount(2);
  await expect(message(page).last()).toContainText('line 1');

  await expect(endTime(page)).toHaveText(new RegExp(`^${FIRST_END}\\s`));
  await expect(page.getByTestId('time')).toHaveText(/^3\.000\s/);
  await expect(page.getByTestId('run-state')).toHaveAttribute('data-reason', 'end');
  await expect(page.getByTestId('case-menu')).toContainText('Ridden board');
  expect(await posesOnStage(page)).toEqual(before);
  expect(watch.errors).toEqual([]);
});

test('a partly bad CSV plays the rest and lists the row', async ({ page }) => {
  await openPage(page);
  const lines = csvOf(motion, ['t', ...COORDINATES])
    .trimEnd()
    .split('\n');
  const psi = 1 + COORDINATES.indexOf('psi');
  const bad = lines[2]!
    .split(',')
    .map((cell, i) => (i === psi ? 'abc' : cell))
    .join(',');
  await drop(page, 'partly.csv', [lines[0], lines[1], bad, lines[3], ''].join('\n'));

  await expect(message(page)).toContainText('1 of 3 rows');
  await expect(message(page)).toContainText('line 3, column psi');
  await expect(endTime(page)).toHaveText(/^1\.000\s/);
  await expect(page.getByTestId('rows')).toHaveText('2 rows');
  await expect(page.getByTestId('skipped')).toBeVisible();
  await page.getByTestId('tool-now').click();
  const issue = page.getByTestId('issues').getByRole('listitem').filter({ hasText: 'line 3' });
  await expect(issue).toContainText('column psi');
  await expect(issue).toContainText('"abc"');
  // The row that is there is where it says; the one that is not there is bridged.
  await seek(page, 1);
  expect(largestDifference(await posesOnStage(page), posesOf(motion[2]!))).toBeLessThan(1e-6);
});

test('a file without header asks for the time step, offers 1/60 and plays', async ({ page }) => {
  await openPage(page);
  const rows = Array.from({ length: 31 }, (_, i) => ({ ...motion[0]!, X: i / 30 }));
  const headerless = csvOf(rows, COORDINATES).split('\n').slice(1).join('\n');

  await drop(page, 'report.csv', headerless);
  const dialog = page.getByTestId('step-dialog');
  await expect(dialog).toContainText('report.csv');
  await expect(page.getByTestId('step-field')).toHaveValue('1/60');
  // Nothing is replaced before the answer, nor by giving up.
  await expect(endTime(page)).toHaveText(new RegExp(`^${FIRST_END}\\s`));
  await page.getByTestId('step-cancel').click();
  await expect(dialog).toHaveCount(0);
  await expect(endTime(page)).toHaveText(new RegExp(`^${FIRST_END}\\s`));

  await drop(page, 'report.csv', headerless);
  await page.getByTestId('step-accept').click();
  await expect(dialog).toHaveCount(0);
  await expect(endTime(page)).toHaveText(/^0\.500\s/);
  // It plays by itself, to its end.
  await expect(page.getByTestId('time')).toHaveText(/^0\.500\s/);
  await pause(page);
  expect(largestDifference(await posesOnStage(page), posesOf(rows.at(-1)!))).toBeLessThan(1e-6);
});
