/** Symbols as runs of text, so that a canvas, the page and an SVG file set the same: `α_fp` with a real subscript, a rate with a dot. */

export interface TextRun {
  text: string;
  /** Below the line, smaller. */
  sub?: boolean;
  /** A dot above the run's first letter: a rate. */
  dot?: boolean;
  /** A letter that stands for a quantity: set in italics. */
  math?: boolean;
}

export type Text = readonly TextRun[];

/** Letters that reach as high as capitals: a dot stands higher above them. */
const TALL = /^[A-Z\u0391-\u03a9bdfhklβδζθλξφψ]/;
export const isTall = (text: string): boolean => TALL.test(text);

/** Latin and Greek small letters slant; capitals of Greek, digits and words stand upright. */
const SLANTED = /^[A-Za-z\u03b1-\u03c9]$/;

/**
 * A symbol of the catalogue as text runs.
 * @param symbol a letter and, after `_`, its subscript: `α_fp`, `J_spin`, `X`
 * @param rate a dot above the letter
 */
export function symbolText(symbol: string, rate = false): Text {
  const cut = symbol.indexOf('_');
  const base = cut < 0 ? symbol : symbol.slice(0, cut);
  const sub = cut < 0 ? '' : symbol.slice(cut + 1);
  const first: TextRun = { text: base, ...(SLANTED.test(base) ? { math: true } : {}), ...(rate ? { dot: true } : {}) };
  if (sub === '') return [first];
  return [first, { text: sub, sub: true, ...(first.math && /^[A-Za-z]+$/.test(sub) ? { math: true } : {}) }];
}

/** Words as they are. */
export const words = (text: string): Text => (text === '' ? [] : [{ text }]);

/**
 * Texts one after another with something between.
 *
 * @param texts to be joined
 * @param between what stands between two
 */
export function joined(texts: readonly Text[], between = ', '): Text {
  return texts.flatMap((text, i) => (i === 0 ? text : [{ text: between }, ...text]));
}

/** The letters alone, for what can show no more: names of files, accessible names. A rate wears a combining dot. */
export const plainText = (text: Text): string => text.map((run) => (run.dot ? `${run.text}\u0307` : run.text)).join('');
