// The application without a page: workers that never answer, no frames.
import { vi } from 'vitest';
import type { App } from '../../src/app/app.ts';
import { Comparison } from '../../src/app/runs/comparison.ts';
import { Sweep } from '../../src/app/runs/sweep.ts';
import { createApp, systemMetas, type Preferences } from '../../src/app/store.ts';
import { Compute } from '../../src/compute/client/compute.ts';
import type { WorkerLike } from '../../src/compute/remote/remoteWorker.ts';
import type { BrowserStorage } from '../../src/app/persistence/browserStorage.ts';

/** Takes every message and answers none. */
const silent = (): WorkerLike => ({
  addEventListener: () => undefined,
  postMessage: () => undefined,
  terminate: () => undefined,
});

export function appOf(preferences: Partial<Preferences> = {}): App {
  vi.stubGlobal('requestAnimationFrame', () => 0);
  vi.stubGlobal('cancelAnimationFrame', () => undefined);
  const compute = new Compute(silent, systemMetas, 1);
  return createApp(
    compute,
    { dark: false, reducedMotion: true, roomy: false, ...preferences },
    new Comparison(compute.comparison),
    new Sweep(compute.sweep),
  );
}

/** A browser's storage that one can look into. */
export function storageOf(texts: Record<string, string> = {}) {
  const large = new Map<string, unknown>();
  const storage: BrowserStorage = {
    text: (name) => texts[name] ?? null,
    putText: (name, text) => {
      texts[name] = text;
      return null;
    },
    large: (name) => Promise.resolve(large.get(name)),
    putLarge: (name, value) => {
      large.set(name, value);
      return Promise.resolve(null);
    },
    clear: () => {
      for (const name of Object.keys(texts)) delete texts[name];
      large.clear();
      return Promise.resolve(null);
    },
  };
  return { storage, texts, large };
}
