// A Vite plugin: when everything is built, writes the service worker with the list of all files of the page.
import { createHash } from 'node:crypto';
import { readdirSync, readFileSync, statSync, writeFileSync } from 'node:fs';
import { join, sep } from 'node:path';
import { fileURLToPath } from 'node:url';
import { minify, transformWithOxc, type Plugin } from 'vite';

const WORKER = fileURLToPath(new URL('../src/offline/offline.sw.ts', import.meta.url));
const NAME = 'offline.js';

export function offline(): Plugin {
  return {
    name: 'offline',
    apply: 'build',
    writeBundle: {
      order: 'post',
      async handler({ dir }) {
        const { files, bytes } = filesOf(dir!);
        const { code } = await transformWithOxc(readFileSync(WORKER, 'utf8'), WORKER);
        const { code: small } = await minify(NAME, `const __BUILT_FILES__ = ${JSON.stringify(files)};\n${code}`);
        writeFileSync(join(dir!, NAME), small);
        this.info(`${files.length} files, ${(bytes / 1e6).toFixed(2)} MB, are kept for use without a connection`);
      },
    },
  };
}

/** Every file below `folder` with the first part of its SHA-256. */
function filesOf(folder: string): { files: [path: string, revision: string][]; bytes: number } {
  const paths = readdirSync(folder, { recursive: true, encoding: 'utf8' }).filter((path) =>
    statSync(join(folder, path)).isFile(),
  );
  const names = paths
    .map((path) => path.replaceAll(sep, '/'))
    // Without a connection the pictures of the cases stand still.
    .filter((path) => path !== NAME && !path.endsWith('.map') && !path.endsWith('-loop.webp'));
  let bytes = 0;
  const files = names.sort().map((path): [string, string] => {
    const content = readFileSync(join(folder, path));
    bytes += content.length;
    return [path, createHash('sha256').update(content).digest('hex').slice(0, 16)];
  });
  return { files, bytes };
}
