/**
 * What a feature gives the page. The shell knows these slots and no feature: a folder under `src/features` with its
 * `manifest.tsx`, and one line in `src/features/registry.ts`, make one.
 */
import type { ComponentType } from 'preact';
import type { App } from '../app/app.ts';
import type { Command } from '../app/commands.ts';
import type { IconName } from './kit/controls.tsx';

/** A place to work in beside the scene: one entry of the rail, one tab of the phone's sheet. */
export interface Tool {
  title: string;
  icon: IconName;
  /** How much room it takes beside the scene. */
  size: 'narrow' | 'wide' | 'widest';
  /** Stays as it is while another tool is shown; else it begins anew. */
  keep?: boolean;
  /** On a phone its tab is turned to as this becomes true. */
  wanted?(app: App): boolean;
  Body: ComponentType;
}

export interface Feature {
  /** Permanent: the name of its folder, and of its tool in links and in what is stored. */
  id: string;
  /** Where it stands among the others in every slot, smallest first. */
  order: number;
  /** Its document under docs/, with a place in it: what `?` at the head of its view opens. Every panel and tool has one. */
  document?: string;
  /** The panel at the left, and the first tab of the phone's sheet. */
  panel?: { title: string; Body: ComponentType };
  tool?: Tool;
  /** In the bar at the top, beside the page's name. */
  topStart?: ComponentType;
  /** In the bar at the top, among the buttons at its end. */
  topEnd?: ComponentType;
  /** Under the title of what is on the stage. */
  caption?: ComponentType;
  /** In the place of the scene, where what is played has none. */
  noScene?: ComponentType;
  /** Over the buttons of the views. */
  stagePad?: ComponentType;
  /** Among the switches of the stage. */
  stageSwitch?: ComponentType;
  /** A card over the page, such as what a first visit is offered. */
  card?: ComponentType;
  /** Under the numbers of the moment, about what is on the stage. */
  notes?: ComponentType;
  /** At the end of the status line, once a run has ended. */
  runStatus?: ComponentType;
  /** Along the time line, under its track; as wide as the line. */
  timeLine?: ComponentType;
  /** Always in the page, and seen when it chooses: a dialog, a cover for dropped files. */
  dialog?: ComponentType;
  /** Pages of the help, after the keys. */
  helpPages?: readonly { id: string; title: string; Body: ComponentType }[];
  /** Under the sheet of keys; `close` closes the sheet. */
  help?: ComponentType<{ close(): void }>;
  /** What it adds to the page's commands, and their keys to the sheet. */
  commands?: readonly Command[];
}

/** Slots that hold a component without properties. */
export type SlotName =
  | 'topStart'
  | 'topEnd'
  | 'caption'
  | 'noScene'
  | 'stagePad'
  | 'stageSwitch'
  | 'card'
  | 'notes'
  | 'runStatus'
  | 'timeLine'
  | 'dialog';

/** Features as the page shows them. */
export const inOrder = (features: Readonly<Record<string, Feature>>): readonly Feature[] =>
  Object.values(features).sort((a, b) => a.order - b.order);
