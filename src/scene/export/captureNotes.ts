/** What the page writes around its scene, written into a picture of it: all in CSS pixels of that picture. */
import type { ScreenBox } from '../contract.ts';

export interface PictureSize {
  width: number;
  height: number;
}

type Theme = 'light' | 'dark';

const FONT = 'system-ui, sans-serif';
/** From the picture's edges, and from one note to the next. */
const MARGIN = 12;
const GAP = 8;
const LINE = 20;
/** The close-up's width: at least, at most, and per width of the picture. */
const CLOSE_UP = { least: 112, most: 240, share: 0.26, aspect: 4 / 3 } as const;
/** The page's own tokens: text, muted text, frames, and the veil that keeps words readable. */
const COLOURS = {
  light: {
    text: '#191e23',
    muted: '#57616b',
    edge: '#868f98',
    veil: 'rgb(255 255 255 / 84%)',
    halo: 'rgb(246 247 248 / 85%)',
  },
  dark: {
    text: '#e4e8eb',
    muted: '#9ba6b0',
    edge: '#6d7882',
    veil: 'rgb(23 27 31 / 84%)',
    halo: 'rgb(18 21 26 / 85%)',
  },
} as const;

/** Where the close-up stands: in the upper right corner as on the page; null in a picture too small to hold it. */
export function closeUpBox({ width, height }: PictureSize): ScreenBox | null {
  const wide = Math.round(Math.min(CLOSE_UP.most, Math.max(CLOSE_UP.least, CLOSE_UP.share * width)));
  const tall = Math.round(wide / CLOSE_UP.aspect);
  if (2 * wide > width || 2 * tall > height) return null;
  return { left: width - MARGIN - wide, top: MARGIN, right: width - MARGIN, bottom: MARGIN + tall };
}

/** A hairline around the close-up, and its title in a corner of it. */
export function writeCloseUp(
  context: CanvasRenderingContext2D,
  { left, top, right, bottom }: ScreenBox,
  title: string,
  theme: Theme,
): void {
  const { edge, muted } = COLOURS[theme];
  word(context, title, left, top, theme, muted);
  context.strokeStyle = edge;
  context.lineWidth = 1;
  context.strokeRect(left - 0.5, top - 0.5, right - left + 1, bottom - top + 1);
}

/** A bar as long as the arrow of that force, under the close-up or in its place. */
export function writeLegend(
  context: CanvasRenderingContext2D,
  { width }: PictureSize,
  closeUp: ScreenBox | null,
  bar: { pixels: number; label: string },
  theme: Theme,
): void {
  context.font = `12px ${FONT}`;
  const wide = context.measureText(bar.label).width + bar.pixels + GAP + 12;
  const left = width - MARGIN - wide;
  const top = closeUp ? closeUp.bottom + GAP : MARGIN;
  const { text, muted } = COLOURS[theme];
  word(context, bar.label, left, top, theme, muted, bar.pixels + GAP);
  const [from, to, y] = [left + 6, left + 6 + bar.pixels, top + LINE / 2];
  context.beginPath();
  context.moveTo(from, y - 4);
  context.lineTo(from, y + 4);
  context.moveTo(from, y);
  context.lineTo(to, y);
  context.moveTo(to - 7, y - 3.5);
  context.lineTo(to, y);
  context.lineTo(to - 7, y + 3.5);
  context.strokeStyle = text;
  context.lineWidth = 1.5;
  context.stroke();
}

/** Title and time along the foot, as large as there is room for. */
export function writeCaption(
  context: CanvasRenderingContext2D,
  { width, height }: PictureSize,
  caption: string,
  theme: Theme,
): void {
  let size = Math.min(width, height) / 30;
  const font = (): string => `500 ${size}px ${FONT}`;
  context.font = font();
  const room = width - 2 * size;
  const wide = context.measureText(caption).width;
  if (wide > room) size *= room / wide;
  context.font = font();
  context.textBaseline = 'alphabetic';
  context.lineJoin = 'round';
  context.lineWidth = size / 4;
  context.strokeStyle = COLOURS[theme].halo;
  context.fillStyle = COLOURS[theme].text;
  context.strokeText(caption, size, height - size);
  context.fillText(caption, size, height - size);
}

/** A line of words on its veil, with room for something before them. */
function word(
  context: CanvasRenderingContext2D,
  words: string,
  left: number,
  top: number,
  theme: Theme,
  ink: string,
  before = 0,
): void {
  context.font = `12px ${FONT}`;
  context.fillStyle = COLOURS[theme].veil;
  context.fillRect(left, top, context.measureText(words).width + before + 12, LINE);
  context.fillStyle = ink;
  context.textBaseline = 'middle';
  context.fillText(words, left + 6 + before, top + LINE / 2 + 0.5);
}
