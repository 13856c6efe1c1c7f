import type { Surface } from './surface.ts';

/** Points of a line drawn in one go. A stroke's price grows faster than its points: where many lines cross, many short ones cost a tenth of a long one. */
const PIECE = 16;
/** A piece so many times longer than the half outline of what it covers goes to and fro, and fills that. */
const FILLING = 2.5;

export interface LineStyle {
  width: number;
  dash?: readonly number[] | undefined;
  /** The thinnest line of the context: one device pixel, in its units. */
  hair: number;
}

/**
 * Draws lines of any number of points in the context's colour. Where a line goes to and fro so closely that it fills
 * what it covers, it is drawn thin and without dashes, which nobody sees there and which cost ten times as much.
 */
export class Pen {
  private readonly context: Surface;
  private readonly style: LineStyle;
  private points = 0;
  /** Where the pen is. */
  private x = NaN;
  private y = NaN;
  /** Of this piece, and of the line before it: its dashes go on. */
  private length = 0;
  private before = 0;
  private left = Infinity;
  private right = -Infinity;
  private top = Infinity;
  private bottom = -Infinity;

  constructor(context: Surface, style: LineStyle) {
    this.context = context;
    this.style = style;
    context.beginPath();
  }

  moveTo(x: number, y: number): void {
    // Dashes begin anew.
    if (this.style.dash) this.end();
    this.before = 0;
    this.context.moveTo(x, y);
    this.reach(x, y);
  }

  lineTo(x: number, y: number): void {
    this.context.lineTo(x, y);
    this.length += Math.hypot(x - this.x, y - this.y);
    this.reach(x, y);
    if (++this.points < PIECE) return;
    this.end();
    this.context.moveTo(x, y);
    this.reach(x, y);
  }

  /** Draws the rest. */
  end(): void {
    if (this.points > 0) this.stroke();
    this.before += this.length;
    this.points = this.length = 0;
    this.left = this.top = Infinity;
    this.right = this.bottom = -Infinity;
    this.context.beginPath();
  }

  private stroke(): void {
    const { context, style } = this;
    const filling = this.length > FILLING * (this.right - this.left + this.bottom - this.top);
    context.lineWidth = filling ? Math.min(style.hair, style.width) : style.width;
    context.setLineDash(style.dash && !filling ? [...style.dash] : []);
    context.lineDashOffset = this.before;
    context.stroke();
  }

  private reach(x: number, y: number): void {
    this.x = x;
    this.y = y;
    if (x < this.left) this.left = x;
    if (x > this.right) this.right = x;
    if (y < this.top) this.top = y;
    if (y > this.bottom) this.bottom = y;
  }
}

/** Lines are drawn by the processor: where no graphics card is, emulating one takes a hundred times as long, and a scene waits for it. */
export const lineContext = (canvas: HTMLCanvasElement): CanvasRenderingContext2D =>
  canvas.getContext('2d', { willReadFrequently: true })!;
