import type { Feature } from '../../ui/feature.ts';
import { commands } from './commands.ts';
import { PushSlot, PushSwitch } from './pushSwitch.tsx';

export const push: Feature = { id: 'push', order: 120, stagePad: PushSlot, stageSwitch: PushSwitch, commands };
