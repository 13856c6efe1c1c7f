/** The views that a system offers. */
import type { SystemMeta } from '../../core/model/system.ts';
import type { SettingsSlice } from '../state/settings.ts';
import type { ViewName } from '../state/settingsTable.ts';
import type { StageState } from './stageState.ts';

/** By its key. The close-up only where there is something to come close to, the view from aboard where something goes somewhere. */
export const viewsOf = (offers: SystemMeta['views']): ReadonlyMap<string, ViewName> =>
  new Map([
    ['1', 'orbit'],
    ['2', 'front'],
    ['3', 'side'],
    ['4', 'top'],
    ...(offers?.closeUp ? ([['5', 'caster']] as const) : []),
    ...(offers?.ridden ? ([['6', 'rider']] as const) : []),
  ]);

/** A view that the system on the stage does not offer gives way to the first. */
export function settleView(stage: StageState, { state, actions }: SettingsSlice): void {
  const meta = stage.motion.peek()?.system.meta;
  if (meta && ![...viewsOf(meta.views).values()].includes(state.view.peek())) actions.set('view', 'orbit');
}
