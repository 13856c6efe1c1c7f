// What the program's own server says of scripts: the page's policy with every answer, WebAssembly for the compute worker alone.
import { copyFileSync, mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import type { Server } from 'node:http';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { expect, test } from 'vitest';

test('every answer carries the policy of index.html; the worker alone may compile WebAssembly', async () => {
  const folder = mkdtempSync(join(tmpdir(), 'served-'));
  mkdirSync(join(folder, 'assets'));
  copyFileSync('index.html', join(folder, 'index.html'));
  for (const name of ['worker-Ab_1.js', 'index-Ab_1.js']) writeFileSync(join(folder, 'assets', name), '');
  const { serve } = (await import(new URL('../../scripts/serve-dist.mjs', import.meta.url).href)) as {
    serve(options: { port: number; folder: string }): Promise<{ server: Server; port: number }>;
  };
  const { server, port } = await serve({ port: 48600, folder });
  try {
    const scripts = async (path: string): Promise<string | undefined> => {
      const policy = (await fetch(`http://127.0.0.1:${port}/${path}`)).headers.get('Content-Security-Policy');
      return policy?.split('; ').find((rule) => rule.startsWith('script-src'));
    };
    expect(await scripts('')).toBe("script-src 'self'");
    expect(await scripts('assets/index-Ab_1.js')).toBe("script-src 'self'");
    expect(await scripts('assets/worker-Ab_1.js')).toBe("script-src 'self' 'wasm-unsafe-eval'");
  } finally {
    server.close();
    rmSync(folder, { recursive: true });
  }
});
