import { useUi } from './context.ts';
import type { SlotName } from './feature.ts';

/** What the features put into one slot, in the order of the registry. */
export function Slot({ name }: { name: SlotName }) {
  return <>{useUi().features.map(({ id, [name]: Body }) => (Body ? <Body key={id} /> : null))}</>;
}
