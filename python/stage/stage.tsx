/**
 * The stage as one file, for notebooks: what `?embed=` shows, in a frame whose text the page around it brings. That page is the one
 * that may speak to it. `scripts/stage-page.mjs` builds it.
 */
import '../../src/ui/style.css';
import { signal } from '@preact/signals';
import { render } from 'preact';
import { Comparison } from '../../src/app/runs/comparison.ts';
import { stageOf } from '../../src/app/runs/stage.ts';
import { Sweep } from '../../src/app/runs/sweep.ts';
import { startEmbedded } from '../../src/app/embed/start.ts';
import { createApp, systemMetas } from '../../src/app/store.ts';
import { Compute } from '../../src/compute/client/compute.ts';
import { startWorker } from '../../src/compute/client/startWorker.ts';
import { methods } from '../../src/core/integrators/methods.ts';
import { formulations } from '../../src/core/mechanics/formulations/formulations.ts';
import { plots } from '../../src/features/plots/manifest.tsx';
import { connectScene } from '../../src/stage/sceneBridge.ts';
import { EmbeddedShell } from '../../src/ui/shell/embeddedShell.tsx';

const compute = new Compute(startWorker, systemMetas, navigator.hardwareConcurrency || 2);
const app = createApp(
  compute,
  {
    dark: document.documentElement.dataset['theme'] === 'dark',
    reducedMotion: matchMedia('(prefers-reduced-motion: reduce)').matches,
    roomy: false,
  },
  new Comparison(compute.comparison),
  new Sweep(compute.sweep),
);
Object.assign(window, { ripstikApp: app });
const stage = stageOf(app);
const sceneError = signal<string | null>(null);
const { shown } = startEmbedded(app, { partner: '*', wrong: null }, window);
render(
  <EmbeddedShell
    app={app}
    methods={methods.map(({ id, label, adaptive }) => ({ id, label, adaptive }))}
    formulations={formulations}
    sceneText={stage.description}
    sceneError={sceneError}
    onCanvas={(canvas) => void connectScene(canvas, app, stage, sceneError)}
    origin={app.state.origin}
    plots={{ shown, Body: plots.tool!.Body }}
  />,
  document.getElementById('app')!,
);
