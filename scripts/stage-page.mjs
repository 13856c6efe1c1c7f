// npm run stage-page [-- FILE]: the stage as one HTML file that needs no other (`python/stage`), gzipped, for notebooks.
import { mkdirSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { build } from 'vite';
import { leanThree } from './leanThree.ts';
import { cache, main, readJson, root } from './setup.mjs';

const STARTER = /\/src\/compute\/client\/startWorker\.ts$/;

/** It fetches nothing: what it needs is inside. A worker compiles WebAssembly. */
const POLICY =
  "default-src 'none'; script-src 'unsafe-inline' 'wasm-unsafe-eval' blob:; worker-src blob:; style-src 'unsafe-inline'; img-src blob: data:; font-src data:; base-uri 'none'; form-action 'none'";

/** The worker's program is a text in the page, begun from a blob. */
const workerInside = {
  name: 'worker-inside',
  enforce: 'pre',
  transform: (_, id) =>
    STARTER.test(id)
      ? `import Inside from '../worker.ts?worker&inline';\nexport const startWorker = (purpose) => new Inside({ name: purpose });`
      : undefined,
};

/** Equations and formulas, which the stage itself never asks for, are in the worker alone, not twice. */
const equationsInWorker = {
  name: 'equations-in-worker',
  enforce: 'pre',
  transform: (code, id) =>
    /\/src\/core\/systems\/[\w-]+\/index\.ts$/.test(id)
      ? code.replace(
          /import\('(\.\/(?:equations|jacobians|accelerations|typeset)\.generated\.\w+)'\)/g,
          "Promise.reject(new Error('$1 is in the worker alone'))",
        )
      : undefined,
};

/** Builds the page. @returns its text */
async function stagePage() {
  const alone = { format: 'es', codeSplitting: false };
  const [built] = [
    await build({
      root,
      configFile: false,
      logLevel: 'warn',
      publicDir: false,
      define: { __RIPSTIK_VERSION__: JSON.stringify(readJson(join(root, 'package.json')).version) },
      plugins: [workerInside, equationsInWorker, leanThree()],
      oxc: { jsx: { runtime: 'automatic', importSource: 'preact' } },
      worker: { format: 'iife', rolldownOptions: { output: { codeSplitting: false } } },
      build: {
        target: 'es2022',
        write: false,
        modulePreload: false,
        cssCodeSplit: false,
        assetsInlineLimit: () => true,
        chunkSizeWarningLimit: 5000,
        rolldownOptions: { input: join(root, 'python/stage/stage.tsx'), output: alone },
      },
    }),
  ].flat();
  const script = built.output.find(({ type }) => type === 'chunk').code;
  const styles = built.output
    .filter(({ fileName }) => fileName.endsWith('.css'))
    .map(({ source }) => source)
    .join('\n');
  const inScript = script.replace(/<\/(script)/gi, '<\\/$1').replaceAll('<!--', '\\x3c!--');
  return `<!doctype html>
<html lang="en" data-theme="light">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="${POLICY}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>RipStik Lab</title>
<style>${styles}</style>
</head>
<body>
<div id="app"></div>
<script type="module">${inScript}</script>
</body>
</html>
`;
}

main(async ([path = join(cache, 'stage.html.gz')]) => {
  const packed = gzipSync(await stagePage(), { level: 9 });
  mkdirSync(dirname(path), { recursive: true });
  writeFileSync(path, packed);
  console.log(`${path}: ${(packed.length / 1e3).toFixed(0)} kB`);
  return 0;
});
