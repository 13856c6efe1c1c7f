import type { System } from './types.ts';
import { ripstik } from './ripstik/system.ts';

/** Every system with its dynamics: for the worker, the command line and tests, not for the page. */
export const systems: Readonly<Record<string, System>> = { ripstik };
