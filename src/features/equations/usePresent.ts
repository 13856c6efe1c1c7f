/** The matrices at the time on the stage, a few times a second; the system's dynamics are loaded when first asked for. */
import { useEffect, useState } from 'preact/hooks';
import type { Motion } from '../../app/types.ts';
import { loadSystem } from '../../core/systems/registry.ts';
import type { System } from '../../core/model/system.ts';
import { useUi } from '../../ui/context.ts';
import { useSlowTime } from '../../ui/slowTime.ts';
import { useBook } from './context.ts';
import { presentOf, type Present } from './present.ts';

const SLOW = 200;

export function usePresent(): { present: Present | null; motion: Motion | null } {
  const { state } = useUi().app;
  const { id } = useBook().view.meta;
  const [system, setSystem] = useState<System | null>(null);
  const time = useSlowTime(SLOW);
  // a run that begins has no rows at first
  void state.rowsVersion.value;
  const motion = state.motion.value;
  useEffect(() => {
    let current = true;
    loadSystem(id)?.then(
      (loaded) => current && setSystem(loaded),
      () => undefined,
    );
    return () => {
      current = false;
    };
  }, [id]);
  const fits = system && motion && motion.system.meta.id === system.meta.id && motion.trajectory.length > 0;
  return { present: fits ? presentOf(system, motion, time) : null, motion };
}
