/** On the time line: a band that is strong where four digits are right and fades to nothing where none is. */
import { useUi } from '../../ui/context.ts';
import { saidOf, stopsOf } from './said.ts';
import { words } from './words.ts';

export function TrustBand() {
  const { state } = useUi().app;
  const known = state.trust.value;
  const trajectory = state.motion.value?.trajectory;
  if (known?.kind !== 'compared' || !trajectory) return null;
  const stops = stopsOf(known.trust, trajectory.start, trajectory.end).map(
    ({ at, strength }) =>
      `color-mix(in srgb, var(--accent) ${Math.round(100 * strength)}%, transparent) ${(100 * at).toFixed(2)}%`,
  );
  return (
    <span
      class="trust-band"
      data-testid="trust-band"
      role="img"
      aria-label={words.band(saidOf(known.trust))}
      style={{ background: `linear-gradient(to right, ${stops.join(', ')})` }}
    />
  );
}
