import type { Surface } from '../../src/charts/surface.ts';

export interface Recording {
  surface: Surface;
  /** Lines that were stroked or filled: their points, style and width. */
  strokes: { points: [number, number][]; style: string; width: number; dash: readonly number[] }[];
  texts: { text: string; x: number; y: number; font: string }[];
  rects: { x: number; y: number; w: number; h: number; style: string }[];
  circles: { x: number; y: number; r: number }[];
}

/** A canvas that remembers what it is asked for. */
export function recorder(): Recording {
  const made: Recording = { surface: null as unknown as Surface, strokes: [], texts: [], rects: [], circles: [] };
  let points: [number, number][] = [];
  let dash: readonly number[] = [];
  const target: Record<string, unknown> = {
    font: '11px x',
    strokeStyle: '',
    fillStyle: '',
    lineWidth: 1,
    beginPath: () => void (points = []),
    moveTo: (x: number, y: number) => void points.push([x, y]),
    lineTo: (x: number, y: number) => void points.push([x, y]),
    arc: (x: number, y: number, r: number) => void made.circles.push({ x, y, r }),
    setLineDash: (next: readonly number[]) => void (dash = next),
    stroke: () =>
      void made.strokes.push({
        points: [...points],
        style: String(target['strokeStyle']),
        width: Number(target['lineWidth']),
        dash,
      }),
    fillText: (text: string, x: number, y: number) =>
      void made.texts.push({ text, x, y, font: String(target['font']) }),
    fillRect: (x: number, y: number, w: number, h: number) =>
      void made.rects.push({ x, y, w, h, style: String(target['fillStyle']) }),
    strokeRect: () => {},
    measureText: (text: string) => ({ width: 6 * text.length }),
  };
  for (const name of ['save', 'restore', 'clip', 'rect', 'fill', 'translate', 'rotate']) target[name] = () => {};
  made.surface = target as unknown as Surface;
  return made;
}
