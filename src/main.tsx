import './ui/style.css';
import { effect, signal } from '@preact/signals';
import { render } from 'preact';
import { Comparison } from './app/runs/comparison.ts';
import { createApp, systemMetas } from './app/store.ts';
import { Sweep } from './app/runs/sweep.ts';
import { stageOf } from './app/runs/stage.ts';
import { embeddingOf } from './app/embed/options.ts';
import { browserStorage, nothingStored } from './app/persistence/browserStorage.ts';
import { prepareStartup } from './app/startup.ts';
import { Compute } from './compute/client/compute.ts';
import { startWorker } from './compute/client/startWorker.ts';
import { formulations } from './core/mechanics/formulations/formulations.ts';
import { methods } from './core/integrators/methods.ts';
import * as registry from './features/registry.ts';
import { inOrder } from './ui/feature.ts';
import { Shell } from './ui/shell/shell.tsx';
import { connectScene } from './stage/sceneBridge.ts';

const features = inOrder(registry);
const compute = new Compute(startWorker, systemMetas, navigator.hardwareConcurrency || 2);
const app = createApp(
  compute,
  {
    dark: matchMedia('(prefers-color-scheme: dark)').matches,
    reducedMotion: matchMedia('(prefers-reduced-motion: reduce)').matches,
    roomy: innerWidth >= 1200,
  },
  new Comparison(compute.comparison),
  new Sweep(compute.sweep),
);
/** For scripts that take pictures, and for whoever opens the console. */
Object.assign(window, { ripstikApp: app });
const stage = stageOf(app);
const sceneError = signal<string | null>(null);
const embedding = embeddingOf(location.search);
const startup = prepareStartup(
  app,
  features.flatMap(({ id, tool }) => (tool ? [id] : [])),
  // A frame in another page neither shows nor changes what a person has here.
  embedding ? nothingStored : browserStorage,
);
const shown = {
  app,
  methods: methods.map(({ id, label, adaptive }) => ({ id, label, adaptive })),
  formulations,
  sceneText: stage.description,
  sceneError,
  onCanvas: (canvas: HTMLCanvasElement) => void connectScene(canvas, app, stage, sceneError),
};
const place = document.getElementById('app')!;

if (embedding) {
  void Promise.all([import('./app/embed/start.ts'), import('./ui/shell/embeddedShell.tsx')]).then(
    ([{ startEmbedded, wholePage }, { EmbeddedShell }]) => {
      const { shown: plotted } = startEmbedded(app, embedding, window);
      const plots = { shown: plotted, Body: features.find(({ id }) => id === 'plots')?.tool?.Body };
      const { origin } = app.state;
      render(<EmbeddedShell {...shown} origin={origin} plots={plots} address={() => wholePage(app)} />, place);
      void startup.begin();
    },
  );
} else {
  render(
    <Shell {...shown} origin={app.state.origin} features={features} onForget={() => void startup.autosave.forget()} />,
    place,
  );
  void startup.begin();
}

// After the first motion has been computed, so that storing the page for use without a connection takes nothing from it.
if (!embedding && import.meta.env.PROD && 'serviceWorker' in navigator) {
  let asked = false;
  effect(() => {
    if (asked || (app.state.run.value?.kind !== 'ended' && app.state.motion.value?.source !== 'file')) return;
    asked = true;
    setTimeout(() => void import('./app/offline.ts').then(({ workOffline }) => workOffline(app)).catch(() => {}), 1000);
  });
}
