/** `α_fp` set with its subscript. */
export function MathSymbol({ of }: { of: string }) {
  const [base, ...rest] = of.split('_');
  return (
    <span class="symbol" aria-hidden="true">
      {base}
      {rest.length > 0 && <sub>{rest.join('_')}</sub>}
    </span>
  );
}

/** The colour of the part a row belongs to; neutral for the whole board. */
export function Chip({ part }: { part: 'board' | 'front' | 'back' }) {
  return <span class={`chip chip-${part}`} aria-hidden="true" />;
}
