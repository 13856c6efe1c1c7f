/** A page of another origin shows the stage in a frame, and speaks to it. */
import { readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import type { AddressInfo } from 'node:net';
import { expect, test } from '@playwright/test';

interface Said {
  type: string;
  id?: number;
  message?: string;
  time?: number;
  end?: number;
  playing?: boolean;
  title?: string;
  origin: string;
}

test('a frame of another origin: loads, sets, runs, tells its state', async ({ page, baseURL }) => {
  const home = new URL(baseURL!).origin;
  // Another port is another origin.
  const server = createServer((_, response) => {
    const address = `http://127.0.0.1:${(server.address() as AddressInfo).port}`;
    const frame = `${baseURL!}?embed=${encodeURIComponent(address)}#v=1&case=ridden&sum=141k9ic`;
    response.setHeader('Content-Type', 'text/html').end(`<!doctype html><title>Course</title><h1>Week 3</h1>
<iframe id="lab" src="${frame}" width="700" height="420" style="border:0"></iframe>
<script>said = []; addEventListener('message', (e) => said.push({ ...e.data, origin: e.origin }));
ask = (message) => document.getElementById('lab').contentWindow.postMessage({ ripstik: 1, ...message }, '${home}');</script>`);
  });
  await new Promise<void>((done) => server.listen(0, '127.0.0.1', done));
  await page.goto(`http://127.0.0.1:${(server.address() as AddressInfo).port}`);
  const said = () => page.evaluate<Said[]>('said');
  const answer = async (message: object): Promise<Said> => {
    await page.evaluate(`ask(${JSON.stringify(message)})`);
    await expect.poll(async () => (await said()).some(({ id }) => id === (message as Said).id)).toBe(true);
    return (await said()).find(({ id }) => id === (message as Said).id)!;
  };
  await expect.poll(async () => (await said()).map(({ type }) => type)).toContain('ready');
  const lab = page.frameLocator('#lab');
  await expect(lab.getByTestId('scene')).toBeVisible();
  await expect(lab.locator('.top, .panel, .rail, .status')).toHaveCount(0);

  const scenario = { version: 1, system: 'cart-pendulum', initial: { theta: '40 deg' }, duration: 2 };
  await answer({ id: 1, type: 'load', scenario, title: 'Pendulum of week 3' });
  await expect.poll(async () => (await said()).at(-1)).toMatchObject({ type: 'ended', time: 2 });
  await expect(lab.locator('.caption-title')).toHaveText('Pendulum of week 3');
  await answer({ id: 2, type: 'set', path: 'duration', value: 3 });
  await answer({ id: 3, type: 'run' });
  await expect.poll(async () => (await said()).at(-1)).toMatchObject({ type: 'ended', time: 3 });
  // The run plays; where it is looked at, it has to stand.
  expect(await answer({ id: 7, type: 'pause' })).toMatchObject({ playing: false });
  await answer({ id: 4, type: 'seek', time: 1.5 });
  expect(await answer({ id: 5, type: 'state' })).toMatchObject({ type: 'state', time: 1.5, end: 3 });
  await answer({ id: 8, type: 'plots', panes: [{ y: ['theta'] }] });
  await expect(lab.getByTestId('plot-pane')).toHaveCount(1);
  expect((await answer({ id: 6, type: 'set', path: 'initial.tehta', value: 1 })).message).toContain('tehta');
  expect(new Set((await said()).map(({ origin }) => origin))).toEqual(new Set([home]));
  server.close();
});

test('the example of docs/embedding.md, as it is written but for the two addresses', async ({ page, baseURL }) => {
  const [, example] = /<!-- example: embedding -->\n```html\n([^]*?)```/.exec(
    readFileSync('docs/embedding.md', 'utf8'),
  )!;
  const server = createServer((_, response) => {
    const own = `http://127.0.0.1:${(server.address() as AddressInfo).port}`;
    const text = example!
      .replaceAll('https://lab.example.org/', baseURL!)
      .replaceAll('https://lab.example.org', new URL(baseURL!).origin)
      .replaceAll('https://lms.example.org', own);
    response.setHeader('Content-Type', 'text/html').end(`<!doctype html><title>Course</title>${text}`);
  });
  await new Promise<void>((done) => server.listen(0, '127.0.0.1', done));
  await page.goto(`http://127.0.0.1:${(server.address() as AddressInfo).port}`);
  await expect(page.locator('#end')).toHaveText('end at 5 s');
  await page.evaluate(() => ((document.getElementById('end') as HTMLOutputElement).value = ''));
  await page.locator('#angle').fill('-60');
  await expect(page.locator('#end')).toHaveText('end at 5 s');
  server.close();
});
