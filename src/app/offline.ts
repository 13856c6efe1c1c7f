/** Registers the service worker and says when a new version of the page is ready. Loaded when the page has come to rest. */
import { offlineText as text } from './words.ts';
import type { App } from './app.ts';

export async function workOffline(app: App): Promise<void> {
  let registration: ServiceWorkerRegistration | undefined;
  try {
    registration = await navigator.serviceWorker.register('./offline.js');
  } catch {
    return; // forbidden, or the page lies where none can be: it works with a connection
  }
  // A browser that blocks them may say so by giving nothing.
  if (!registration) return;
  followTakeOver(app);
  if (registration.waiting) tell(app, registration.waiting);
  registration.addEventListener('updatefound', () => {
    const next = registration.installing;
    next?.addEventListener('statechange', () => {
      if (next.state === 'installed' && navigator.serviceWorker.controller) tell(app, next);
    });
  });
}

/** The person has been told, and has a button for it. */
let told = false;

/** Another tab took a new version over: this one goes on with its own files, and says what it is. */
function followTakeOver(app: App): void {
  const { serviceWorker } = navigator;
  // The first worker of all takes over a page of its own version.
  let before = serviceWorker.controller;
  serviceWorker.addEventListener('controllerchange', () => {
    if (before && !told)
      app.actions.report('info', text.updated, [text.updatedHint], {
        label: text.reload,
        run: () => location.reload(),
      });
    before = serviceWorker.controller;
  });
}

function tell(app: App, next: ServiceWorker): void {
  told = true;
  app.actions.report('info', text.update, [text.updateHint], {
    label: text.reload,
    run() {
      // Another tab may have taken it meanwhile.
      if (next.state === 'activated') return location.reload();
      navigator.serviceWorker.addEventListener('controllerchange', () => location.reload(), { once: true });
      next.postMessage('take over');
    },
  });
}
