// What is shared comes back to the last bit, what was done survives a reload, and strangers' addresses lose nothing.
import { expect, test, type Page } from '@playwright/test';
import { cases } from '../../core/systems/registry.ts';
import {
  chooseCase,
  COORDINATES,
  csvOf,
  drop,
  ended,
  exportCsv,
  recordWorkers,
  type as typeInto,
  withoutScene,
} from '../../../tests/browser/helpers.ts';

test.use({ viewport: { width: 800, height: 560 }, permissions: ['clipboard-read', 'clipboard-write'] });

test.beforeEach(({ context }) => withoutScene(context));

/** Opens the page and waits for its first run; what goes wrong is in the answer. */
async function open(page: Page): Promise<string[]> {
  const errors: string[] = [];
  page.on('pageerror', (error) => errors.push(String(error)));
  await recordWorkers(page);
  await page.goto('./');
  await motionRun(page, 'end');
  return errors;
}

const message = (page: Page) => page.getByTestId('message');
const hash = (page: Page) => page.evaluate(() => location.hash);
const motionRun = (page: Page, reason: string) =>
  expect(page.getByTestId('run-state')).toHaveAttribute('data-reason', reason);
/** Writing waits for a moment of rest. */
const kept = (page: Page, what: RegExp) =>
  expect.poll(() => page.evaluate(() => localStorage.getItem('ripstik.work'))).toMatch(what);
const ROWS = [0, 1, 2].map((t) => ({ ...Object.fromEntries(COORDINATES.map((name) => [name, 0.1 * t])), t }));

async function shared(page: Page): Promise<string> {
  await page.getByTestId('share').click();
  await expect(message(page)).toContainText('Link copied');
  return page.evaluate(() => navigator.clipboard.readText());
}

test('a link opens to the same run, bit for bit, and the work from before stays until something is edited', async ({
  page,
  context,
}) => {
  const errors = await open(page);
  await chooseCase(page, 'released');
  await ended(page, 2, 'touchdown');
  // Else the run follows what is typed, and runs are counted here.
  await page.getByTestId('live').click();
  await typeInto(page, 'initial-alpha', '1/3');
  await typeInto(page, 'duration', '7');
  await page.keyboard.press('Control+Enter');
  await ended(page, 3, 'touchdown');
  await page.getByTestId('tool-analysis').click();
  await expect(page.getByTestId('play')).toHaveAccessibleName('Play');
  const link = await shared(page);
  expect(link).toMatch(/#v=1&case=released&initial\.alpha=%281%2F3%29\+deg&duration=7&tool=analysis&sum=\w+$/);
  // The file names how far the run is right, once the comparison beside the view has ended.
  await expect(page.getByTestId('trust')).toBeVisible();
  const before = await exportCsv(page);

  // Another visitor of this browser with work of their own.
  const other = await context.newPage();
  await other.goto(link);
  await motionRun(other, 'touchdown');
  await expect(other.getByTestId('tool-panel-analysis')).toBeVisible();
  await expect(other.getByTestId('trust')).toBeVisible();
  expect((await exportCsv(other)).text).toBe(before.text);
  await expect(message(other)).toContainText('Opened from a link: Released at 1 m/s');

  // The address of an open page changed: the same, and back again.
  await other.evaluate(() => {
    location.hash = 'v=1&case=released&duration=0.5&view=top&time=0.25&sum=0';
  });
  await expect(other.getByTestId('time')).toHaveText(/^0\.250\s/);
  await expect(message(other).last()).toContainText('The link was changed by hand');
  await message(other).last().getByRole('button', { name: 'Back to your last work' }).click();
  await expect(other.getByTestId('initial-alpha')).toHaveValue('(1/3) deg');
  expect(await hash(other)).toBe('');
  expect(errors).toEqual([]);
});

/** Waits for the end of the run of what is in the panel: its reason, its rows, and every number of the last one as the 64 bits that it is. */
async function endOfRun(page: Page): Promise<string> {
  const end = await page.waitForFunction(() => {
    interface Shown {
      written?: unknown;
      trajectory: { columns: readonly string[]; length: number; column(name: string): Float64Array };
    }
    interface State {
      run: { value: { kind: string; reason?: string } | null };
      motion: { value: Shown | null };
      draft: { value: unknown };
    }
    const { run, motion, draft } = (window as unknown as { ripstikApp: { state: State } }).ripstikApp.state;
    if (run.value?.kind !== 'ended' || motion.value?.written !== draft.value) return null;
    const { trajectory } = motion.value!;
    const last = Float64Array.from(trajectory.columns, (name) => trajectory.column(name)[trajectory.length - 1]!);
    return `${run.value.reason} after ${trajectory.length} rows: ${[...new BigUint64Array(last.buffer)].map((bits) => bits.toString(16)).join(' ')}`;
  });
  return (await end.jsonValue())!;
}

test('a link made from any case, changed, opens to the same final state to the last bit', async ({ page, context }) => {
  const errors = await open(page);
  const made: { id: string; link: string; end: string }[] = [];
  for (const { id, scenario } of cases) {
    // By the page's own doors, but without waiting for a pointer 31 times.
    await page.evaluate(
      async ({ id: which, duration }) => {
        const { actions, state } = (
          window as unknown as {
            ripstikApp: {
              actions: { loadCase(id: string): void };
              state: { draft: { value: { duration?: unknown } } };
            };
          }
        ).ripstikApp;
        const frame = () => new Promise((done) => requestAnimationFrame(done));
        const field = () => document.querySelector<HTMLInputElement>('[data-testid=duration]')!;
        actions.loadCase(which);
        do await frame();
        while (field().value !== String(duration));
        field().value = `${duration}*0.3`;
        field().dispatchEvent(new InputEvent('input', { bubbles: true }));
        await frame();
        field().dispatchEvent(new KeyboardEvent('keydown', { key: 'Enter', bubbles: true, cancelable: true }));
        do await frame();
        while (state.draft.value.duration === duration);
      },
      { id, duration: scenario.duration },
    );
    const end = await endOfRun(page);
    await page.evaluate(() => navigator.clipboard.writeText(''));
    await page.getByTestId('share').dispatchEvent('click');
    const copied = (): Promise<string> => page.evaluate(() => navigator.clipboard.readText());
    await expect.poll(copied, { intervals: [30] }).not.toBe('');
    const link = await copied();
    expect(link).toContain(`case=${id}&duration=`);
    made.push({ id, link, end });
  }
  await page.close();
  const other = await context.newPage();
  await other.goto('./');
  for (const { id, link, end } of made) {
    await other.evaluate((address) => {
      location.hash = new URL(address).hash;
    }, link);
    await expect.poll(() => endOfRun(other), { message: `the link of ${id}`, intervals: [30] }).toBe(end);
  }
  expect(errors).toEqual([]);
});

test('bad links say what and where; the page opens with its usual work', async ({ page }) => {
  const says = async (link: string, what: RegExp) => {
    await page.evaluate((text) => {
      location.hash = text;
    }, link);
    await expect(message(page).last()).toContainText(what);
    expect(await hash(page)).toBe('');
  };
  await page.goto('./#v=1&case=nowhere&sum=0');
  await expect(message(page)).toContainText('case: no case is called "nowhere"');
  await motionRun(page, 'end');
  await says('v=1&case=ridden&dur&sum=0', /entries read name=value/);
  await says('v=1&case=ridden&dur', /cut on its way/);
  await says('v=1&case=ridden&duration=2', /cut on its way/);
  await says('v=1&case=ridden&duration=soon&sum=0', /duration: must be a number, not the text "soon"/);
  await says('v=1&case=ridden&__proto__.polluted=1&sum=0', /no name of a scenario/);
  await says(`v=1&title=${'x'.repeat(20_000)}&sum=0`, /characters are more than the 16000/);
  await says('v=1&case=ridden&inputs.tau_fp=%3Cimg+src%3Dx+onerror%3Dalert(1)%3E&sum=0', /inputs\.tau_fp/);
  expect(await page.evaluate(() => ({}) as Record<string, unknown>)).not.toHaveProperty('polluted');
  await motionRun(page, 'end');
});

test('drafts, settings and the open file survive a reload; forgetting takes all of it away', async ({ page }) => {
  await open(page);
  await chooseCase(page, 'cart-pendulum');
  await ended(page, 2, 'end');
  await typeInto(page, 'duration', '1.5');
  await page.getByTestId('theme').click();
  await page.getByTestId('tool-now').click();
  await drop(page, 'mine.csv', csvOf(ROWS, ['t', ...COORDINATES]));
  await expect(page.getByTestId('rows')).toHaveText('3 rows');
  await kept(page, /"file":"mine\.csv".*"theme":"dark"/);

  await page.reload();
  await expect(page.getByTestId('rows')).toHaveText('3 rows');
  await expect(page.getByTestId('status')).toContainText('mine.csv');
  await expect(page.locator('html')).toHaveAttribute('data-theme', 'dark');
  await expect(page.getByTestId('tool-panel-now')).toBeVisible();
  await expect(page.getByTestId('duration')).toHaveValue('1.5');
  await expect(page.getByTestId('case-menu')).toContainText('changed');

  // Forgotten, and nothing comes back until something is edited.
  await page.getByTestId('keys').click();
  await page.getByTestId('forget').click();
  await expect(message(page)).toContainText('Everything stored in this browser is forgotten');
  await page.reload();
  await motionRun(page, 'end');
  await expect(page.getByTestId('rows')).toHaveCount(0);
  await expect(page.getByTestId('case-menu')).not.toContainText('changed');

  // What was stored is read like a stranger's file.
  await page.evaluate(() =>
    localStorage.setItem(
      'ripstik.work',
      '{"version":1,"system":"ripstik","drafts":[{"origin":"ridden","draft":{"version":1,"system":"ripstik","duration":-1}}],"settings":{}}',
    ),
  );
  await page.reload();
  await expect(message(page)).toContainText('duration: must be greater than 0, not -1');
  await motionRun(page, 'end');
});

test('storage that is full or forbidden is said once and stops nothing', async ({ page }) => {
  await page.addInitScript(() => {
    const refuse = () => {
      throw new DOMException('', 'QuotaExceededError');
    };
    Storage.prototype.setItem = refuse;
    Object.defineProperty(window, 'indexedDB', {
      get() {
        throw new DOMException('', 'SecurityError');
      },
    });
  });
  const errors = await open(page);
  await typeInto(page, 'duration', '0.5');
  await expect(message(page)).toContainText('Your work stays in this tab only');
  await drop(page, 'mine.csv', csvOf(ROWS, ['t', ...COORDINATES]));
  await expect(page.getByTestId('rows')).toHaveText('3 rows');
  await page.getByTestId('run').click();
  await motionRun(page, 'end');
  await expect(message(page)).toHaveCount(1);
  expect(errors).toEqual([]);
});

test('a file of the address plays; one from elsewhere is refused before it is asked for', async ({ page }) => {
  const asked: string[] = [];
  page.on('request', (request) => asked.push(request.url()));
  await page.goto('./?file=data/falling-report.csv');
  await expect(page.getByTestId('status')).toContainText('falling-report.csv');
  await expect(page.getByTestId('rows')).toHaveText(/\d+ rows/);
  for (const file of [
    'https://example.org/x.csv',
    '//example.org/x.csv',
    '/\\example.org/x.csv',
    'data/%0a../x.exe',
    'javascript:alert(1)',
  ]) {
    await page.goto(`./?file=${encodeURIComponent(decodeURIComponent(file))}`);
    await expect(message(page).last()).toContainText('The file named in the address was not opened');
  }
  await page.goto('./?file=data/none.csv');
  await expect(message(page).last()).toContainText('the server answered 404');
  expect(asked.filter((url) => url.includes('example.org') || url.includes('.exe'))).toEqual(
    asked.filter((url) => /\?file=/.test(url) && (url.includes('example.org') || url.includes('.exe'))),
  );
});
