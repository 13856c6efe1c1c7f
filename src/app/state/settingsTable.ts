/** Every switch of the page, one line each: what it is at first, which values it takes, and where it is stored, linked and drawn. */
import { rememberedFrom, type RememberedChoices } from '../files/importChoices.ts';
import { plotsFrom, type PlotsState } from './plotPanes.ts';

export type Theme = 'light' | 'dark';
export type ViewName = 'orbit' | 'front' | 'side' | 'top' | 'caster' | 'rider';
/** Whether somebody is seen on a board that is computed without a rider: where feet move it, or by choice. */
export type Figure = 'auto' | 'always' | 'never';
export type Quality = 'auto' | 'low' | 'high';

/** What a check needs to know of the page. */
export interface PageFacts {
  toolIds: readonly string[];
}

/** What the scene draws by, on the page and in pictures and videos, under the scene's names. */
export interface DrawnSettings {
  trails: boolean;
  forces: boolean;
  names: boolean;
  frames: boolean;
  level: boolean;
  metresPerNewton: number;
}

export interface Setting<T> {
  initial: T;
  /** The value, if it is one; stored text and links are read like a stranger's file. */
  check(value: unknown, page: PageFacts): T | undefined;
  /** Where the stored text has it, `name` or `group.name`: permanent. Without it, it is not stored. */
  stored?: string;
  /** Stored only where it is not its initial value. */
  sparse?: true;
  /** Its name in links: permanent. A link leaves it out at its initial value. */
  linked?: 'tool' | 'view' | 'plots';
  /** A link without it puts it back to its initial value; without `reset` such a link leaves it as it is. */
  reset?: true;
  /** Its name in the scene, and so in every picture and video. */
  drawn?: keyof DrawnSettings;
}

const setting = <T>(
  initial: T,
  check: Setting<T>['check'],
  rest: Omit<Setting<T>, 'initial' | 'check'> = {},
): Setting<T> => ({ initial, check, ...rest });

const flag = (value: unknown): boolean | undefined => (typeof value === 'boolean' ? value : undefined);
const oneOf =
  <T extends string>(...names: readonly T[]) =>
  (value: unknown): T | undefined =>
    names.find((name) => name === value);
/** It was stored as a flag once. */
const figure = (value: unknown): Figure | undefined =>
  value === true ? 'always' : oneOf<Figure>('auto', 'always', 'never')(value);
const between = (least: number, most: number) => (value: unknown) =>
  typeof value === 'number' && value >= least && value <= most ? value : undefined;
const openTool = (value: unknown, { toolIds }: PageFacts): string | null | undefined =>
  value === null ? null : toolIds.find((id) => id === value);

const VIEWS: readonly ViewName[] = ['orbit', 'front', 'side', 'top', 'caster', 'rider'];
const NO_PLOTS: PlotsState = { own: null, degrees: true, wrapped: false };

/** The order is that of the stored text. */
export const SETTINGS = {
  theme: setting<Theme>('light', oneOf('light', 'dark'), { stored: 'theme' }),
  /** Which tool is open beside the scene, by id; null when none is. */
  tool: setting<string | null>(null, openTool, { stored: 'tool', linked: 'tool' }),
  view: setting<ViewName>('orbit', oneOf(...VIEWS), { stored: 'view', linked: 'view', reset: true }),
  follow: setting(true, flag, { stored: 'follow' }),
  showTrails: setting(true, flag, { stored: 'showTrails', drawn: 'trails' }),
  showForces: setting(false, flag, { stored: 'showForces', drawn: 'forces' }),
  loop: setting(false, flag, { stored: 'loop' }),
  speed: setting(1, between(1 / 256, 64), { stored: 'speed' }),
  plots: setting(NO_PLOTS, (value) => plotsFrom(value) ?? undefined, { stored: 'plots', linked: 'plots' }),
  /** Names and axes on the bodies. */
  showNames: setting(false, flag, { stored: 'look.names', drawn: 'names' }),
  showFrames: setting(false, flag, { stored: 'look.frames', drawn: 'frames' }),
  /** The close-up in a corner, where the system has one. */
  showInset: setting(false, flag, { stored: 'look.inset' }),
  showRider: setting<Figure>('auto', figure, { stored: 'look.rider', sparse: true }),
  /** From aboard, the horizon stays level. */
  levelHorizon: setting(true, flag, { stored: 'look.level', drawn: 'level' }),
  quality: setting<Quality>('auto', oneOf('auto', 'low', 'high'), { stored: 'look.quality' }),
  /** The run on the stage follows every change of the draft, where a run is cheap. */
  live: setting(true, flag, { stored: 'live', sparse: true }),
  /** How files of a shape are read, where the person chose. */
  imports: setting<RememberedChoices | null>(null, rememberedFrom, { stored: 'imports', sparse: true }),
  /** Metres of arrow per newton. */
  metresPerNewton: setting(0.01, between(1e-6, 1), { drawn: 'metresPerNewton' }),
  /** Pressing on a body pushes it; with Shift it always does. */
  dragPushes: setting(false, flag),
};

export type SettingId = keyof typeof SETTINGS;
export type SettingValues = {
  [id in SettingId]: (typeof SETTINGS)[id] extends Setting<infer T> ? T : never;
};
/** Settings that are on or off. */
export type SwitchId = { [id in SettingId]: SettingValues[id] extends boolean ? id : never }[SettingId];

export const settingIds = Object.keys(SETTINGS) as SettingId[];
