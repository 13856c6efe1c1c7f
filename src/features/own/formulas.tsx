/** The equations of what is typed, set under the editor as they come. */
import { loadKatex, type Katex } from '../../ui/kit/math.tsx';
import { useEffect, useRef, useState } from 'preact/hooks';
import { setMarks, type Typeset } from '../../core/model/typeset.ts';
import { loadTypeset, systemMetas } from '../../core/systems/registry.ts';
import { words } from './words.ts';

/** Coordinates up to which they are set while a person types. */
const MOST_COORDINATES = 7;

interface Shown {
  typeset: Typeset;
  katex: Katex;
}

/** @param id of the system that was read last */
export function Formulas({ id }: { id: string }) {
  const [shown, setShown] = useState<Shown | null>(null);
  const long = (systemMetas[id]?.coordinates.length ?? 0) > MOST_COORDINATES;
  useEffect(() => {
    let current = true;
    if (!long)
      void Promise.all([loadTypeset(id), loadKatex()]).then(
        ([typeset, katex]) => current && typeset && setShown({ typeset, katex }),
        // The equations tool says what could not be loaded.
        () => undefined,
      );
    return () => {
      current = false;
    };
  }, [id, long]);
  if (long) return <p class="hint">{words.long}</p>;
  if (!shown) return null;
  const { energies, motion, constraints, structure } = shown.typeset;
  const rows = constraints[0]?.rows.map(({ latex }) => latex) ?? [];
  const lines = [energies.lagrangian, ...(motion.length > 0 ? motion : structure.slice(0, 2)), ...rows];
  return (
    <div data-testid="own-formulas" data-system={shown.typeset.system}>
      {lines.map((latex, k) => latex && <Line key={k} latex={latex} shown={shown} />)}
      <p class="hint">{motion.length > 0 ? words.more : words.long}</p>
    </div>
  );
}

function Line({ latex, shown: { typeset, katex } }: { latex: string; shown: Shown }) {
  const box = useRef<HTMLDivElement>(null);
  useEffect(() => {
    const options = { output: 'htmlAndMathml', strict: false, throwOnError: false } as const;
    katex.render(setMarks(latex, typeset.symbols), box.current!, options);
  }, [latex, typeset]);
  return <div class="own-formula" ref={box} tabIndex={0} role="group" aria-label={words.formula} />;
}
