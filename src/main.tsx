import './ui/style.css';
import { effect, signal } from '@preact/signals';
import { render } from 'preact';
import { Comparison } from './app/runs/comparison.ts';
import { createApp } from './app/store.ts';
import { Sweep } from './app/runs/sweep.ts';
import { stageOf } from './app/runs/stage.ts';
import { prepareVisit } from './app/startup.ts';
import { formulations } from './core/mechanics/formulations/formulations.ts';
import { methods } from './core/integrators/methods.ts';
import { features } from './features/registry.ts';
import './ui/kit/disposeReplaced.ts';
import { Shell } from './ui/shell/shell.tsx';
import { connectScene } from './stage/sceneBridge.ts';

const runWorker = (): Worker => new Worker(new URL('./compute/run.worker.ts', import.meta.url), { type: 'module' });
const cores = navigator.hardwareConcurrency || 2;
const comparison = new Comparison(runWorker, cores);
const sweep = new Sweep(
  () => new Worker(new URL('./compute/sweep.worker.ts', import.meta.url), { type: 'module' }),
  cores,
);
const app = createApp(
  {
    run: runWorker,
    csv: () => new Worker(new URL('./compute/csv.worker.ts', import.meta.url), { type: 'module' }),
    control: () => new Worker(new URL('./compute/control.worker.ts', import.meta.url), { type: 'module' }),
  },
  {
    dark: matchMedia('(prefers-color-scheme: dark)').matches,
    reducedMotion: matchMedia('(prefers-reduced-motion: reduce)').matches,
    roomy: innerWidth >= 1200,
  },
  comparison,
  sweep,
);
/** For scripts that take pictures, and for whoever opens the console. */
Object.assign(window, { ripstikApp: app });
const stage = stageOf(app);
const sceneError = signal<string | null>(null);
const visit = prepareVisit(
  app,
  features.flatMap(({ id, tool }) => (tool ? [id] : [])),
);

render(
  <Shell
    app={app}
    methods={methods.map(({ id, label, adaptive }) => ({ id, label, adaptive }))}
    formulations={formulations}
    origin={app.state.origin}
    features={features}
    onForget={() => void visit.keeper.forget()}
    sceneText={stage.description}
    sceneError={sceneError}
    onCanvas={(canvas) => void connectScene(canvas, app, stage, sceneError)}
  />,
  document.getElementById('app')!,
);

void visit.begin();

// After the first motion has been computed, so that storing the page for use without a connection takes nothing from it.
if (import.meta.env.PROD && 'serviceWorker' in navigator) {
  let asked = false;
  effect(() => {
    if (asked || (app.state.run.value?.kind !== 'ended' && app.state.motion.value?.source !== 'file')) return;
    asked = true;
    setTimeout(() => void import('./app/offline.ts').then(({ workOffline }) => workOffline(app)).catch(() => {}), 1000);
  });
}
