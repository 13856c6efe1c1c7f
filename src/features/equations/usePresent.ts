/** The matrices at the time on the stage, a few times a second; a worker evaluates the equations. */
import { useEffect, useState } from 'preact/hooks';
import type { Motion } from '../../app/runs/motion.ts';
import { useUi } from '../../ui/context.ts';
import { useSlowTime } from '../../ui/slowTime.ts';
import { useBook } from './context.ts';
import { presentOf, stateAt, type Present } from './present.ts';

const SLOW = 200;

interface Shown {
  present: Present;
  motion: Motion;
}

/** Null where there is no motion of this system, or no whole state of it. */
export function usePresent(): Shown | null {
  const { state, mechanics } = useUi().app;
  const { id } = useBook().view.meta;
  const [shown, setShown] = useState<Shown | null>(null);
  const time = useSlowTime(SLOW);
  // a run that begins has no rows at first
  void state.rowsVersion.value;
  const motion = state.motion.value;
  const fits = motion !== null && motion.system.meta.id === id && motion.trajectory.length > 0;
  useEffect(() => {
    const at = fits ? stateAt(motion, time) : null;
    if (!at) return setShown(null);
    let current = true;
    void mechanics.terms(at).then((answer) => {
      if (current && answer?.ok) setShown({ present: presentOf(answer.value, at, motion!, time), motion: motion! });
    });
    return () => {
      current = false;
    };
  }, [motion, fits, time]);
  return shown?.motion.system.meta.id === id ? shown : null;
}
