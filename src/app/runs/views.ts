/** The views that a system offers. */
import type { SystemMeta } from '../../core/model/system.ts';
import type { SettingsSlice } from '../state/settings.ts';
import type { ViewName } from '../state/settingsTable.ts';
import type { StageState } from './stageState.ts';

/** The close-up only where there is something to come close to, the view from aboard where something goes somewhere. */
export const viewsOf = (offers: SystemMeta['views']): readonly ViewName[] => [
  'orbit',
  'front',
  'side',
  'top',
  ...(offers?.closeUp ? (['caster'] as const) : []),
  ...(offers?.ridden ? (['rider'] as const) : []),
];

/** A view that the system on the stage does not offer gives way to the first. */
export function settleView(stage: StageState, { state, actions }: SettingsSlice): void {
  const meta = stage.motion.peek()?.system.meta;
  if (meta && !viewsOf(meta.views).includes(state.view.peek())) actions.set('view', 'orbit');
}
