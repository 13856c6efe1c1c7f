/** How curves of a motion's columns are told apart, in every chart of them. */
import type { Column } from '../core/motion/columns.ts';
import { token } from './tokens.ts';

/** Told apart by colour-blind people too, and by their dashes. The first is orange and the second blue, as everywhere. */
const OTHERS = ['#009e73', '#cc79a7', '#8a8f98', '#a6761d', '#7570b3', '#17a2b8'];
const DASHES: readonly (readonly number[] | undefined)[] = [undefined, [7, 4], [2, 3], [9, 3, 2, 3]];

export interface CurveStyle {
  color: string;
  dash: readonly number[] | undefined;
}

/** A style for each curve of a pane: the colour of its role, a dash of its own among those of one colour. */
export function stylesOf(columns: readonly Column[]): CurveStyle[] {
  const used = new Map<string, number>();
  let other = 0;
  return columns.map(({ role }) => {
    const color =
      role === 'first' || role === 'second'
        ? token(`--${role}`)
        : role === 'neutral' && !used.has('neutral')
          ? token('--neutral')
          : OTHERS[other++ % OTHERS.length]!;
    const key = role === 'neutral' && color === token('--neutral') ? 'neutral' : color;
    const nth = used.get(key) ?? 0;
    used.set(key, nth + 1);
    return { color, dash: DASHES[nth % DASHES.length] };
  });
}
