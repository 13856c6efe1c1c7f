import type { ComponentType } from 'preact';
import type { IconName } from './kit/controls.tsx';

/** A place to work in beside the scene: one entry of the rail, one tab of the phone's sheet. */
export interface Tool {
  /** Permanent. */
  id: string;
  title: string;
  icon: IconName;
  /** How much room it takes beside the scene. */
  size: 'narrow' | 'wide' | 'widest';
  /** Stays as it is while another tool is shown; else it begins anew. */
  keep?: boolean;
  Body: ComponentType;
}
