import type { Surface } from './surface.ts';

interface State {
  strokeStyle: string;
  fillStyle: string;
  lineWidth: number;
  lineDashOffset: number;
  lineJoin: CanvasLineJoin;
  globalAlpha: number;
  font: string;
  textAlign: CanvasTextAlign;
  textBaseline: CanvasTextBaseline;
  dash: readonly number[];
  /** Groups opened since the last save. */
  groups: number;
}

const ANCHORS: Record<string, string> = { left: 'start', start: 'start', center: 'middle', right: 'end', end: 'end' };
/** From the baseline to where the text is asked for, in its size. */
const SHIFTS: Record<string, number> = { middle: 0.35, top: 0.8, bottom: -0.2 };

/**
 * Takes the calls of a canvas and writes them as SVG. Half of what a chart asks for: lines, arcs that are whole circles,
 * rectangles, text, clipping by rectangles.
 */
export class SvgSurface implements Surface {
  strokeStyle = '#000';
  fillStyle = '#000';
  lineWidth = 1;
  lineDashOffset = 0;
  lineJoin: CanvasLineJoin = 'round';
  globalAlpha = 1;
  font = '11px sans-serif';
  textAlign: CanvasTextAlign = 'left';
  textBaseline: CanvasTextBaseline = 'alphabetic';
  private dash: readonly number[] = [];
  private groups = 0;
  private readonly out: string[] = [];
  private readonly states: State[] = [];
  private path = '';
  private box = '';
  private clips = 0;
  private readonly id: string;

  /** @param id begins the ids of its clip paths: unlike those of other pictures of the page */
  constructor(id = 'chart') {
    this.id = id;
  }

  toString(): string {
    return this.out.join('\n');
  }

  beginPath(): void {
    this.path = this.box = '';
  }
  moveTo(x: number, y: number): void {
    this.path += `M${px(x)} ${px(y)}`;
  }
  lineTo(x: number, y: number): void {
    this.path += `L${px(x)} ${px(y)}`;
  }
  /** Whole circles alone. */
  arc(x: number, y: number, r: number): void {
    this.path += `M${px(x - r)} ${px(y)}a${px(r)} ${px(r)} 0 1 0 ${px(2 * r)} 0a${px(r)} ${px(r)} 0 1 0 ${px(-2 * r)} 0`;
  }
  rect(x: number, y: number, w: number, h: number): void {
    this.box = `x="${px(x)}" y="${px(y)}" width="${px(w)}" height="${px(h)}"`;
    this.path += `M${px(x)} ${px(y)}h${px(w)}v${px(h)}h${px(-w)}z`;
  }
  stroke(): void {
    this.out.push(`<path d="${this.path}" fill="none"${this.strokes()}/>`);
  }
  fill(): void {
    this.out.push(`<path d="${this.path}" fill="${this.fillStyle}"${this.alpha()}/>`);
  }
  clip(): void {
    const id = `${this.id}-clip-${++this.clips}`;
    this.out.push(`<clipPath id="${id}"><rect ${this.box}/></clipPath>`);
    this.open(`clip-path="url(#${id})"`);
  }
  fillRect(x: number, y: number, w: number, h: number): void {
    this.out.push(
      `<rect x="${px(x)}" y="${px(y)}" width="${px(w)}" height="${px(h)}" fill="${this.fillStyle}"${this.alpha()}/>`,
    );
  }
  strokeRect(x: number, y: number, w: number, h: number): void {
    this.out.push(`<rect x="${px(x)}" y="${px(y)}" width="${px(w)}" height="${px(h)}" fill="none"${this.strokes()}/>`);
  }
  fillText(text: string, x: number, y: number): void {
    const size = this.size();
    const family = this.font.slice(this.font.indexOf('px') + 3).replaceAll('"', "'");
    const style = this.font.startsWith('italic') ? ' font-style="italic"' : '';
    const weight = /\b(600|bold)\b/.test(this.font) ? ' font-weight="600"' : '';
    this.out.push(
      `<text x="${px(x)}" y="${px(y + size * (SHIFTS[this.textBaseline] ?? 0))}" font-size="${size}" font-family="${family}"${style}${weight} text-anchor="${ANCHORS[this.textAlign]}" fill="${this.fillStyle}">${escaped(text)}</text>`,
    );
  }
  /** About what a sans serif takes: a file has no fonts to measure. */
  measureText(text: string): TextMetrics {
    const em = [...text].reduce((sum, letter) => sum + emsOf(letter), 0);
    return { width: em * this.size() } as TextMetrics;
  }
  setLineDash(dash: Iterable<number>): void {
    this.dash = [...dash];
  }
  save(): void {
    const { strokeStyle, fillStyle, lineWidth, lineDashOffset, lineJoin, globalAlpha, font, textAlign, textBaseline } =
      this;
    const { dash, groups } = this;
    this.states.push({
      strokeStyle,
      fillStyle,
      lineWidth,
      lineDashOffset,
      lineJoin,
      globalAlpha,
      font,
      textAlign,
      textBaseline,
      dash,
      groups,
    });
    this.groups = 0;
  }
  restore(): void {
    const state = this.states.pop();
    if (!state) return;
    for (; this.groups > 0; this.groups--) this.out.push('</g>');
    Object.assign(this, state);
  }
  translate(x: number, y: number): void {
    this.open(`transform="translate(${px(x)} ${px(y)})"`);
  }
  rotate(angle: number): void {
    this.open(`transform="rotate(${px((angle * 180) / Math.PI)})"`);
  }

  private open(attributes: string): void {
    this.out.push(`<g ${attributes}>`);
    this.groups++;
  }
  private size(): number {
    return Number(/([\d.]+)px/.exec(this.font)?.[1] ?? 11);
  }
  private alpha(): string {
    return this.globalAlpha === 1 ? '' : ` opacity="${this.globalAlpha}"`;
  }
  private strokes(): string {
    const dash = this.dash.length > 0 ? ` stroke-dasharray="${this.dash.join(' ')}"` : '';
    const offset = dash && this.lineDashOffset ? ` stroke-dashoffset="${px(this.lineDashOffset)}"` : '';
    return ` stroke="${this.strokeStyle}" stroke-width="${px(this.lineWidth)}" stroke-linejoin="${this.lineJoin}"${dash}${offset}${this.alpha()}`;
  }
}

/** Width of a letter, in sizes of the font. */
const emsOf = (letter: string): number =>
  /[ ,.:;'|ijlI\u202f]/.test(letter) ? 0.3 : /[A-Zmw]/.test(letter) ? 0.7 : /[0-9\u2212]/.test(letter) ? 0.6 : 0.53;

const px = (x: number): string => String(Math.round(10 * x) / 10 + 0);
export const escaped = (text: string): string =>
  text.replace(/&/g, '&amp;').replace(/</g, '&lt;').replace(/"/g, '&quot;');
