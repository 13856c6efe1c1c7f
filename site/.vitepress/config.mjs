// The site: docs/, lessons/ and the texts at the repository's root as VitePress pages. `npm run site` builds it, with the API
// reference and the laboratory beside it.
import { cpSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { defineConfig } from 'vitepress';
import { documents, slug } from './markdown.mjs';
import { checkPages, noPages, rewrites, root, sidebar } from './pages.mjs';

checkPages();
const out = join(root, 'site/dist');
/** Of the repository, shown or linked by a page, and no page: these by the first one. */
const files = new Set(['docs/pictures/ridden-light.webp', 'docs/pictures/ridden-dark.webp']);
const data = JSON.parse(readFileSync(join(root, '.cache/site/data.json'), 'utf8'));
const { version } = JSON.parse(readFileSync(join(root, 'package.json'), 'utf8'));
/** Made up by scripts/site.mjs; scripts/site/anywhere.mjs replaces it by each page’s own way to the site’s folder. */
const BASE = process.env.RIPSTIK_SITE_BASE ?? '/';

/** KaTeX's style sheet names each font three times; every browser that runs the laboratory reads woff2. */
const woff2Only = {
  name: 'woff2-only',
  enforce: 'pre',
  transform: (code, id) =>
    /katex[\w.-]*\.css/.test(id)
      ? code.replace(/,\s*url\([^)]*\.(?:woff|ttf)\)\s*format\(["'](?:woff|truetype)["']\)/g, '')
      : undefined,
};

/** The pages lie above the site's packages, where Vite does not find Vue by itself. */
const vueOfTheSite = {
  name: 'vue-of-the-site',
  enforce: 'pre',
  resolveId(id, _, { ssr }) {
    if (!/^vue($|\/)/.test(id)) return null;
    return ssr ? { id, external: true } : this.resolve(id, join(root, 'site/index.md'), { skipSelf: true });
  },
};

export default defineConfig({
  title: 'RipStik Lab',
  description: 'A laboratory in the browser for the caster board: documentation, lessons, gallery.',
  lang: 'en',
  base: BASE,
  srcDir: root,
  outDir: out,
  cacheDir: join(root, '.cache/site/vitepress'),
  srcExclude: noPages(),
  rewrites,
  ignoreDeadLinks: true, // scripts/site/links.mjs looks at what was built: anchors, files, the reference and the laboratory too
  head: [['link', { rel: 'icon', type: 'image/svg+xml', href: `${BASE}app/favicon.svg` }]],
  markdown: {
    anchor: { slugify: slug },
    attrs: { disable: true }, // braces belong to formulas
    theme: { light: 'github-light-high-contrast', dark: 'github-dark-high-contrast' },
    languageAlias: { mjcf: 'xml' },
    config: (md) => documents(md, data, files),
  },
  buildEnd: () => files.forEach((file) => cpSync(join(root, file), join(out, file))),
  themeConfig: {
    logo: '/app/favicon.svg',
    nav: [
      { text: 'Documents', link: '/start.html', activeMatch: '/(start|docs/)' },
      { text: 'Lessons', link: '/lessons/', activeMatch: '/lessons/' },
      { text: 'Gallery', link: '/gallery.html' },
      { text: 'Reference', link: '/api/index.html', target: '_self' },
      { text: 'Laboratory', link: '/app/index.html', target: '_self' },
    ],
    sidebar: sidebar(),
    outline: [2, 3],
    search: { provider: 'local' },
    docFooter: { prev: 'Before', next: 'Next' },
    externalLinkIcon: true,
    footer: { message: `RipStik Lab ${version}, MIT licence`, copyright: '' },
  },
  vite: {
    configFile: false,
    publicDir: false,
    plugins: [woff2Only, vueOfTheSite],
    ssr: { external: ['vue', '@vue/server-renderer'] },
    build: { chunkSizeWarningLimit: 1500 },
  },
});
