/** One page, used act by act: after each it is asked whether anything went wrong, and at the base what it holds is read. */
import { expect, type Page } from '@playwright/test';
import { drawn, type Watch } from '../../tests/browser/helpers.ts';
import { acts, choose, fold, settled, TOOLS, open, type Chance } from './acts.ts';
import { Gauges, type Reading } from './gauges.ts';

interface PageApp {
  state: {
    messages: { value: readonly { id: number }[] };
    pinned: { value: readonly { id: number }[] };
    draft: { value: object };
    origin: { value: object };
  };
  actions: {
    dismiss(id: number): void;
    cancelReading(): void;
    seek(time: number): void;
    compare(list: readonly object[]): void;
    setAll(settings: object): void;
    setMeshes(meshes: ReadonlyMap<string, unknown>): void;
    restoreDrafts(current: object, drafts: ReadonlyMap<string, unknown>): void;
  };
  pinned: { pin(): void; remove(id: number): void };
  comparison: { outcomes: { value: readonly { state: string }[] } };
}

declare global {
  interface Window {
    ripstikApp: PageApp;
  }
}

/** Numbers that are none, where a person would read them; what is said of a bad file may name them. */
async function strayWords(page: Page): Promise<string[]> {
  return page.evaluate(() => {
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    const found: string[] = [];
    for (let node = walker.nextNode(); node; node = walker.nextNode()) {
      const text = node.textContent ?? '';
      if (
        /\b(NaN|Infinity|undefined)\b|\[object /.test(text) &&
        !node.parentElement?.closest('[data-testid=message], .file-section, [data-testid=announcer], script, style')
      )
        found.push(text.slice(0, 80));
    }
    return found;
  });
}

export class Soak {
  readonly counts: Record<string, number> = {};
  readonly readings: Reading[] = [];
  private readonly page: Page;
  private readonly watch: Watch;
  private readonly gauges: Gauges;

  private constructor(page: Page, watch: Watch, gauges: Gauges) {
    this.page = page;
    this.watch = watch;
    this.gauges = gauges;
  }

  static async of(page: Page, watch: Watch): Promise<Soak> {
    return new Soak(page, watch, await Gauges.of(page));
  }

  /** @throws when anything went wrong, with the name of the act */
  async act(name: string, chance: Chance): Promise<void> {
    const { page } = this;
    const from = Date.now();
    try {
      await acts[name]!(page, chance);
    } catch (error) {
      throw new Error(`${name}, after ${JSON.stringify(this.counts)}: ${(error as Error).message}`, { cause: error });
    }
    this.counts[name] = (this.counts[name] ?? 0) + 1;
    for (let k = 0; k < 3 && (await page.locator('dialog[open]').count()) > 0; k++) await page.keyboard.press('Escape');
    await page.evaluate(() =>
      window.ripstikApp.state.messages.value.forEach(({ id }) => window.ripstikApp.actions.dismiss(id)),
    );
    await this.check(name);
    if (process.env['SOAK_SAY']) console.log(`${name}: ${Date.now() - from} ms`);
  }

  private async check(name: string): Promise<void> {
    const { page, watch } = this;
    await drawn(page); // the page answers
    // A context that is lost on purpose is told by the browser.
    const wrong = {
      errors: watch.errors.filter((e) => !/context (was )?lost/i.test(e)),
      foreign: watch.foreign,
      violations: await page.evaluate(() => window.cspViolations),
      words: await strayWords(page),
    };
    expect(wrong, `after ${name}, ${JSON.stringify(this.counts)}`).toEqual({
      errors: [],
      foreign: [],
      violations: [],
      words: [],
    });
  }

  /** The results of the last sweep stay in their table: at the base they are three. */
  private async smallSweep(): Promise<void> {
    const { page } = this;
    const id = (name: string) => page.getByTestId(name);
    await fold(page);
    await choose(page, 'released');
    await settled(page);
    await open(page, 'compare');
    await id('compare-sweep').click();
    for (const [field, value] of [
      ['sweep-from-0', '1'],
      ['sweep-to-0', '3'],
      ['sweep-count-0', '3'],
    ] as const) {
      if (field === 'sweep-from-0') await id('sweep-axis-0').selectOption('initial.X_dot');
      await id(field).fill(value);
    }
    await id('sweep-run').click();
    await expect(id('sweep-row-2')).toContainText('touchdown');
    await expect(id('sweep-standing')).toHaveAttribute('data-state', 'ended');
    await id('compare-runs').click();
  }

  /** Back to where a visit begins, with every tool seen and closed, and everything once drawn. */
  async base(): Promise<Reading> {
    const { page } = this;
    for (const tool of TOOLS) await open(page, tool);
    await page.waitForTimeout(300);
    await this.smallSweep();
    // As on a phone, and back: which sections of the panel are open is the page's own choice again.
    const size = page.viewportSize()!;
    for (const width of [700, size.width]) {
      await page.setViewportSize({ ...size, width });
      await page.waitForTimeout(300);
    }
    await fold(page);
    await choose(page, 'ridden');
    await settled(page);
    await page.keyboard.press('k');
    await page.evaluate(() => {
      const { state, actions, pinned } = window.ripstikApp;
      window.workerEvents.length = 0; // the rig's own record
      actions.compare([{ id: 'a', label: 'a', method: {} }]);
      actions.restoreDrafts({ draft: state.draft.value, origin: state.origin.value }, new Map());
      actions.setMeshes(new Map());
      actions.setAll({
        plots: { own: null, degrees: true, wrapped: false },
        view: 'orbit',
        theme: 'light',
        speed: 1,
        loop: false,
        follow: true,
        showTrails: true,
      });
      for (const { id } of state.pinned.value) pinned.remove(id);
      pinned.pin();
      for (const { id } of state.pinned.value) pinned.remove(id);
    });
    await page.getByTestId('scrubber').fill('3');
    // Seen from where a visit begins: which labels of the ground are in the picture, and on the card, depends on it.
    for (const view of ['top', 'orbit']) {
      await page.evaluate((name) => window.ripstikApp.actions.setAll({ view: name }), view);
      await drawn(page);
    }
    for (const on of [true, false]) {
      await page.evaluate((value) => {
        window.ripstikApp.actions.setAll({
          theme: value ? 'dark' : 'light', // a few labels that are out of sight are kept in one theme
          showForces: value,
          showNames: value,
          showFrames: value,
          showInset: value,
          dragPushes: false,
        });
      }, on);
      await drawn(page);
    }
    await expect
      .poll(() => page.evaluate(() => window.ripstikApp.comparison.outcomes.value.every((o) => o.state === 'ended')))
      .toBe(true);
    // What is let go after a while: a cancelled worker's patience, a message.
    await page.waitForTimeout(3500);
    await this.check('the base');
    const reading = await this.gauges.read();
    this.readings.push(reading);
    return reading;
  }
}

/**
 * Above the start: of script objects, of buffers (bytes), of nodes and listeners. What the graphics card holds comes back exactly,
 * and so do workers of one purpose; a purpose whose first call came later has one more.
 */
export const TOLERANCE = { objects: 2e6, buffers: 4e6, nodes: 400, listeners: 100 } as const;

/** @throws when something did not come back */
export function expectReturned(start: Reading, end: Reading): void {
  const exact = ({ doubles, geometries, textures, programs }: Reading) => ({ doubles, geometries, textures, programs });
  expect(exact(end)).toEqual(exact(start));
  for (const key of ['objects', 'buffers', 'nodes', 'listeners'] as const)
    expect(end[key] - start[key], `${key}: ${start[key]} at the start, ${end[key]} at the end`).toBeLessThan(
      TOLERANCE[key],
    );
}
