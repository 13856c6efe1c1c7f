import type { SystemView } from '../types.ts';
import { ripstikMeta } from './meta.ts';
import { poses } from './poses.generated.ts';

export const ripstikView: SystemView = { meta: ripstikMeta, poses };
