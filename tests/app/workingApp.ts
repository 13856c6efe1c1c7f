/** The application without a page, whose workers compute in this thread. */
import { vi } from 'vitest';
import type { App } from '../../src/app/app.ts';
import { Comparison } from '../../src/app/runs/comparison.ts';
import { Sweep } from '../../src/app/runs/sweep.ts';
import { createApp, systemMetas } from '../../src/app/store.ts';
import { Compute } from '../../src/compute/client/compute.ts';
import { NearWorker } from '../compute/nearWorker.ts';

const workers: NearWorker[] = [];

export function workingApp(): App {
  vi.stubGlobal('requestAnimationFrame', () => 0);
  vi.stubGlobal('cancelAnimationFrame', () => undefined);
  const compute = new Compute(
    () => {
      const worker = new NearWorker();
      workers.push(worker);
      return worker;
    },
    systemMetas,
    1,
  );
  const { comparison, sweep } = { comparison: new Comparison(compute.comparison), sweep: new Sweep(compute.sweep) };
  return createApp(compute, { dark: false, reducedMotion: true, roomy: false }, comparison, sweep);
}

/** After each test. */
export function endWorkers(): void {
  for (const worker of workers.splice(0)) worker.terminate();
}
