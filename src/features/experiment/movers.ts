import { columnOf } from '../../core/motion/columns.ts';
import type { SystemMeta } from '../../core/model/system.ts';

/**
 * What moves most in some modes, each once, by its symbol.
 *
 * @param meta of the system
 * @param modes each with the states that move in it, the first the most
 */
export const movers = (meta: SystemMeta, modes: readonly { moves: readonly string[] }[]): string =>
  [...new Set(modes.flatMap(({ moves }) => moves.slice(0, 1)))]
    .map((name) => columnOf(meta, name))
    .map(({ symbol, rate }) => (rate ? symbol.replace(/^./u, '$&\u0307') : symbol))
    .join(', ');
