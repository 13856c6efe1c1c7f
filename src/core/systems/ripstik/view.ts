import type { SystemView } from '../../model/system.ts';
import { ripstikMeta } from './meta.ts';
import { poses } from './poses.generated.ts';

export const ripstikView: SystemView = {
  meta: ripstikMeta,
  poses,
  contacts: [
    { body: 3, part: 'front', radius: 'wheelRadius', lateral: 0, vertical: 1, worldLateral: ['report'] },
    { body: 4, part: 'back', radius: 'wheelRadius', lateral: 2, vertical: 3, worldLateral: ['report'] },
  ],
};
