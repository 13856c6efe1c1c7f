// A static server for dist, without a dependency: `npm start` and the browser tests serve the page with it.
// On its own: node scripts/serve-dist.mjs --port 4199 --base /lab/ --folder site/dist
import { createReadStream, readFileSync, statSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname, join, normalize, resolve, sep } from 'node:path';
import { fileURLToPath } from 'node:url';
import { Plain, main, root } from './setup.mjs';

const TYPES = {
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript; charset=utf-8',
  '.mjs': 'text/javascript; charset=utf-8',
  '.css': 'text/css; charset=utf-8',
  '.json': 'application/json; charset=utf-8',
  '.webmanifest': 'application/manifest+json; charset=utf-8',
  '.csv': 'text/csv; charset=utf-8',
  '.mdl': 'text/plain; charset=utf-8',
  '.mat': 'text/plain; charset=utf-8',
  '.txt': 'text/plain; charset=utf-8',
  '.md': 'text/plain; charset=utf-8',
  '.svg': 'image/svg+xml',
  '.png': 'image/png',
  '.jpg': 'image/jpeg',
  '.ico': 'image/x-icon',
  '.wasm': 'application/wasm',
  '.woff2': 'font/woff2',
};

function fileFor(url, base, folder) {
  let path;
  try {
    path = decodeURIComponent(new URL(url, 'http://localhost').pathname);
  } catch (_) {
    return null;
  }
  if (!path.startsWith(base) || path.includes('\0')) return null;
  const file = normalize(join(folder, path.slice(base.length)));
  if (file !== folder && !file.startsWith(folder + sep)) return null;
  for (const candidate of [file, join(file, 'index.html')]) {
    try {
      const entry = statSync(candidate);
      if (entry.isFile()) return { path: candidate, size: entry.size };
    } catch (_) {
      // Not there: the next candidate, or 404.
    }
  }
  return null;
}

const COMPUTE_WORKER = /[\\/]assets[\\/]worker-[^\\/]+\.js$/;

/** The Content-Security-Policy that the page itself names. */
function policyOf(folder, file) {
  try {
    const policy = /http-equiv="Content-Security-Policy"\s+content="([^"]+)"/.exec(
      readFileSync(join(folder, 'index.html'), 'utf8'),
    );
    if (!policy) return {};
    // The compute worker may compile WebAssembly, which evaluates no script; the page itself may not.
    const compiling = COMPUTE_WORKER.test(file)
      ? policy[1].replace("script-src 'self'", "$& 'wasm-unsafe-eval'")
      : policy[1];
    return { 'Content-Security-Policy': compiling };
  } catch (_) {
    return {};
  }
}

function answer(request, response, base, folder) {
  if (base !== '/' && request.url === base.slice(0, -1)) {
    response.writeHead(302, { Location: base }).end();
    return;
  }
  const file = request.method === 'GET' || request.method === 'HEAD' ? fileFor(request.url, base, folder) : null;
  if (!file) {
    response.writeHead(404, { 'Content-Type': 'text/plain; charset=utf-8' }).end('Not found\n');
    return;
  }
  response.writeHead(200, {
    'Content-Type': TYPES[extname(file.path).toLowerCase()] || 'application/octet-stream',
    'Content-Length': file.size,
    'Cache-Control': 'no-store',
    'X-Content-Type-Options': 'nosniff',
    'Referrer-Policy': 'no-referrer',
    // Workers come under the policy of their own answer, not of the page's.
    ...policyOf(folder, file.path),
  });
  if (request.method === 'HEAD') response.end();
  else
    createReadStream(file.path)
      .on('error', () => response.destroy())
      .pipe(response);
}

function listen(port, base, folder) {
  return new Promise((done, fail) => {
    const server = createServer((request, response) => answer(request, response, base, folder));
    server.once('error', fail);
    server.listen(port, '127.0.0.1', () => done(server));
  });
}

/** Serves `folder` under `base` on the first free port from `port` on (0: any); gives the server and its port. */
export async function serve({ port, base = '/', folder = join(root, 'dist'), tries = 20 }) {
  for (let next = port; next < port + tries && next < 65536; next++) {
    try {
      const server = await listen(next, base, resolve(folder));
      return { server, port: server.address().port };
    } catch (error) {
      if (error.code === 'EACCES')
        throw new Plain(`Port ${next} may not be used by this account; choose one above 1023.`);
      if (error.code !== 'EADDRINUSE') throw error;
    }
  }
  if (tries === 1) throw new Plain(`Port ${port} is busy.`);
  throw new Plain(`Ports ${port} to ${Math.min(port + tries, 65536) - 1} are busy; name another with --port.`);
}

if (process.argv[1] && resolve(process.argv[1]) === fileURLToPath(import.meta.url)) {
  main(async (args) => {
    const value = (name, otherwise) => (args.includes(name) ? args[args.indexOf(name) + 1] : otherwise);
    const base = value('--base', '/');
    const folder = resolve(value('--folder', join(root, 'dist')));
    const { port } = await serve({ port: Number(value('--port', '4199')), base, folder, tries: 1 });
    console.log(`http://127.0.0.1:${port}${base}`);
  });
}
