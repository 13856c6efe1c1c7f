import type { SystemView } from '../../model/system.ts';
import { ripstikMeta } from './meta.ts';
import { poses } from './poses.generated.ts';

export const ripstikView: SystemView = {
  meta: ripstikMeta,
  poses,
  contacts: [
    {
      body: 3,
      label: 'front wheel',
      role: 'first',
      radius: 'wheelRadius',
      lateral: 0,
      vertical: 1,
      worldLateral: ['report'],
    },
    {
      body: 4,
      label: 'back wheel',
      role: 'second',
      radius: 'wheelRadius',
      lateral: 2,
      vertical: 3,
      worldLateral: ['report'],
    },
  ],
};
