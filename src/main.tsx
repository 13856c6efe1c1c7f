import { effect, signal } from '@preact/signals';
import { render } from 'preact';
import { createApp } from './app/store.ts';
import { stageOf } from './app/stage.ts';
import { formulations, methods } from './core/integrators/registry.ts';
import { Shell } from './ui/shell.tsx';
import { connectScene } from './sceneBridge.ts';
import './ui/style.css';

const app = createApp(
  {
    run: () => new Worker(new URL('./worker/run.worker.ts', import.meta.url), { type: 'module' }),
    csv: () => new Worker(new URL('./io/csv.worker.ts', import.meta.url), { type: 'module' }),
  },
  matchMedia('(prefers-color-scheme: dark)').matches,
);
const stage = stageOf(app);
const sceneError = signal<string | null>(null);

effect(() => void (document.documentElement.dataset['theme'] = app.state.theme.value));

render(
  <Shell
    app={app}
    methods={methods.map(({ id, label, adaptive }) => ({ id, label, adaptive }))}
    formulations={formulations}
    sceneText={stage.description}
    sceneError={sceneError}
    onCanvas={(canvas) => void connectScene(canvas, app, stage, sceneError)}
  />,
  document.getElementById('app')!,
);

app.actions.run();
