/** The one frame of all charts: where the area of the marks lies, the axes, ticks and titles around it. */
import { words, type Text } from '../core/motion/symbols.ts';
import { isTiny, scaleOf, tickText, withAir, type Range, type Scale, type ScaleSpec } from './scales.ts';
import type { Surface, Theme } from './surface.ts';
import { drawText, FONT_SIZE, widthOf } from './typeset.ts';
import { words as texts } from './words.ts';

export interface Axis extends ScaleSpec {
  title: Text;
  /** Of its numbers, for what is said of them. */
  unit?: string | undefined;
  /** What is shown; without it, what the marks need, with a little air. */
  range?: Range | undefined;
  /** Zero is within. */
  zero?: boolean | undefined;
  /** Room beyond the marks, a share of their span. */
  air?: number | undefined;
}

export interface Extent {
  x: Range;
  y: Range;
}

/** Something drawn within the frame: curves, cells, bands, lines. */
export interface Mark {
  /** Before the lines of the grid. */
  under?: boolean;
  /** Values that it needs to be seen; y over a part of x where that is given. Null where it needs nothing. */
  extent?(x: Range | null): Extent | null;
  draw(surface: Surface, frame: Frame, theme: Theme): void;
  /** What of it is at a place (px), by a number of its own; null where nothing is. */
  pick?(frame: Frame, x: number, y: number): number | null;
}

export interface Picture {
  x: Axis;
  y: Axis;
  /** A unit is as long on both axes. */
  equal?: boolean | undefined;
  marks: readonly Mark[];
  /** A scale of colours at the right; with `names` a list of colours, the first at the top. */
  bar?:
    { title?: Text; low: number; high: number; colour(share: number): string; names?: readonly string[] } | undefined;
}

/** Part of a picture that is looked at. */
export interface Zoom {
  x: Range | null;
  y: Range | null;
}

/** Where the marks are drawn, px, and the scales of its axes. */
export interface Frame {
  left: number;
  top: number;
  width: number;
  height: number;
  x: Scale;
  y: Scale;
  /** Device pixels in one px. */
  density: number;
  /** All that y moves by, where that is so little that it is drawn small and said. */
  span?: number | undefined;
}

export const toX = ({ left, width, x }: Frame, value: number): number => left + width * x.share(value);
export const toY = ({ top, height, y }: Frame, value: number): number => top + height * (1 - y.share(value));
export const fromX = ({ left, width, x }: Frame, px: number): number => x.value((px - left) / width);
export const fromY = ({ top, height, y }: Frame, px: number): number => y.value(1 - (px - top) / height);

const AIR = 0.06;
/** Beyond a tiny range on either side, in shares of it: no cliff. */
const TINY_AIR = 1.5;
/** Wide enough for most numbers, so that most charts stand in line, px. */
const LEFT = 56;
const RIGHT = 12;
const TOP = 8;
const TITLE = 18;
const TICK = 18;
const BAR = 72;
/** Of a list of colours with their names, and of one of its lines, px. */
const NAMES = { width: 132, line: 18, letters: 18 };
/** Of the words beside the colours' scale, px. */
const BAR_TITLE = 16;
/** Of a number along x, and of a line of numbers along y, px. */
const ROOM = { x: 64, y: 32 };
/** Narrower than this nothing can be read, px. */
export const SMALLEST = { width: 80, height: 50 };

/**
 * Where everything is. The left edge grows in steps, so that frames below each other stand in line.
 * @param size of the whole picture, px
 */
export function frameOf(
  surface: Surface,
  picture: Picture,
  size: { width: number; height: number },
  zoom: Zoom = { x: null, y: null },
  density = 1,
): Frame {
  const { x, y, equal, bar } = picture;
  const bottom = TICK + (x.title.length > 0 ? TITLE : 0);
  const height = Math.max(SMALLEST.height, size.height - TOP - bottom);
  let xRange = rangeOf(picture, 'x', null, zoom.x);
  let yRange = rangeOf(picture, 'y', zoom.x ?? x.range ?? null, zoom.y);
  const widest = (range: Range): number => {
    const scale = scaleOf(y, range);
    return Math.max(0, ...scale.ticks(height / ROOM.y).map((tick) => widthOf(surface, words(scale.text(tick)))));
  };
  const left = Math.max(LEFT, 8 * Math.ceil((widest(yRange) + 10 + (y.title.length > 0 ? TITLE : 0)) / 8));
  const width = Math.max(SMALLEST.width, size.width - left - RIGHT - (bar ? widthOfBar(bar) : 0));
  if (equal) {
    const perPixel = Math.max((xRange[1] - xRange[0]) / width, (yRange[1] - yRange[0]) / height);
    [xRange, yRange] = [around(xRange, (perPixel * width) / 2), around(yRange, (perPixel * height) / 2)];
  }
  const within = zoom.x ?? x.range ?? null;
  const needed = zoom.y || y.range || equal ? null : neededOf(picture, 'y', within);
  return {
    left,
    top: TOP,
    width,
    height,
    x: scaleOf(x, xRange),
    y: scaleOf(y, yRange),
    density,
    span: needed && tiny(y, needed) ? needed[1] - needed[0] : undefined,
  };
}

const tiny = ({ kind = 'linear' }: Axis, range: Range): boolean => kind === 'linear' && isTiny(range);

const around = ([low, high]: Range, half: number): Range => [(low + high) / 2 - half, (low + high) / 2 + half];

/** What an axis shows: what is zoomed to, what it says itself, or what the marks need. */
export function rangeOf(
  { marks, ...axes }: Picture,
  along: 'x' | 'y',
  within: Range | null,
  zoom: Range | null,
): Range {
  if (zoom) return zoom;
  const { range, air = AIR, kind } = axes[along];
  if (range) return range;
  const needed = neededOf({ marks, ...axes }, along, within);
  return withAir(needed, along === 'y' && !axes.equal && tiny(axes.y, needed) ? TINY_AIR : air, kind);
}

/** What the marks need; low above high where they need nothing. */
function neededOf({ marks, ...axes }: Picture, along: 'x' | 'y', within: Range | null): Range {
  const { zero } = axes[along];
  let low = zero ? 0 : Infinity;
  let high = zero ? 0 : -Infinity;
  for (const mark of marks) {
    const extent = mark.extent?.(within)?.[along];
    if (!extent || !(extent[0] <= extent[1])) continue;
    if (extent[0] < low) low = extent[0];
    if (extent[1] > high) high = extent[1];
  }
  return [low, high];
}

/** Everything: what lies under the grid, the grid, axes, marks. */
export function paint(surface: Surface, frame: Frame, picture: Picture, theme: Theme): void {
  const within = (draw: () => void): void => {
    surface.save();
    surface.beginPath();
    surface.rect(frame.left, frame.top, frame.width, frame.height);
    surface.clip();
    draw();
    surface.restore();
  };
  const [under, over] = [picture.marks.filter((m) => m.under), picture.marks.filter((m) => !m.under)];
  if (under.length > 0) within(() => under.forEach((mark) => mark.draw(surface, frame, theme)));
  axes(surface, frame, picture, theme);
  within(() => over.forEach((mark) => mark.draw(surface, frame, theme)));
  if (picture.bar) (picture.bar.names ? nameList : bar)(surface, frame, picture.bar, theme);
  if (frame.span !== undefined) {
    surface.fillStyle = theme.ink;
    const said = texts.range(tickText(Number(frame.span.toPrecision(2))), picture.y.unit ?? '');
    drawText(surface, words(said), frame.left + 6, frame.top + 9);
  }
}

function axes(surface: Surface, frame: Frame, { x, y }: Picture, theme: Theme): void {
  const { left, top, width, height } = frame;
  const bottom = top + height;
  surface.lineWidth = 1;
  surface.setLineDash([]);
  surface.strokeStyle = theme.line;
  surface.fillStyle = theme.ink;
  surface.beginPath();
  for (const tick of frame.x.ticks(width / ROOM.x)) {
    const at = Math.round(toX(frame, tick)) + 0.5;
    surface.moveTo(at, x.kind === 'steps' ? bottom : top);
    surface.lineTo(at, bottom + 3);
    drawText(surface, words(short(frame.x.text(tick), 12)), at, bottom + 11, 'center');
  }
  surface.stroke();
  surface.beginPath();
  for (const tick of frame.y.ticks(height / (y.kind === 'steps' ? FONT_SIZE + 5 : ROOM.y))) {
    const at = Math.round(toY(frame, tick)) + 0.5;
    surface.moveTo(left - 3, at);
    surface.lineTo(y.kind === 'steps' ? left : left + width, at);
    drawText(surface, words(short(frame.y.text(tick), 12)), left - 6, at, 'right');
  }
  surface.stroke();
  if (x.title.length > 0) drawText(surface, x.title, left + width / 2, bottom + TICK + 8, 'center');
  if (y.title.length === 0) return;
  surface.save();
  surface.translate(9, top + height / 2);
  surface.rotate(-Math.PI / 2);
  drawText(surface, y.title, 0, 0, 'center');
  surface.restore();
}

/** The colours' scale: the numbers at its ends and between. */
const widthOfBar = ({ title, names }: NonNullable<Picture['bar']>): number =>
  names ? NAMES.width : BAR + (title ? BAR_TITLE : 0);

/** The colours' names, one below the other. */
function nameList(
  surface: Surface,
  frame: Frame,
  { names = [], colour }: NonNullable<Picture['bar']>,
  theme: Theme,
): void {
  const left = frame.left + frame.width + 14;
  names.forEach((name, i) => {
    const top = frame.top + i * NAMES.line;
    surface.fillStyle = colour(names.length > 1 ? i / (names.length - 1) : 0);
    surface.fillRect(left, top, 12, 12);
    surface.fillStyle = theme.ink;
    drawText(surface, words(short(name, NAMES.letters)), left + 17, top + 6);
  });
}

function bar(
  surface: Surface,
  frame: Frame,
  { title, low, high, colour }: NonNullable<Picture['bar']>,
  theme: Theme,
): void {
  if (!(low <= high)) return;
  const left = frame.left + frame.width + 14;
  const { top, height } = frame;
  for (let i = 0; i < height; i++) {
    surface.fillStyle = colour(high > low ? 1 - i / (height - 1) : 0.5);
    surface.fillRect(left, top + i, 12, 1.5);
  }
  surface.fillStyle = theme.ink;
  const scale = scaleOf({}, high > low ? [low, high] : [low - 1, low + 1]);
  for (const tick of high > low ? scale.ticks(height / ROOM.y) : [low])
    drawText(
      surface,
      words(scale.text(Number(tick.toPrecision(6)))),
      left + 16,
      top + height * (1 - scale.share(tick)),
    );
  if (!title) return;
  surface.save();
  surface.translate(left + BAR, top + height / 2);
  surface.rotate(-Math.PI / 2);
  drawText(surface, title, 0, 0, 'center');
  surface.restore();
}

const short = (text: string, most: number): string => (text.length > most ? `${text.slice(0, most - 1)}…` : text);
