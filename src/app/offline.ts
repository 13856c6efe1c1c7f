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
  if (registration.waiting) tell(app, registration.waiting);
  registration.addEventListener('updatefound', () => {
    const next = registration.installing;
    next?.addEventListener('statechange', () => {
      if (next.state === 'installed' && navigator.serviceWorker.controller) tell(app, next);
    });
  });
}

function tell(app: App, next: ServiceWorker): void {
  app.actions.report('info', text.update, [text.updateHint], {
    label: text.reload,
    run() {
      navigator.serviceWorker.addEventListener('controllerchange', () => location.reload(), { once: true });
      next.postMessage('take over');
    },
  });
}
