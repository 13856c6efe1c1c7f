/** What a person does with the page, as acts drawn from a seed. Each leaves the page free for the next. */
import { expect, type Locator, type Page } from '@playwright/test';
import { cases } from '../../src/core/systems/registry.ts';
import { COORDINATES, csvOf, drop } from '../../tests/browser/helpers.ts';

export interface Chance {
  /** 0 to 1. */
  next(): number;
  below(n: number): number;
  of<T>(list: readonly T[]): T;
}

export function chanceFrom(seed: number): Chance {
  let state = seed >>> 0;
  const next = (): number => {
    state = (state + 0x6d2b79f5) >>> 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
  const below = (n: number): number => Math.floor(next() * n);
  return { next, below, of: (list) => list[below(list.length)]! };
}

export type Act = (page: Page, chance: Chance) => Promise<void>;

export const TOOLS = ['now', 'plots', 'equations', 'analysis', 'methods', 'compare'] as const;
const PATIENT = { timeout: 60_000 };
const id = (page: Page, name: string): Locator => page.getByTestId(name);
const some = (page: Page, chance: Chance): Promise<void> => page.waitForTimeout(50 + chance.below(400));

export async function open(page: Page, tool: (typeof TOOLS)[number]): Promise<void> {
  if (!(await id(page, `tool-panel-${tool}`).isVisible())) await id(page, `tool-${tool}`).click();
  await expect(id(page, `tool-panel-${tool}`)).toBeVisible();
}

/** Nothing stands over the panel of the experiment. */
export async function fold(page: Page): Promise<void> {
  const button = page.locator('[data-testid=fold-right]:visible');
  if ((await button.count()) > 0) await button.click();
}

export async function choose(page: Page, caseId: string): Promise<void> {
  await id(page, 'case-menu').click();
  await id(page, `case-${caseId}`).click();
  await expect(id(page, 'gallery')).toHaveCount(0);
}

/** Until what is in the panel has been computed, or a while. */
export async function settled(page: Page, wait = 30_000): Promise<void> {
  await expect(page.locator('[data-testid=run-state] progress, [data-testid=reading]')).toHaveCount(0, {
    timeout: wait,
  });
}

async function saved(page: Page, press: () => Promise<void>): Promise<void> {
  const [file] = await Promise.all([page.waitForEvent('download', PATIENT), press()]);
  expect(await file.failure()).toBeNull();
  await file.delete();
}

const rows = (n: number, chance: Chance) => {
  const speed = 0.5 + chance.next();
  return Array.from({ length: n }, (_, k) => ({
    ...Object.fromEntries(COORDINATES.map((c) => [c, 0.1 * Math.sin(0.02 * k)])),
    t: k / 100,
    X: (speed * k) / 100,
    Z: 0.08,
  }));
};

const BAD_TABLES = [
  '',
  'a;b;c\n1;2;3\n',
  't,X\n0,1\n',
  '\u0000\u0001\u0002',
  'x'.repeat(5000),
  `t,${COORDINATES.join(',')}\n${'NaN,'.repeat(11)}\n`,
  '<img src=x onerror=alert(1)>,2\n1,2\n',
];
const BAD_SCENARIOS = [
  '{',
  '{"version":1,"system":"nowhere"}',
  '{"version":1,"system":"ripstik","duration":-1}',
  '{"version":1,"system":"ripstik","__proto__":{"x":1},"parameters":{"constructor":2}}',
  '[[[[[[]]]]]]',
];

const told = async (page: Page): Promise<void> =>
  expect(id(page, 'message').last()).toContainText('could not be opened', PATIENT);

async function pressKeys(page: Page, chance: Chance, keys: readonly string[], most: number): Promise<void> {
  await page.evaluate(() => (document.activeElement as HTMLElement | null)?.blur());
  for (let k = 1 + chance.below(most); k > 0; k--) {
    await page.keyboard.press(chance.of(keys));
    await some(page, chance);
  }
}

async function exportDialog(page: Page, tab: string): Promise<void> {
  await id(page, 'export-menu').click();
  await id(page, 'export-more').click();
  await id(page, `export-tab-${tab}`).click();
}

/** By name; the names stand in the table. */
export const acts: Readonly<Record<string, Act>> = {
  async run(page, chance) {
    await choose(page, chance.of(cases).id);
    if (chance.next() < 0.6) await settled(page);
    else await some(page, chance);
  },
  async 'edit and run'(page, chance) {
    await fold(page);
    await id(page, 'duration').fill(String(1 + chance.below(8)));
    await id(page, 'duration').press('Enter');
    await settled(page);
  },
  async cancel(page, chance) {
    await fold(page);
    await choose(page, chance.of(['hanging', 'rolling-wheel-circle', 'wheel-pendulum', 'cart-pendulum']));
    await id(page, 'duration').fill('90000');
    await id(page, 'duration').press('Enter');
    await some(page, chance);
    // A run that ended by itself meanwhile has nothing to cancel.
    await id(page, 'cancel').evaluate((button: HTMLButtonElement) => button.click());
    await settled(page);
    await id(page, 'reset').click();
  },
  play: (page, chance) => pressKeys(page, chance, ['k', 'l', 'j', ' ', 'l'], 5),
  step: (page, chance) =>
    pressKeys(page, chance, ['ArrowLeft', 'ArrowRight', 'Shift+ArrowRight', 'Home', 'End', ',', '.'], 8),
  async scrub(page, chance) {
    await page.keyboard.press('k');
    for (let k = 0; k < 6; k++) {
      await id(page, 'scrubber').evaluate((slider: HTMLInputElement, share) => {
        slider.value = String(Number(slider.min) + share * (Number(slider.max) - Number(slider.min)));
        slider.dispatchEvent(new InputEvent('input', { bubbles: true }));
      }, chance.next());
      await page.waitForTimeout(30);
    }
  },
  async 'good table'(page, chance) {
    const n = 2 + chance.below(3000);
    await drop(
      page,
      `ride ${n}.csv`,
      csvOf(rows(n, chance), ['t', ...COORDINATES], chance.next() < 0.3 ? ['alpha'] : []),
    );
    await expect(id(page, 'rows')).toHaveText(`${n.toLocaleString('en')} rows`, PATIENT);
  },
  async 'bad table'(page, chance) {
    await drop(page, 'bad.csv', chance.of(BAD_TABLES));
    await told(page);
  },
  async 'bad scenario'(page, chance) {
    await drop(page, 'bad.json', chance.of(BAD_SCENARIOS));
    await told(page);
  },
  async 'good scenario'(page, chance) {
    const { scenario } = chance.of(cases.filter((c) => c.scenario.system !== 'bicycle'));
    await drop(page, 'mine.json', JSON.stringify({ ...scenario, duration: 1 + chance.below(3) }));
    await settled(page);
  },
  async 'bad mesh'(page, chance) {
    await drop(page, chance.of(['nobody.mdl', 'nobody.mat']), 'v 1 2 3\nf 1 2 99999\n');
    await told(page);
  },
  async sample(page, chance) {
    await id(page, 'sample-menu').click();
    await id(page, chance.of(['sample-ridden', 'sample-falling-report'])).click();
    await expect(id(page, 'rows')).toBeVisible(PATIENT);
  },
  async tool(page, chance) {
    await open(page, chance.of(TOOLS));
    await some(page, chance);
    if (chance.next() < 0.3) await fold(page);
  },
  async gallery(page, chance) {
    await id(page, 'case-menu').click();
    await id(page, 'gallery-search').fill(chance.of(['wheel', 'LQR', 'zebra', 'fig', '']));
    await some(page, chance);
    await page.keyboard.press('Escape'); // empties the search, if there is something in it
    if (await id(page, 'gallery').isVisible()) await page.keyboard.press('Escape');
    await expect(id(page, 'gallery')).toHaveCount(0);
  },
  async 'export CSV'(page) {
    await id(page, 'export-menu').click();
    await saved(page, () => id(page, 'export-csv').click());
  },
  async 'export PNG'(page, chance) {
    await exportDialog(page, 'picture');
    await id(page, 'png-size').selectOption('-1');
    for (const [field, size] of [
      ['png-width', 160],
      ['png-height', 90 + 2 * chance.below(20)],
    ] as const) {
      await id(page, field).fill(String(size));
      await id(page, field).press('Tab');
    }
    await saved(page, () => id(page, 'save-png').click());
  },
  async 'export GLB'(page) {
    await exportDialog(page, 'glb');
    await id(page, 'glb-rate').selectOption('24');
    if (await id(page, 'save-glb').isEnabled()) await saved(page, () => id(page, 'save-glb').click());
  },
  async keep(page, chance) {
    await open(page, 'compare');
    if (await id(page, 'compare-runs').isVisible()) await id(page, 'compare-runs').click();
    const list = id(page, 'kept-list').locator('> li');
    while ((await list.count()) >= 4) await list.first().locator('[data-testid^=kept-remove]').click();
    if (await id(page, 'compare-keep').isEnabled()) await id(page, 'compare-keep').click();
    const toggles = page.locator('[data-testid^=kept-ghost], [data-testid^=kept-visible]');
    if ((await toggles.count()) > 0) await toggles.nth(chance.below(await toggles.count())).click();
    if (chance.next() < 0.3 && (await list.count()) > 0) {
      await list.first().locator('[data-testid^=kept-remove]').click();
      if (chance.next() < 0.5) await id(page, 'kept-undo').click();
    }
  },
  async 'compare methods'(page, chance) {
    await choose(page, chance.of(['released', 'falling-ground', 'cart-pendulum', 'rolling-wheel-line']));
    await settled(page);
    await open(page, 'methods');
    await id(page, 'methods-run').click();
    if (chance.next() < 0.5) {
      await some(page, chance);
      if (await id(page, 'methods-cancel').isEnabled())
        await id(page, 'methods-cancel')
          .click({ timeout: 5000 })
          .catch(() => undefined);
    }
    await expect(id(page, 'methods-cancel')).toBeDisabled(PATIENT);
  },
  async sweep(page, chance) {
    await choose(page, 'released');
    await settled(page);
    await open(page, 'compare');
    await id(page, 'compare-sweep').click();
    await id(page, 'sweep-axis-0').selectOption('initial.X_dot');
    await id(page, 'sweep-from-0').fill('1');
    await id(page, 'sweep-to-0').fill('3');
    await id(page, 'sweep-count-0').fill(String(chance.of([3, 4, 60])));
    await id(page, 'sweep-run').click();
    await some(page, chance);
    if (chance.next() < 0.5 && (await id(page, 'sweep-cancel').isVisible()))
      await id(page, 'sweep-cancel')
        .click({ timeout: 5000 })
        .catch(() => undefined);
    await expect(id(page, 'sweep-standing')).toHaveAttribute('data-state', /ended|cancelled/, PATIENT);
  },
  async link(page, chance) {
    const good = chance.next() < 0.7;
    await page.evaluate(
      (hash) => {
        location.hash = hash;
      },
      good
        ? `v=1&case=${chance.of(['released', 'cart-pendulum', 'hanging'])}&duration=${1 + chance.below(3)}&view=${chance.of(['top', 'side'])}&time=0.25&sum=0`
        : 'v=1&case=nowhere&sum=1',
    );
    await expect(id(page, 'message').last()).toBeVisible(PATIENT);
    await settled(page);
  },
  async theme(page, chance) {
    for (let k = 1 + chance.below(2); k > 0; k--) await id(page, 'theme').click();
  },
  look: (page, chance) => pressKeys(page, chance, ['1', '2', '3', '4', '5', '6', 'n', 'a', 'p', 'f'], 5),
  async switches(page, chance) {
    await fold(page);
    for (const name of ['toggle-forces', 'toggle-trails', 'toggle-follow'])
      if (chance.next() < 0.5 && (await id(page, name).isVisible())) await id(page, name).click();
  },
  async weights(page, chance) {
    await fold(page);
    const [caseId, state] = chance.of([
      ['cart-pendulum-lqr', 'theta'],
      ['wheel-pendulum-lqr', 'psi'],
      ['balanced', 'alpha_fp'],
    ] as const);
    await choose(page, caseId);
    await settled(page);
    const section = page.locator('summary', { hasText: 'Control' }).first();
    if (!(await id(page, 'lqr').isVisible())) await section.click();
    const slider = id(page, `slider-${state}`);
    for (let k = 0; k < 3; k++) {
      await slider.focus();
      await slider.press(chance.of(['ArrowRight', 'ArrowLeft', 'PageUp', 'End']));
      await some(page, chance);
    }
    await settled(page);
    await section.click();
  },
  async 'context lost'(page) {
    await page.evaluate(async () => {
      const gl = document.querySelector<HTMLCanvasElement>('[data-testid=scene]')!.getContext('webgl2')!;
      const shared = window as unknown as { soakLoss?: WEBGL_lose_context };
      const loss = (shared.soakLoss ??= gl.getExtension('WEBGL_lose_context')!);
      loss.loseContext();
      await new Promise((done) => setTimeout(done, 200));
      loss.restoreContext();
    });
    await expect(id(page, 'scene-error')).toHaveCount(0, PATIENT);
  },
  async size(page, chance) {
    await page.setViewportSize(
      chance.of([
        { width: 900, height: 600 },
        { width: 1200, height: 640 },
        { width: 760, height: 700 },
      ]),
    );
    await page.waitForTimeout(200);
    await page.setViewportSize({ width: 900, height: 600 });
  },
};
