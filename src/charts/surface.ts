/** What a chart is drawn on: a canvas, or an SVG file that takes the same calls. */

export type Surface = Pick<
  CanvasRenderingContext2D,
  | 'beginPath'
  | 'moveTo'
  | 'lineTo'
  | 'arc'
  | 'rect'
  | 'stroke'
  | 'fill'
  | 'clip'
  | 'fillRect'
  | 'strokeRect'
  | 'fillText'
  | 'measureText'
  | 'save'
  | 'restore'
  | 'translate'
  | 'rotate'
  | 'setLineDash'
  | 'lineDashOffset'
  | 'lineWidth'
  | 'lineJoin'
  | 'strokeStyle'
  | 'fillStyle'
  | 'globalAlpha'
  | 'font'
  | 'textAlign'
  | 'textBaseline'
>;

/** Colours of a chart, apart from those of its marks. */
export interface Theme {
  text: string;
  ink: string;
  line: string;
  surface: string;
  accent: string;
  /** Behind what grows. */
  growing: string;
  /** A cell without a value. */
  empty: string;
}

/** For files: on white. */
export const PRINT: Theme = {
  text: '#1b1e22',
  ink: '#555b63',
  line: '#e3e5e8',
  surface: '#ffffff',
  accent: '#0b62d6',
  growing: '#fbeeee',
  empty: '#f0f1f3',
};
