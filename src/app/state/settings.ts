/** The page's switches as state, made from the table. */
import { batch, signal, type ReadonlySignal, type Signal } from '@preact/signals';
import {
  SETTINGS,
  settingIds,
  type DrawnSettings,
  type SettingId,
  type SettingValues,
  type SwitchId,
} from './settingsTable.ts';
import { readonly } from './signals.ts';

export type SettingsState = { readonly [id in SettingId]: ReadonlySignal<SettingValues[id]> };

export interface SettingsActions {
  set<Id extends SettingId>(id: Id, value: SettingValues[Id]): void;
  toggle(id: SwitchId): void;
  /** Several at once. */
  setAll(values: Partial<SettingValues>): void;
}

export interface SettingsSlice {
  state: SettingsState;
  actions: SettingsActions;
}

/** @param first what the browser or the screen asks for in place of the table's initial values */
export function createSettings(first: Partial<SettingValues> = {}): SettingsSlice {
  const signals = Object.fromEntries(
    settingIds.map((id) => [id, signal<unknown>(first[id] ?? SETTINGS[id].initial)]),
  ) as Record<SettingId, Signal<unknown>>;
  const state = Object.fromEntries(settingIds.map((id) => [id, readonly(signals[id])])) as unknown as SettingsState;
  const actions: SettingsActions = {
    set: (id, value) => void (signals[id].value = value),
    toggle: (id) => void (signals[id].value = !signals[id].peek()),
    setAll: (values) =>
      batch(() => {
        for (const id of settingIds) if (id in values) signals[id].value = values[id];
      }),
  };
  return { state, actions };
}

/** All as they are now, without watching them. */
export const settingValues = (state: SettingsState): SettingValues =>
  Object.fromEntries(settingIds.map((id) => [id, state[id].peek()])) as SettingValues;

/** What the scene draws by. Reads the signals: an effect around it runs again when one changes. */
export const drawnSettings = (state: SettingsState): DrawnSettings =>
  Object.fromEntries(
    settingIds.flatMap((id) => {
      const { drawn } = SETTINGS[id];
      return drawn ? [[drawn, state[id].value]] : [];
    }),
  ) as unknown as DrawnSettings;
