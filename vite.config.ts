import { readFileSync } from 'node:fs';
import { defineConfig } from 'vitest/config';
import { chunkList } from './scripts/chunks.ts';
import { fileOf } from './scripts/fewerFiles.ts';
import { licences } from './scripts/licences.ts';
import { leanThree } from './scripts/leanThree.ts';
import { offline } from './scripts/offline.ts';
import { workerWithPage } from './scripts/workerWithPage.ts';

const { version } = JSON.parse(readFileSync(new URL('package.json', import.meta.url), 'utf8')) as { version: string };

/** `ripstik` for its equations, `ripstik-accelerations` for their tape, `ripstik-drawing`, `ripstik-typeset`. */
function nameOf(module: string): string {
  const [, id, part] =
    /systems\/([\w-]+)\/(equations|jacobians|accelerations|drawing|typeset)(?:\.generated)?\.(?:ts|json)$/.exec(
      module,
    ) ?? [];
  return id ? (part === 'equations' ? id : `${id}-${part}`) : '[name]';
}

/** A system's dynamics are a file named after it, so that sizes and network logs can be read. */
const chunkFileNames = ({ facadeModuleId }: { facadeModuleId: string | null }): string =>
  `assets/${nameOf(facadeModuleId ?? '')}-[hash].js`;

/** KaTeX's style sheet names each font three times; every browser that runs this page reads woff2. */
const woff2Only = {
  name: 'woff2-only',
  enforce: 'pre' as const,
  transform: (code: string, id: string) =>
    /katex[\w.-]*\.css/.test(id)
      ? code.replace(/,\s*url\([^)]*\.(?:woff|ttf)\)\s*format\(["'](?:woff|truetype)["']\)/g, '')
      : undefined,
};

/** The development server puts style sheets into the page as elements, which the page's own policy forbids. */
const developersStyles = {
  name: 'developers-styles',
  apply: 'serve' as const,
  transformIndexHtml: (html: string) => html.replace("style-src 'self'", "style-src 'self' 'unsafe-inline'"),
};

export default defineConfig({
  base: './', // the built page works from any sub-path of any host
  define: {
    __RIPSTIK_VERSION__: JSON.stringify(version),
    /** Where the site lies as seen from the page, if the page is a part of it: `npm run site` says so. */
    __RIPSTIK_SITE__: JSON.stringify(process.env['RIPSTIK_SITE'] ?? ''),
  },
  plugins: [woff2Only, developersStyles, leanThree(), workerWithPage(), chunkList(), licences(), offline()],
  oxc: { jsx: { runtime: 'automatic', importSource: 'preact' } },
  build: {
    target: 'es2022',
    sourcemap: false,
    chunkSizeWarningLimit: 1500,
    assetsInlineLimit: (file) => (file.endsWith('.woff2') ? false : undefined),
    rolldownOptions: {
      output: {
        chunkFileNames,
        codeSplitting: { includeDependenciesRecursively: false, groups: [{ name: fileOf() }] },
      },
    },
  },
  test: {
    include: ['tests/**/*.test.{ts,tsx}', 'src/features/**/*.test.{ts,tsx}', 'tools/**/*.test.ts'], // *.spec.ts are for Playwright
    environment: 'node',
    coverage: {
      provider: 'v8',
      include: ['src/**/*.{ts,tsx}'],
      exclude: ['**/*.generated.ts', '**/*.{test,spec}.{ts,tsx}'],
      reporter: ['text-summary', 'json-summary'],
      reportsDirectory: '.cache/coverage',
    },
    testTimeout: 120_000, // no test asserts a time; this one only ends a test that hangs
    hookTimeout: 120_000,
    maxWorkers: '100%', // by default one core is left idle, on small machines half of them
  },
});
