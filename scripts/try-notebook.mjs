// The notebook of docs/python.md, executed and exported by nbconvert, and played in a browser without a network: of
// `npm run try-wheel -- --all`.
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { findBrowser } from './browser.mjs';
import { Plain, root, run } from './setup.mjs';

/** As a file has it. */
const notebook = (sources) => ({
  nbformat: 4,
  nbformat_minor: 5,
  metadata: { kernelspec: { name: 'python3', display_name: 'Python 3' } },
  cells: sources.map((source, k) => ({
    cell_type: 'code',
    id: `c${k}`,
    metadata: {},
    execution_count: null,
    outputs: [],
    source,
  })),
});

/** @param python of an environment with the wheel, nbconvert and ipykernel @throws Plain */
export async function tryNotebook(python) {
  const code = /## In a notebook[^]*?```python\n([^]*?)```/.exec(readFileSync(join(root, 'docs/python.md'), 'utf8'))[1];
  const folder = mkdtempSync(join(tmpdir(), 'ripstik-notebook-'));
  try {
    const still = code.replace('title="Let go")', 'title="Let go", live=False)');
    writeFileSync(join(folder, 'stage.ipynb'), JSON.stringify(notebook([still])));
    const { code: status, output } = await run(
      python,
      ['-m', 'nbconvert', '--to', 'html', '--execute', join(folder, 'stage.ipynb')],
      {},
    );
    if (status !== 0) throw new Plain(`The notebook is not executed:\n${output.trim()}`);
    await plays(join(folder, 'stage.html'));
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}

/** That the stage in an exported page moves and draws its plots. @throws Plain */
async function plays(page) {
  const { chromium } = await import('@playwright/test');
  const args = ['--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist'];
  const browser = await chromium.launch({ executablePath: (await findBrowser()) || undefined, args });
  try {
    const tab = await browser.newPage({ offline: true });
    await tab.goto(pathToFileURL(page).href, { waitUntil: 'domcontentloaded' });
    const stage = tab.frameLocator('iframe[title="RipStik Lab"]').frameLocator('iframe');
    await stage.getByText('Let go', { exact: true }).waitFor({ timeout: 60_000 });
    await stage.getByTestId('plot-pane').nth(2).waitFor();
    const frame = tab.frames().at(-1);
    await frame.evaluate(() => globalThis.ripstikApp.actions.seek(0));
    await frame.evaluate(() => globalThis.ripstikApp.actions.play());
    await frame.waitForFunction(() => globalThis.ripstikApp.state.time.peek() > 0.05);
    console.log('The exported notebook plays, with its plots, without a network.');
  } finally {
    await browser.close();
  }
}
