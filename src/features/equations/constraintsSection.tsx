import { useState } from 'preact/hooks';
import type { TypesetConstraints } from '../../core/model/typeset.ts';
import { equations } from './words.ts';
import { useUi } from '../../ui/context.ts';
import { formatCount } from '../../ui/kit/format.ts';
import { inWords, useBook } from './context.ts';
import { Formula } from './formula.tsx';

const { constraints: words, headings } = equations;

/** Every set's rows with their names, the entries of Omega, and the heights that are kept at zero. */
export function ConstraintsSection() {
  const { typeset } = useBook();
  const { motion } = useUi().app.state;
  if (typeset.constraints.length === 0) return <p class="hint">{words.none}</p>;
  return (
    <>
      {typeset.contacts.length > 0 && <h4>{headings.contacts}</h4>}
      {typeset.contacts.map((latex, i) => (
        <Formula key={i} latex={latex} title={`${headings.contacts} ${i + 1}`} />
      ))}
      {typeset.constraints.map((set) => (
        <ConstraintSet key={set.id} set={set} inForce={motion.value?.constraints === set.id} />
      ))}
    </>
  );
}

function ConstraintSet({ set, inForce }: { set: TypesetConstraints; inForce: boolean }) {
  const { meta } = useBook().view;
  const label = meta.constraintSets.find(({ id }) => id === set.id)?.label ?? set.id;
  return (
    <section aria-label={label} data-testid={`equations-set-${set.id}`}>
      <h4>
        {label}
        {inForce && <span class="in-force">{words.inForce}</span>}
      </h4>
      {set.rows.map(({ title, latex }, k) => {
        const name = words.titles[title] ?? title;
        return <Formula key={k} latex={latex} title={name} label={`${k + 1}  ${name}`} />;
      })}
      {set.heights.length > 0 && <h5>{headings.heights}</h5>}
      {set.heights.map((latex, k) => (
        <Formula key={k} latex={latex} title={`${headings.heights} ${k + 1}`} />
      ))}
      <h5>{headings.omega}</h5>
      {set.rows.map((row, k) => (
        <Entries key={k} row={row} />
      ))}
      {set.rows.some(({ gamma }) => gamma) && <h5>{headings.gamma}</h5>}
      {set.rows.map(({ gamma }, k) => gamma && <Formula key={k} latex={gamma} title={`γ ${k + 1}`} />)}
    </section>
  );
}

function Entries({ row: { title, entries } }: { row: TypesetConstraints['rows'][number] }) {
  const [open, setOpen] = useState(false);
  const book = useBook();
  const name = words.titles[title] ?? title;
  return (
    <details class="row-entries" onToggle={(event) => setOpen(event.currentTarget.open)}>
      <summary>{words.entries(name)}</summary>
      {open &&
        entries.map(({ column, latex, operations }) =>
          latex ? (
            <Formula key={column} latex={latex} title={`Ω, ${name} by ${inWords(book, column)}`} />
          ) : (
            <p key={column} class="hint">
              {equations.rowLeft(inWords(book, column), formatCount(operations!))}
            </p>
          ),
        )}
    </details>
  );
}
