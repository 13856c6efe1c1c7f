/** Points of a line drawn in one go. A stroke's price grows faster than its points: where many lines cross, many short ones cost a tenth of a long one. */
const PIECE = 32;

/** Draws lines of any number of points, in the style that its context has. */
export class Pen {
  private readonly context: CanvasRenderingContext2D;
  private readonly piece: number;
  private points = 0;

  /** @param dashed in one piece: a dash would begin anew with every other */
  constructor(context: CanvasRenderingContext2D, dashed: boolean) {
    this.context = context;
    this.piece = dashed ? Infinity : PIECE;
    context.beginPath();
  }

  moveTo(x: number, y: number): void {
    this.context.moveTo(x, y);
  }

  lineTo(x: number, y: number): void {
    const { context } = this;
    context.lineTo(x, y);
    if (++this.points % this.piece !== 0) return;
    context.stroke();
    context.beginPath();
    context.moveTo(x, y);
  }

  /** Draws the rest. */
  end(): void {
    this.context.stroke();
  }
}

/** Lines are drawn by the processor: where no graphics card is, emulating one takes a hundred times as long, and a scene waits for it. */
export const lineContext = (canvas: HTMLCanvasElement): CanvasRenderingContext2D => canvas.getContext('2d', { willReadFrequently: true })!;
