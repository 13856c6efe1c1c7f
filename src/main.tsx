import { signal } from '@preact/signals';
import { render } from 'preact';
import { createApp } from './app/store.ts';
import { stageOf } from './app/stage.ts';
import { formulations, methods } from './core/integrators/registry.ts';
import { Shell } from './ui/shell.tsx';
import { connectScene } from './sceneBridge.ts';

const app = createApp(
  {
    run: () => new Worker(new URL('./worker/run.worker.ts', import.meta.url), { type: 'module' }),
    csv: () => new Worker(new URL('./io/csv.worker.ts', import.meta.url), { type: 'module' }),
  },
  { dark: matchMedia('(prefers-color-scheme: dark)').matches, reducedMotion: matchMedia('(prefers-reduced-motion: reduce)').matches },
);
const stage = stageOf(app);
const sceneError = signal<string | null>(null);

render(
  <Shell
    app={app}
    methods={methods.map(({ id, label, adaptive }) => ({ id, label, adaptive }))}
    formulations={formulations}
    origin={app.state.origin}
    sceneText={stage.description}
    sceneError={sceneError}
    onCanvas={(canvas) => void connectScene(canvas, app, stage, sceneError)}
  />,
  document.getElementById('app')!,
);

app.actions.open();
