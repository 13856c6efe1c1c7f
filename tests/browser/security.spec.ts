// The built page under its own Content-Security-Policy: everything works, nothing else gets in or out.
import { expect, test, type Page } from '@playwright/test';
import { openPage, withoutScene } from './helpers.ts';

test.use({ viewport: { width: 800, height: 560 } });

const policy = (page: Page) => page.locator('meta[http-equiv="Content-Security-Policy"]').getAttribute('content');
const violations = (page: Page) => page.evaluate(() => window.cspViolations);

test('every part opens under the strict policy, and asks no one else for anything', async ({ page }) => {
  const watch = await openPage(page);
  const rules = new Map(
    (await policy(page))!.split('; ').map((rule) => [rule.split(' ')[0]!, rule.split(' ').slice(1)]),
  );
  expect(rules.get('default-src')).toEqual(["'none'"]);
  for (const [name, sources] of rules)
    for (const source of sources) {
      expect(["'self'", "'none'", ...(name === 'img-src' ? ['blob:', 'data:'] : [])], `${name} ${source}`).toContain(
        source,
      );
    }
  for (const tool of await page.locator('.rail [data-testid^=tool-]').all()) {
    await tool.click();
    await expect(tool).toHaveAttribute('aria-expanded', 'true');
    await page.waitForLoadState('networkidle');
  }
  await page.getByTestId('case-menu').click();
  await expect(page.locator('dialog img').first()).toBeVisible();
  await page.keyboard.press('Escape');
  await page.getByTestId('export-menu').click();
  await page.getByTestId('export-more').click();
  for (const tab of ['picture', 'video', 'glb']) await page.getByTestId(`export-tab-${tab}`).click();
  await page.keyboard.press('Escape');
  expect(await violations(page)).toEqual([]);
  expect(watch).toEqual({ errors: [], foreign: [] });
});

test('scripts, styles, evaluations, frames and requests of strangers are refused', async ({ page, context }) => {
  await withoutScene(context);
  await page.addInitScript(() => {
    window.cspViolations = [];
    document.addEventListener('securitypolicyviolation', (event) =>
      window.cspViolations.push(`${event.effectiveDirective}: ${event.blockedURI}`),
    );
  });
  await page.goto('./');
  await expect(page.getByTestId('run-state')).toHaveAttribute('data-reason', 'end');
  const reached: string[] = [];
  await context.route('https://stranger.example/**', (route) => {
    reached.push(route.request().url());
    return route.fulfill({ body: '' });
  });
  const done = await page.evaluate(async () => {
    const ran: string[] = [];
    Object.assign(window, { ran });
    // What the test's own protocol calls may evaluate text; what the page calls later may not.
    await new Promise((rest) => setTimeout(rest));
    const put = (html: string) => document.body.append(document.createRange().createContextualFragment(html));
    put('<script>window.ran.push("inline script")</script>');
    put('<img src="data:," onerror="window.ran.push(\'inline handler\')">');
    put('<script src="https://stranger.example/a.js"></script>');
    put('<iframe src="https://stranger.example/frame"></iframe>');
    put('<style>body { letter-spacing: 7px }</style>');
    put('<form action="https://stranger.example/form" id="stranger"></form>');
    document.querySelector<HTMLFormElement>('#stranger')!.submit();
    try {
      (0, eval)('window.ran.push("eval")');
    } catch {
      /* refused */
    }
    try {
      new Function('window.ran.push("Function")')();
    } catch {
      /* refused */
    }
    try {
      await fetch('https://stranger.example/data');
      ran.push('fetch');
    } catch {
      /* refused */
    }
    try {
      new Worker(URL.createObjectURL(new Blob(['']))).onerror = () => undefined;
    } catch {
      /* refused */
    }
    if (navigator.sendBeacon('https://stranger.example/beacon', 'x'))
      await new Promise((rest) => setTimeout(rest, 300));
    if (getComputedStyle(document.body).letterSpacing === '7px') ran.push('style');
    return ran;
  });
  expect(done).toEqual([]);
  expect(reached).toEqual([]);
  const refused = await violations(page);
  for (const what of [
    'script-src-elem: inline',
    'script-src-attr: inline',
    'script-src: eval',
    'style-src-elem: inline',
    'script-src-elem: https://stranger.example',
    'frame-src: https://stranger.example',
    'connect-src: https://stranger.example',
    'form-action: https://stranger.example',
    'worker-src: blob',
  ]) {
    expect(
      refused.some((entry) => entry.startsWith(what)),
      `${what} among ${refused.join(', ')}`,
    ).toBe(true);
  }
});
