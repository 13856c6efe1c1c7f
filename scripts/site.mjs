// npm run site: documents, gallery, lessons, the API reference and the laboratory as one folder of static files, site/dist, which works
// from any folder of any web server. VitePress has packages of its own in site/, installed when they are missing.
import { existsSync, mkdirSync, readFileSync, statSync, writeFileSync } from 'node:fs';
import { join, posix } from 'node:path';
import { anywhere, filesIn } from './site/anywhere.mjs';
import { deadLinks } from './site/links.mjs';
import { Plain, cache, install, main, readJson, root, run, runPackage } from './setup.mjs';

const BASE = '/--site--/';
const here = join(root, 'site');
const out = join(here, 'dist');

async function step(what, { code, output }) {
  if (code !== 0) throw new Plain(`${what} failed.\n${output ?? ''}`);
}

/** Whether site/node_modules holds the VitePress that the lock file names. */
function packagesThere() {
  const manifest = join(here, 'node_modules/vitepress/package.json');
  return (
    existsSync(manifest) &&
    readJson(manifest).version === readJson(join(here, 'package.json')).devDependencies.vitepress
  );
}

/** TypeDoc knows no link to a page beside its own: it writes a made-up address, and each page says how far up it is. */
function referenceLinks() {
  for (const page of filesIn(join(out, 'api'), /\.html$/)) {
    const file = join(out, 'api', page);
    const up = `${posix.relative(posix.dirname(page), '.') || '.'}/../`;
    writeFileSync(file, readFileSync(file, 'utf8').replaceAll('https://site.invalid/', posix.normalize(up)));
  }
}

main(async () => {
  await install();
  if (!packagesThere()) {
    console.log('Installing the packages of the site (once) …');
    const npm = process.platform === 'win32' ? 'npm.cmd' : 'npm';
    const options = ['ci', '--ignore-scripts', '--no-audit', '--no-fund', '--loglevel=error'];
    await step('npm ci in site/', await run(npm, options, { cwd: here, shell: process.platform === 'win32' }));
  }
  mkdirSync(join(cache, 'site'), { recursive: true });
  const data = join(cache, 'site/data.json');
  await step('What the pages show', await run(process.execPath, ['--import', 'tsx', 'scripts/site-data.ts', data]));
  const vitepress = join(here, 'node_modules/vitepress/bin/vitepress.js');
  const env = { RIPSTIK_SITE_BASE: BASE };
  await step('VitePress', await run(process.execPath, [vitepress, 'build', here], { env }));
  anywhere(out, BASE);
  await step(
    'The API reference',
    await runPackage('typedoc/bin/typedoc', ['--options', join(here, 'typedoc.json'), '--logLevel', 'Warn']),
  );
  referenceLinks();
  const page = ['build', '--outDir', join(out, 'app'), '--emptyOutDir', '--logLevel', 'warn'];
  await step('The laboratory', await runPackage('vite/bin/vite.js', page, { env: { RIPSTIK_SITE: '../' } }));

  const { pages, links, dead } = deadLinks(out);
  if (dead.length > 0) throw new Plain(`${dead.length} of ${links} links lead nowhere:\n  ${dead.join('\n  ')}`);
  const bytes = filesIn(out, /./).reduce((sum, path) => sum + statSync(join(out, path)).size, 0);
  console.log(
    `site/dist: ${pages} pages, ${links} links, all of which lead somewhere; ${(bytes / 1e6).toFixed(1)} MB.`,
  );
  console.log('To look at it: node scripts/serve-dist.mjs --folder site/dist --port 4200');
  return 0;
});
