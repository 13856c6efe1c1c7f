import { isTall, type Text, type TextRun } from '../core/motion/symbols.ts';
import type { Surface } from './surface.ts';

export const FONT_SIZE = 11;
const SUB_SIZE = 9;
const SUB_DROP = 3;
const WORDS = 'system-ui, sans-serif';
/** As the page sets its symbols. */
const LETTERS = "'STIX Two Text', 'Cambria Math', Cambria, Georgia, 'Times New Roman', serif";

const fontOf = ({ sub, math }: TextRun): string =>
  math ? `italic ${sub ? SUB_SIZE + 1 : FONT_SIZE + 2}px ${LETTERS}` : `${sub ? SUB_SIZE : FONT_SIZE}px ${WORDS}`;

function widthsOf(surface: Surface, text: Text): number[] {
  return text.map((run) => {
    surface.font = fontOf(run);
    return surface.measureText(run.text).width;
  });
}

export const widthOf = (surface: Surface, text: Text): number => widthsOf(surface, text).reduce((a, b) => a + b, 0);

/** Draws typeset text, its middle at y. */
export function drawText(
  surface: Surface,
  text: Text,
  x: number,
  y: number,
  align: 'left' | 'center' | 'right' = 'left',
): void {
  const widths = widthsOf(surface, text);
  const all = widths.reduce((a, b) => a + b, 0);
  let at = align === 'left' ? x : align === 'center' ? x - all / 2 : x - all;
  surface.textAlign = 'left';
  surface.textBaseline = 'middle';
  text.forEach((run, i) => {
    surface.font = fontOf(run);
    surface.fillText(run.text, at, y + (run.sub ? SUB_DROP : 0));
    if (run.dot) {
      surface.beginPath();
      surface.arc(at + widths[i]! / 2 + (run.math ? 1 : 0), y - (isTall(run.text) ? 7 : 5.5), 1, 0, 2 * Math.PI);
      surface.fill();
    }
    at += widths[i]!;
  });
}
