// npm run icons: draws public/icons from public/favicon.svg in a headless browser, for systems that install the page.
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { findBrowser } from './browser.mjs';
import { install, main, root } from './setup.mjs';
import { smallPng } from './smallPng.mjs';

/** Systems cut a maskable icon to any shape that holds the inner 80 %, and round the corners of others themselves. */
const ICONS = {
  '192.png': { size: 192, drawn: 1 },
  '512.png': { size: 512, drawn: 1 },
  'maskable-512.png': { size: 512, drawn: 0.72 },
};
const GROUND = '#14181c';

main(async () => {
  await install();
  const { chromium } = await import('@playwright/test');
  const svg = readFileSync(join(root, 'public/favicon.svg'), 'utf8').replace(/ rx="\d+"/, '');
  const folder = join(root, 'public/icons');
  mkdirSync(folder, { recursive: true });
  const browser = await chromium.launch({ executablePath: (await findBrowser()) || undefined });
  try {
    for (const [name, { size, drawn }] of Object.entries(ICONS)) {
      const page = await browser.newPage({ viewport: { width: size, height: size }, deviceScaleFactor: 1 });
      const part = `${100 * drawn}%`;
      const style = `margin:0;height:100vh;display:grid;place-items:center;background:${GROUND}`;
      await page.setContent(
        `<body style="${style}"><img style="width:${part}" src="data:image/svg+xml,${encodeURIComponent(svg)}">`,
      );
      const png = smallPng(await page.screenshot());
      writeFileSync(join(folder, name), png);
      console.log(`${name.padEnd(18)} ${(png.length / 1000).toFixed(1)} kB`);
      await page.close();
    }
  } finally {
    await browser.close();
  }
  return 0;
});
