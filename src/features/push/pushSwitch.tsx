/** The switch of pushing, and the pad that stands over the views while it is on. */
import { canPush } from '../../app/push/pointerPush.ts';
import { useUi } from '../../ui/context.ts';
import { Toggle } from '../../ui/kit/controls.tsx';
import { later } from '../../ui/kit/later.tsx';
import { words } from './words.ts';

const PushPad = later(async () => (await import('./pushPad.tsx')).PushPad);

export function PushSlot() {
  const { state } = useUi().app;
  return state.dragPushes.value && canPush(state.motion.value) ? <PushPad /> : null;
}

export function PushSwitch() {
  const { state, actions } = useUi().app;
  if (!canPush(state.motion.value)) return null;
  return (
    <Toggle
      pressed={state.dragPushes.value}
      title={`${words.pushTitle} (G)`}
      testId="toggle-push"
      onClick={() => actions.toggle('dragPushes')}
    >
      {words.push}
    </Toggle>
  );
}
