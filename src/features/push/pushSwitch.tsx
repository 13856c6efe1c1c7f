/** The switch of pushing, and the pad that stands over the views while it is on. */
import { canPush } from '../../app/push/pointerPush.ts';
import { useCommand, useUi } from '../../ui/context.ts';
import { Toggle } from '../../ui/kit/controls.tsx';
import { later } from '../../ui/kit/later.tsx';

const PushPad = later(async () => (await import('./pushPad.tsx')).PushPad);

export function PushSlot() {
  const { state } = useUi().app;
  return state.dragPushes.value && canPush(state.motion.value) ? <PushPad /> : null;
}

export function PushSwitch() {
  const { state } = useUi().app;
  const { label, title, disabled, perform } = useCommand('push');
  if (disabled) return null;
  return (
    <Toggle pressed={state.dragPushes.value} title={title} testId="toggle-push" onClick={perform}>
      {label}
    </Toggle>
  );
}
