// @vitest-environment happy-dom
// What hands and keys do in a chart: pointer, touch with two fingers, wheel, keys.
import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import type { Frame, Zoom } from '../../src/charts/frame.ts';
import { attachGestures, chartKey, type GestureTarget } from '../../src/charts/gestures.ts';
import { scaleOf, type Range } from '../../src/charts/scales.ts';

const whole: { x: Range; y: Range } = { x: [0, 10], y: [-1, 1] };

/** A chart of 200 by 100 px that shows what it is told. */
function chart(alongX: boolean, cursorX: number | null = null, marks: readonly [number, number][] = []) {
  let zoom: Zoom = { x: null, y: null };
  const target = {
    alongX,
    whole,
    cursorX,
    get zoom() {
      return zoom;
    },
    get frame(): Frame {
      const [x, y] = [scaleOf({}, zoom.x ?? whole.x), scaleOf({}, zoom.y ?? whole.y)];
      return { left: 0, top: 0, width: 200, height: 100, x, y, density: 1 };
    },
    setZoom: vi.fn((next: Zoom) => void (zoom = next)),
    seek: vi.fn(),
    pick: vi.fn(),
    hover: vi.fn(),
    pointAt: (x: number, y: number) => {
      const found = marks.findIndex(([a, b]) => Math.hypot(a - x, b - y) < 10);
      return found < 0 ? null : found;
    },
    showBox: vi.fn(),
    step: vi.fn(() => true),
    toggleTable: vi.fn(),
  };
  return target satisfies GestureTarget;
}

const near = (...values: number[]): unknown[] => values.map((x) => expect.closeTo(x, 9) as unknown);

let area: HTMLDivElement;
let detach: (() => void) | undefined;
beforeEach(() => {
  area = document.createElement('div');
  area.setPointerCapture = () => {};
  area.tabIndex = 0;
  document.body.append(area);
});
afterEach(() => {
  detach?.();
  area.remove();
});

const point = (type: string, x: number, y: number, more: Partial<PointerEventInit> = {}) =>
  area.dispatchEvent(
    new PointerEvent(type, { clientX: x, clientY: y, button: 0, pointerId: 1, pointerType: 'mouse', ...more }),
  );

function drag(from: [number, number], to: [number, number], more: Partial<PointerEventInit> = {}) {
  point('pointerdown', ...from, more);
  point('pointermove', ...to, more);
  point('pointerup', ...to, more);
}

test('a click goes there, with a tremble too; a drag zooms to what it covers, along x alone over time', () => {
  const over = chart(true);
  detach = attachGestures(area, over);
  drag([50, 40], [52, 41]);
  expect(over.seek).toHaveBeenCalledExactlyOnceWith(2.6, expect.closeTo(0.18, 9));
  expect(over.setZoom).not.toHaveBeenCalled();
  drag([40, 20], [100, 60]);
  expect(over.zoom).toEqual({ x: [2, 5], y: null });
  expect(over.showBox).toHaveBeenCalledWith([40, 0, 60, 100]);
  expect(over.showBox).toHaveBeenLastCalledWith(null);
  area.dispatchEvent(new MouseEvent('dblclick'));
  expect(over.zoom).toEqual({ x: null, y: null });
});

test('in a plane a drag zooms along both axes, backwards too; a sliver is a slip', () => {
  const plane = chart(false);
  detach = attachGestures(area, plane);
  drag([100, 75], [40, 25]);
  expect(plane.zoom).toEqual({ x: [2, 5], y: [-0.5, 0.5] });
  plane.setZoom.mockClear();
  drag([40, 20], [160, 21]);
  expect(plane.setZoom).not.toHaveBeenCalled();
});

test('with Shift it moves along, never beyond the whole', () => {
  const over = chart(true);
  detach = attachGestures(area, over);
  over.setZoom({ x: [2, 4], y: null });
  drag([100, 50], [50, 50], { shiftKey: true });
  expect(over.zoom.x).toEqual([2.5, 4.5]);
  drag([100, 50], [900, 50], { shiftKey: true });
  expect(over.zoom.x![0]).toBeCloseTo(0, 9);
  expect(over.zoom.x![1]).toBeCloseTo(2, 9);
});

test('the line of the cursor is drawn along by a mouse near it, and by a finger anywhere', () => {
  const over = chart(true, 100);
  detach = attachGestures(area, over);
  point('pointerdown', 103, 50);
  point('pointermove', 140, 50);
  expect(over.seek).toHaveBeenLastCalledWith(7, 0);
  point('pointerup', 140, 50);
  expect(over.setZoom).not.toHaveBeenCalled();
  drag([20, 50], [60, 50], { pointerType: 'touch' });
  expect(over.seek).toHaveBeenLastCalledWith(3, 0);
  expect(over.setZoom).not.toHaveBeenCalled();
});

test('two fingers zoom about the middle between them; lifting one is no click', () => {
  const over = chart(true);
  detach = attachGestures(area, over);
  const touch = (id: number) => ({ pointerId: id, pointerType: 'touch' });
  point('pointerdown', 80, 50, touch(1));
  point('pointerdown', 120, 50, touch(2));
  point('pointermove', 60, 50, touch(1));
  point('pointermove', 140, 50, touch(2));
  expect(over.zoom.x![0]).toBeCloseTo(2.5, 9);
  expect(over.zoom.x![1]).toBeCloseTo(7.5, 9);
  point('pointerup', 60, 50, touch(1));
  point('pointermove', 150, 50, touch(2));
  point('pointerup', 150, 50, touch(2));
  expect(over.zoom.x![1]).toBeCloseTo(7.5, 9);
  expect(over.seek).not.toHaveBeenCalled();
  // Together again is all again.
  point('pointerdown', 60, 50, touch(1));
  point('pointerdown', 140, 50, touch(2));
  point('pointermove', 100, 50, touch(1));
  point('pointermove', 110, 50, touch(2));
  expect(over.zoom).toEqual({ x: null, y: null });
});

test('a touch that the page takes over leaves nothing behind', () => {
  const over = chart(true);
  detach = attachGestures(area, over);
  point('pointerdown', 40, 50);
  point('pointermove', 90, 50);
  point('pointercancel', 90, 50);
  expect(over.showBox).toHaveBeenLastCalledWith(null);
  point('pointermove', 120, 50);
  point('pointerup', 120, 50);
  expect(over.setZoom).not.toHaveBeenCalled();
  expect(over.seek).not.toHaveBeenCalled();
});

test('what is pointed at is told, and picked by a click', () => {
  const map = chart(false, null, [
    [50, 50],
    [150, 50],
  ]);
  detach = attachGestures(area, map);
  point('pointermove', 152, 51);
  expect(map.hover).toHaveBeenLastCalledWith(1, 152, 51);
  drag([49, 50], [49, 50]);
  expect(map.pick).toHaveBeenCalledExactlyOnceWith(0);
  point('pointerleave', 0, 0);
  expect(map.hover).toHaveBeenLastCalledWith(null, 0, 0);
});

test('the wheel zooms when the chart has the focus or a key is held, and else scrolls the page', () => {
  const over = chart(true);
  detach = attachGestures(area, over);
  const wheel = ({ deltaY = -1, ...more }: WheelEventInit = {}) => {
    // happy-dom's own wheel event knows neither keys nor a place.
    const event = Object.assign(new MouseEvent('wheel', { clientX: 100, clientY: 50, cancelable: true, ...more }), {
      deltaY,
    });
    area.dispatchEvent(event);
    return event.defaultPrevented;
  };
  expect(wheel()).toBe(false);
  expect(over.setZoom).not.toHaveBeenCalled();
  expect(wheel({ ctrlKey: true })).toBe(true);
  expect(over.zoom.x).toEqual(near(1, 9));
  area.focus();
  expect(wheel({ deltaY: 1 })).toBe(true);
  expect(over.zoom).toEqual({ x: null, y: null });
});

test('keys zoom, show all, open the table, step and choose; others are not the chart’s', () => {
  const plane = chart(false);
  expect(chartKey('+', plane)).toBe(true);
  expect(plane.zoom).toEqual({ x: near(1, 9), y: near(-0.8, 0.8) });
  expect(chartKey('−', plane)).toBe(true);
  expect(plane.zoom).toEqual({ x: null, y: null });
  chartKey('=', plane);
  chartKey('0', plane);
  expect(plane.zoom).toEqual({ x: null, y: null });
  expect(chartKey('T', plane)).toBe(true);
  expect(plane.toggleTable).toHaveBeenCalledOnce();
  for (const key of ['ArrowRight', 'ArrowLeft', 'ArrowUp', 'ArrowDown', 'Enter']) chartKey(key, plane);
  expect(plane.step.mock.calls).toEqual([
    [1, 0],
    [-1, 0],
    [0, 1],
    [0, -1],
    [0, 0],
  ]);
  plane.step.mockReturnValue(false);
  expect(chartKey('ArrowRight', plane)).toBe(false);
  expect(chartKey('a', plane)).toBe(false);
});

test('zooming in ends where numbers cannot be told apart', () => {
  const over = chart(true);
  for (let k = 0; k < 300; k++) chartKey('+', over);
  const [low, high] = over.zoom.x!;
  expect(high).toBeGreaterThan(low);
  expect(high - low).toBeGreaterThan(1e-10);
});

test('detached, it hears nothing', () => {
  const over = chart(true);
  attachGestures(area, over)();
  drag([40, 20], [100, 60]);
  expect(over.setZoom).not.toHaveBeenCalled();
});
