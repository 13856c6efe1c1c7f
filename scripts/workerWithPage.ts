// A Vite plugin: the worker is built together with the page, so that what both take is built, and loaded, once.
import { fileURLToPath } from 'node:url';
import type { Plugin } from 'vite';

const WORKER = fileURLToPath(new URL('../src/compute/worker.ts', import.meta.url));
const STARTER = /\/src\/compute\/client\/startWorker\.ts$/;
const ADDRESS = "new URL('../worker.ts', import.meta.url)";
const PRELOAD = '\0vite/preload-helper.js';
/** The page's own first scripts. */
const ENTRY = /^assets\/(?:index|page)-/;

export function workerWithPage(): Plugin {
  let reference: string;
  return {
    name: 'worker-with-page',
    apply: 'build',
    enforce: 'pre',
    config: () => ({
      build: {
        modulePreload: {
          // A script that a worker may run can tell no document what it will need; style sheets are the page's anyway.
          resolveDependencies: (_, files, { hostId, hostType }) =>
            hostType === 'html' || ENTRY.test(hostId) ? files : files.filter((file) => file.endsWith('.css')),
        },
      },
    }),
    buildStart() {
      reference = this.emitFile({ type: 'chunk', id: WORKER, name: 'worker' });
    },
    transform(code, id) {
      // A worker has no window to tell of a script that could not be loaded.
      if (id === PRELOAD) return code.replaceAll('window.', 'globalThis.');
      if (!STARTER.test(id)) return;
      if (!code.includes(ADDRESS)) this.error(`${id} does not name the worker by ${ADDRESS}`);
      return code.replace(ADDRESS, `import.meta.ROLLUP_FILE_URL_${reference}`);
    },
  };
}
