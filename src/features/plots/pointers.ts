/** Hands and keys on a plot: a click goes to a time, dragging zooms, the wheel zooms about the pointer, Shift drags along. */
import type { App } from '../../app/app.ts';
import type { PanePlot } from '../../charts/panePlot.ts';
import { limits } from './drawing.ts';
import type { PaneProps } from './paneView.tsx';

/** A press that moved less than this (CSS pixels) is a click. */
const CLICK = 4;
const ZOOM = 1.25;
const LEAST_SPAN = 1e-6;

export function attachPointers(plot: PanePlot, app: App, latest: { current: PaneProps }): () => void {
  const { over } = plot;
  const overTime = (): boolean => latest.current.pane.x === 't';
  let press: { x: number; at: number; mode: 'zoom' | 'pan' | 'seek'; range: readonly [number, number] } | null = null;
  const box = Object.assign(document.createElement('div'), { className: 'pane-zoom', hidden: true });
  over.append(box);
  const seek = (clientX: number, clientY: number): void => {
    const { x, y } = plot.at(clientX, clientY);
    app.actions.seek(overTime() ? x : nearest(latest.current, x, y));
  };
  const down = (event: PointerEvent): void => {
    if (event.button !== 0) return;
    over.setPointerCapture(event.pointerId);
    const mode = event.pointerType === 'touch' || !overTime() ? 'seek' : event.shiftKey ? 'pan' : 'zoom';
    press = {
      x: event.clientX,
      at: plot.at(event.clientX, event.clientY).x,
      mode,
      range: limits(latest.current.motion, latest.current.range.peek(), latest.current.pane.to),
    };
    if (mode === 'seek') seek(event.clientX, event.clientY);
  };
  const move = (event: PointerEvent): void => {
    if (!press) return;
    if (press.mode === 'seek') seek(event.clientX, event.clientY);
    else if (press.mode === 'pan') {
      const perPixel = (press.range[1] - press.range[0]) / over.clientWidth;
      const by = (press.x - event.clientX) * perPixel;
      latest.current.range.value = [press.range[0] + by, press.range[1] + by];
    } else {
      const left = over.getBoundingClientRect().left;
      const [a, b] = [press.x - left, event.clientX - left].sort((p, q) => p - q) as [number, number];
      box.hidden = b - a < CLICK;
      box.style.left = `${a}px`;
      box.style.width = `${b - a}px`;
    }
  };
  const up = (event: PointerEvent): void => {
    if (!press) return;
    const { x, at, mode } = press;
    press = null;
    box.hidden = true;
    if (mode !== 'zoom') return;
    if (Math.abs(event.clientX - x) < CLICK) return seek(event.clientX, event.clientY);
    const [from, to] = [at, plot.at(event.clientX, event.clientY).x].sort((p, q) => p - q) as [number, number];
    if (to - from > LEAST_SPAN) latest.current.range.value = [from, to];
  };
  const wheel = (event: WheelEvent): void => {
    if (!overTime() || !(event.ctrlKey || event.altKey || event.shiftKey || over.matches(':focus-within, :hover')))
      return;
    event.preventDefault();
    zoom(latest.current, event.deltaY > 0 ? ZOOM : 1 / ZOOM, plot.at(event.clientX, event.clientY).x);
  };
  const whole = (): void => void (latest.current.range.value = null);
  over.addEventListener('pointerdown', down);
  over.addEventListener('pointermove', move);
  over.addEventListener('pointerup', up);
  over.addEventListener('dblclick', whole);
  over.addEventListener('wheel', wheel, { passive: false });
  return () => {
    over.removeEventListener('pointerdown', down);
    over.removeEventListener('pointermove', move);
    over.removeEventListener('pointerup', up);
    over.removeEventListener('dblclick', whole);
    over.removeEventListener('wheel', wheel);
  };
}

export function onPaneKey(event: KeyboardEvent, app: App, props: PaneProps): void {
  const time = app.state.time.peek();
  if (event.key === '+' || event.key === '=') zoom(props, 1 / ZOOM, time);
  else if (event.key === '-') zoom(props, ZOOM, time);
  else if (event.key === '0') props.range.value = null;
  else return;
  event.preventDefault();
}

/** About a time that stays where it is. */
function zoom({ motion, pane, range }: PaneProps, factor: number, about: number): void {
  const [from, to] = limits(motion, range.peek(), pane.to);
  const [a, b] = [about - (about - from) * factor, about + (to - about) * factor];
  const whole = limits(motion, null, pane.to);
  if (b - a < LEAST_SPAN) return;
  range.value = a <= whole[0] && b >= whole[1] ? null : [Math.max(a, whole[0]), Math.min(b, whole[1])];
}

/** The time of the row nearest to a place in a plot over something else than time. */
function nearest({ pane, motion, values }: PaneProps, x: number, y: number): number {
  const t = motion.trajectory.column('t')!;
  const xs = values(pane.x).get();
  const ys = pane.y.map((name) => values(name).get());
  const spread = (list: Float64Array): number => {
    let [low, high] = [Infinity, -Infinity];
    for (const v of list) {
      if (v < low) low = v;
      if (v > high) high = v;
    }
    return high - low || 1;
  };
  const [sx, sy] = [spread(xs), Math.max(...ys.map(spread))];
  let best = Infinity;
  let found = t[0] ?? 0;
  for (let i = 0; i < xs.length; i++) {
    for (const list of ys) {
      const d = ((xs[i]! - x) / sx) ** 2 + ((list[i]! - y) / sy) ** 2;
      if (d < best) {
        best = d;
        found = t[i]!;
      }
    }
  }
  return found;
}
