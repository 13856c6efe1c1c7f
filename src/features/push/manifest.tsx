import { canPush } from '../../app/push/pointerPush.ts';
import type { Feature } from '../../ui/feature.ts';
import { PushSlot, PushSwitch } from './pushSwitch.tsx';
import { words } from './words.ts';

export const push: Feature = {
  id: 'push',
  order: 120,
  stagePad: PushSlot,
  stageSwitch: PushSwitch,
  commands: [
    {
      key: 'g',
      run({ state, actions }) {
        if (canPush(state.motion.peek())) actions.toggle('dragPushes');
      },
    },
  ],
  keys: words.keys,
};
