import { equations } from './words.ts';
import { formatShort, THIN } from '../../ui/kit/format.ts';
import { useBook } from './context.ts';
import { Formula } from './formula.tsx';
import { usePresent } from './usePresent.ts';

const words = equations.energy;

export function LagrangianSection() {
  const { typeset } = useBook();
  return (
    <>
      <Energies />
      {(['kinetic', 'potential', 'lagrangian'] as const).map((kind) => {
        const latex = typeset.energies[kind];
        return latex && <Formula key={kind} latex={latex} title={words[kind]} label={words[kind]} />;
      })}
    </>
  );
}

/** T, V and L at the time on the stage. */
function Energies() {
  const shown = usePresent();
  if (!shown) return null;
  const { kinetic, potential } = shown.present;
  const values = [
    ['T', kinetic],
    ['V', potential],
    ['L', kinetic - potential],
  ] as const;
  return (
    <dl class="energies" aria-label={`${words.lagrangian}, ${words.now}`}>
      {values.map(([symbol, value]) => (
        <div key={symbol}>
          <dt>{symbol}</dt>
          <dd data-testid={`equations-${symbol}`}>
            {formatShort(value, 5)}
            {THIN}J
          </dd>
        </div>
      ))}
    </dl>
  );
}
