import type { ColourRole } from '../../core/model/system.ts';

/** The colour of what a row belongs to. */
export function Chip({ role }: { role: ColourRole }) {
  return <span class={`chip chip-${role}`} aria-hidden="true" />;
}
