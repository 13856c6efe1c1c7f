/** What lies over the scene: view buttons, switches, one line of what to look at. */
import type { ReadonlySignal } from '@preact/signals';
import { viewsOf } from '../../app/runs/views.ts';
import { useUi } from '../context.ts';
import { Toggle } from '../kit/controls.tsx';
import { Slot } from '../slot.tsx';
import { ForceLegend, Inset } from './stageCorners.tsx';
import { ViewMenu } from './viewMenu.tsx';
import { text } from '../words.ts';

export function StageOverlay({ sceneError }: { sceneError: ReadonlySignal<string | null> }) {
  const ui = useUi();
  const { state, actions } = ui.app;
  const motion = state.motion.value;
  const origin = ui.origin.value;
  const system = motion?.system ?? ui.system.value;
  const [tracked, forced] = [
    (system?.tracks ?? system?.contacts ?? []).length > 0,
    (system?.contacts ?? []).length > 0,
  ];
  const closeUp = system?.meta.views?.closeUp !== undefined;
  const fileTitle = motion && motion.source !== 'run' ? motion.title : null;
  return (
    <>
      <div class="caption">
        <p class="caption-title">{fileTitle ?? origin?.title ?? ''}</p>
        {!fileTitle && origin && <p>{origin.summary}</p>}
        <Slot name="caption" />
        {motion === null && state.run.value === null && <p>{text.hint}</p>}
      </div>
      {sceneError.value !== null && (
        <div class="scene-error" role="alert" data-testid="scene-error">
          <h2>{text.noScene}</h2>
          <p>{sceneError}</p>
        </div>
      )}
      <div class="stage-corner">
        {closeUp && state.showInset.value && sceneError.value === null && <Inset title={text.look.insetTitle} />}
        {forced && state.showForces.value && <ForceLegend />}
      </div>
      <div class="views">
        <Slot name="stagePad" />
        <div class="segments" role="group" aria-label={text.view.label}>
          {[...viewsOf(system?.meta.views)].map(([key, view]) => (
            <Toggle
              key={view}
              pressed={state.view.value === view}
              title={`${text.view.names[view]} (${key})`}
              testId={`view-${view}`}
              onClick={() => actions.set('view', view)}
            >
              {text.view.names[view]}
            </Toggle>
          ))}
        </div>
        <div class="view-switches">
          <div class="segments" role="group" aria-label={text.view.switches}>
            <Toggle
              pressed={state.follow.value}
              title={`${text.view.follow} (F)`}
              testId="toggle-follow"
              onClick={() => actions.toggle('follow')}
            >
              {text.view.follow}
            </Toggle>
            {tracked && (
              <Toggle
                pressed={state.showTrails.value}
                testId="toggle-trails"
                onClick={() => actions.toggle('showTrails')}
              >
                {text.view.trails}
              </Toggle>
            )}
            {forced && (
              <Toggle
                pressed={state.showForces.value}
                testId="toggle-forces"
                onClick={() => actions.toggle('showForces')}
              >
                {text.view.forces}
              </Toggle>
            )}
            <Slot name="stageSwitch" />
          </div>
          <ViewMenu closeUp={closeUp} ridden={system?.meta.views?.ridden ?? false} forced={forced} />
        </div>
      </div>
    </>
  );
}
