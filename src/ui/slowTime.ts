/** What a read-out follows: the playback time in steps that can be read, and a column's value there. */
import { signal } from '@preact/signals';
import { useEffect, useState } from 'preact/hooks';
import type { Trajectory } from '../core/motion/trajectory.ts';
import { useUi } from './context.ts';

const INTERVAL = 1000 / 15;

/** Linear between rows: enough for a read-out. */
export function sample(trajectory: Trajectory, name: string, time: number): number | null {
  const values = trajectory.column(name);
  const t = trajectory.column('t');
  if (!values || !t || values.length === 0) return null;
  const i = trajectory.locate(time);
  const next = Math.min(i + 1, values.length - 1);
  const span = t[next]! - t[i]!;
  const part = span > 0 ? Math.min(1, Math.max(0, (time - t[i]!) / span)) : 0;
  return values[i]! + part * (values[next]! - values[i]!);
}

/** The playback time, but not on every frame; the last change always arrives. */
export function useSlowTime(interval = INTERVAL): number {
  const { state } = useUi().app;
  const [slow] = useState(() => signal(state.readTime.peek()));
  useEffect(() => {
    let timer: ReturnType<typeof setTimeout> | undefined;
    let last = 0;
    const show = () => {
      timer = undefined;
      last = performance.now();
      slow.value = state.readTime.peek();
    };
    const stop = state.readTime.subscribe(() => {
      timer ??= setTimeout(show, Math.max(0, interval - (performance.now() - last)));
    });
    return () => {
      stop();
      clearTimeout(timer);
    };
  }, []);
  return slow.value;
}
