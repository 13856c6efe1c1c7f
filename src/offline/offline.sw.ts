/**
 * The service worker: every file of the build is stored at the first visit, and the page works from there without a
 * connection. `scripts/offline.ts` puts the list of files in and writes it to `offline.js` beside the page.
 */

/** Path from the page and a revision; a file of another content has another revision. */
declare const __BUILT_FILES__: readonly (readonly [path: string, revision: string])[];

const worker = self as unknown as ServiceWorkerGlobalScope;
const files = new Map(__BUILT_FILES__);
const scope = worker.registration.scope;
const CACHE = `ripstik-lab ${scope}`;
const LIST = `${scope}?files`;
/** At once: enough to use the line, few enough to leave the page its own. */
const ABREAST = 4;

const keyOf = (path: string, revision: string): string => `${scope}${path}?${revision}`;
const keys = [...files].map(([path, revision]) => keyOf(path, revision));

worker.addEventListener('install', (event) => event.waitUntil(store()));
worker.addEventListener('activate', (event) => event.waitUntil(takeOver()));
worker.addEventListener('message', (event) => {
  if (event.data === 'take over') void worker.skipWaiting();
});
worker.addEventListener('fetch', (event) => {
  if (event.request.method !== 'GET') return;
  const { origin, pathname } = new URL(event.request.url);
  const plain = origin + pathname;
  if (!plain.startsWith(scope)) return;
  const key = storedKey(plain);
  event.respondWith(key ? answer(key, event.request) : answerOld(plain, event.request));
});

/** What is new is fetched; what neither this version nor the one in use needs goes. */
async function store(): Promise<void> {
  const cache = await caches.open(CACHE);
  const inUse = ((await (await cache.match(LIST))?.json()) ?? []) as string[];
  const wanted = new Set([LIST, ...keys, ...inUse]);
  const there = new Set<string>();
  for (const { url } of await cache.keys()) {
    if (wanted.has(url)) there.add(url);
    else await cache.delete(url);
  }
  const missing = [...files].filter(([path, revision]) => !there.has(keyOf(path, revision)));
  const lines = Array.from({ length: ABREAST }, async () => {
    for (let next = missing.pop(); next; next = missing.pop()) await fetchInto(cache, ...next);
  });
  await Promise.all(lines);
}

async function fetchInto(cache: Cache, path: string, revision: string): Promise<void> {
  const response = await fetch(scope + path, { cache: 'no-cache' });
  if (!response.ok) throw new Error(`${path}: the server answered ${response.status}`);
  await cache.put(keyOf(path, revision), response);
}

async function takeOver(): Promise<void> {
  const cache = await caches.open(CACHE);
  await cache.put(LIST, new Response(JSON.stringify(keys)));
  await worker.clients.claim();
}

/** The page itself under either of its addresses, whatever is asked of it; files by their path. */
function storedKey(plain: string): string | null {
  const path = decodeURI(plain.slice(scope.length)) || 'index.html';
  const revision = files.get(path);
  return revision === undefined ? null : keyOf(path, revision);
}

async function answer(key: string, request: Request): Promise<Response> {
  const cache = await caches.open(CACHE);
  return (await cache.match(key)) ?? fetch(request);
}

/** A tab that still shows the version before asks for its files: they stay until the next one is stored. */
async function answerOld(plain: string, request: Request): Promise<Response> {
  const cache = await caches.open(CACHE);
  return (await cache.match(plain, { ignoreSearch: true })) ?? fetch(request);
}
