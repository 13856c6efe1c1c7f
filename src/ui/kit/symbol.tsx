import type { ColourRole } from '../../core/model/system.ts';

/** `α_fp` set with its subscript; a rate has a dot over its letter, drawn, for few fonts have one that sits well. */
export function MathSymbol({ of, rate = false }: { of: string; rate?: boolean | undefined }) {
  const [base, ...rest] = of.split('_');
  return (
    <span class={`symbol${rate ? ' dotted' : ''}`} aria-hidden="true">
      {base}
      {rest.length > 0 && <sub>{rest.join('_')}</sub>}
    </span>
  );
}

/** The colour of what a row belongs to. */
export function Chip({ role }: { role: ColourRole }) {
  return <span class={`chip chip-${role}`} aria-hidden="true" />;
}
