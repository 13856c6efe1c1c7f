import type { SystemView } from './types.ts';
import { ripstikView } from './ripstik/view.ts';

/** Every system as the views know it; one line per system here and in `registry.ts`. */
export const systemViews: Readonly<Record<string, SystemView>> = { ripstik: ripstikView };
