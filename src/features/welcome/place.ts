/** Where a card stands beside what it speaks of: never over it, always within the page. */
export interface Rect {
  left: number;
  top: number;
  right: number;
  bottom: number;
}

export interface Size {
  width: number;
  height: number;
}

/** Between the card and what it speaks of, and from the page's edges (CSS pixels). */
const GAP = 12;

/**
 * Left top corner of a card of this size beside a target. The first side with room is taken, of right, below, above, left;
 * without any, the side with the most.
 */
export function placeBeside(target: Rect, card: Size, page: Size): { left: number; top: number } {
  const room = {
    right: page.width - target.right,
    below: page.height - target.bottom,
    above: target.top,
    left: target.left,
  };
  const needs = { right: card.width, below: card.height, above: card.height, left: card.width };
  const sides = ['right', 'below', 'above', 'left'] as const;
  const fits = sides.find((side) => room[side] >= needs[side] + 2 * GAP);
  const side =
    fits ?? sides.reduce((best, next) => (room[next] - needs[next] > room[best] - needs[best] ? next : best));
  const within = (value: number, length: number, whole: number) => Math.max(GAP, Math.min(value, whole - length - GAP));
  const left = side === 'right' ? target.right + GAP : side === 'left' ? target.left - GAP - card.width : target.left;
  const top = side === 'below' ? target.bottom + GAP : side === 'above' ? target.top - GAP - card.height : target.top;
  return { left: within(left, card.width, page.width), top: within(top, card.height, page.height) };
}
