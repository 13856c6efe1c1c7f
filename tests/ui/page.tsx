/**
 * The page without a browser: an app whose workers never answer, and components under the shell's context. Tests that
 * use it begin with `// @vitest-environment happy-dom`.
 */
import { render, type RenderResult } from '@testing-library/preact';
import type { ComponentChild } from 'preact';
import { Comparison } from '../../src/app/runs/comparison.ts';
import { Sweep } from '../../src/app/runs/sweep.ts';
import { createApp, systemMetas } from '../../src/app/store.ts';
import type { App } from '../../src/app/app.ts';
import type { Motion } from '../../src/app/runs/motion.ts';
import { Compute } from '../../src/compute/client/compute.ts';
import type { WorkerLike } from '../../src/compute/remote/remoteWorker.ts';
import { formulations } from '../../src/core/mechanics/formulations/formulations.ts';
import { methods } from '../../src/core/integrators/methods.ts';
import { Trajectory } from '../../src/core/motion/trajectory.ts';
import { checkScenario } from '../../src/core/scenario/schema.ts';
import type { ScenarioFile } from '../../src/core/scenario/types.ts';
import { commandsOf } from '../../src/ui/shell/commands.ts';
import { createUi, UiContext, type Ui } from '../../src/ui/context.ts';
import type { Feature } from '../../src/ui/feature.ts';
import { runOf } from '../helpers.ts';

/** A canvas to draw on that shows nothing, for the charts: happy-dom gives none. */
const blank = new Proxy({} as Record<PropertyKey, unknown>, {
  get: (held, name) =>
    held[name] ?? (name === 'measureText' ? (text: string) => ({ width: 6 * text.length }) : () => blank),
});
HTMLCanvasElement.prototype.getContext = (() => blank) as never;

/** Takes every message and answers none. */
class SilentWorker implements WorkerLike {
  addEventListener(): void {}
  postMessage(): void {}
  terminate(): void {}
}

export function testApp(): App {
  const compute = new Compute(() => new SilentWorker(), systemMetas, 1);
  return createApp(
    compute,
    { dark: false, reducedMotion: true, roomy: false },
    new Comparison(compute.comparison),
    new Sweep(compute.sweep),
  );
}

/** Puts a run of a scenario on the stage, computed here and now. */
export function putOnStage(app: App, file: ScenarioFile, source: Motion['source'] = 'run'): Motion {
  const { columns, rows } = runOf(file);
  const names = [...columns.keys()];
  const scenario = checkScenario(file, systemMetas);
  const motion: Omit<Motion, 'id'> = {
    source,
    title: 'A motion',
    system: app.systemOf(file.system)!,
    parameters: scenario.parameters,
    trajectory: Trajectory.of(
      names,
      names.map((name) => columns.get(name)!.slice(0, rows)),
    ),
    constraints: scenario.constraints,
    scenario,
    written: file,
    adjustments: [],
    issues: [],
    marks: [],
    judgement: null,
  };
  app.actions.showMotion(motion);
  app.actions.pause();
  return app.state.motion.peek()!;
}

/** Draws something as the shell would. */
export function draw(
  node: ComponentChild,
  { app = testApp(), features = [] }: { app?: App; features?: readonly Feature[] } = {},
): RenderResult & { app: App; ui: Ui } {
  const ui = createUi(app, methods, formulations, features, commandsOf(features), app.state.origin);
  return { ...render(<UiContext.Provider value={ui}>{node}</UiContext.Provider>), app, ui };
}
