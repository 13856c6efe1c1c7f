/** What lies over the scene: view buttons, switches, one line of what to look at. */
import type { ReadonlySignal } from '@preact/signals';
import { viewsOf } from '../../app/runs/views.ts';
import type { ViewName } from '../../app/state/settingsTable.ts';
import { useCommand, useUi } from '../context.ts';
import { Toggle } from '../kit/controls.tsx';
import { Slot } from '../slot.tsx';
import { Caption } from './caption.tsx';
import { ForceLegend, Inset } from './stageCorners.tsx';
import { ViewMenu } from './viewMenu.tsx';
import { text } from '../words.ts';

export function StageOverlay({ sceneError }: { sceneError: ReadonlySignal<string | null> }) {
  const ui = useUi();
  const { state } = ui.app;
  const motion = state.motion.value;
  const system = motion?.system ?? ui.system.value;
  const [tracked, forced] = [
    (system?.tracks ?? system?.contacts ?? []).length > 0,
    (system?.contacts ?? []).length > 0,
  ];
  const drawn = !motion || motion.system.meta.bodies.length > 0;
  const closeUp = system?.meta.views?.closeUp !== undefined;
  return (
    <>
      <Caption />
      {sceneError.value !== null && (
        <div class="scene-error" role="alert" data-testid="scene-error">
          <h2>{text.noScene}</h2>
          <p>{sceneError}</p>
        </div>
      )}
      {motion && !drawn && (
        <div class="scene-error" data-testid="no-scene">
          <h2>{text.dataOnly}</h2>
          <p>{text.dataOnlyHint}</p>
          <Slot name="noScene" />
        </div>
      )}
      <div class="stage-corner">
        {closeUp && state.showInset.value && sceneError.value === null && <Inset title={text.viewMenu.insetTitle} />}
        {forced && state.showForces.value && <ForceLegend />}
      </div>
      <div class="views" hidden={!drawn}>
        <Slot name="stagePad" />
        <div class="segments" role="group" aria-label={text.view.label}>
          {viewsOf(system?.meta.views).map((view) => (
            <ViewButton key={view} view={view} />
          ))}
        </div>
        <div class="view-switches">
          <div class="segments" role="group" aria-label={text.view.switches}>
            <SwitchButton id="follow" pressed={state.follow.value} titled />
            {tracked && <SwitchButton id="trails" pressed={state.showTrails.value} />}
            {forced && <SwitchButton id="forces" pressed={state.showForces.value} />}
            <Slot name="stageSwitch" />
          </div>
          <ViewMenu closeUp={closeUp} ridden={system?.meta.views?.ridden ?? false} forced={forced} />
        </div>
      </div>
    </>
  );
}

function ViewButton({ view }: { view: ViewName }) {
  const { label, title, perform } = useCommand(`view-${view}`);
  const pressed = useUi().app.state.view.value === view;
  return (
    <Toggle pressed={pressed} title={title} testId={`view-${view}`} onClick={perform}>
      {label}
    </Toggle>
  );
}

function SwitchButton({ id, pressed, titled = false }: { id: string; pressed: boolean; titled?: boolean }) {
  const { label, title, perform } = useCommand(id);
  return (
    <Toggle pressed={pressed} {...(titled ? { title } : {})} testId={`toggle-${id}`} onClick={perform}>
      {label}
    </Toggle>
  );
}
