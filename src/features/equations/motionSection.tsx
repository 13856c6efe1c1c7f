import { equations } from './words.ts';
import { formatCount } from '../../ui/kit/format.ts';
import { inWords, useBook } from './context.ts';
import { Formula } from './formula.tsx';

const { headings, sections } = equations;

/** One equation a coordinate where they are small; else what the matrices are made of, and the entries of M that can be read. */
export function MotionSection() {
  const { typeset, view } = useBook();
  return (
    <>
      {view.meta.order === 1 && <p class="hint">{equations.firstOrder}</p>}
      {typeset.motion.map((latex, i) => (
        <Formula key={i} latex={latex} title={`${sections.motion} ${i + 1}`} />
      ))}
      {typeset.structure.length > 0 && <Structure />}
      {typeset.losses.length > 0 && <h4>{headings.losses}</h4>}
      {typeset.losses.map((latex, i) => (
        <Formula key={i} latex={latex} title={`${headings.losses} ${i + 1}`} />
      ))}
      {typeset.mass && <MassEntries />}
      {typeset.forces && <ForceEntries />}
    </>
  );
}

function Structure() {
  const { structure, forces } = useBook().typeset;
  return (
    <>
      <h4>{headings.structure}</h4>
      {structure.map((latex, i) => (
        <Formula key={i} latex={latex} title={`${headings.structure} ${i + 1}`} />
      ))}
      {!forces && <p class="hint">{equations.structureNote}</p>}
    </>
  );
}

function ForceEntries() {
  const book = useBook();
  return (
    <>
      <h4>{headings.forces}</h4>
      {book.typeset.forces!.map(({ row, latex, operations }) =>
        latex ? (
          <Formula key={row} latex={latex} title={`h, ${inWords(book, row)}`} />
        ) : (
          <p key={row} class="hint">
            {equations.rowLeft(inWords(book, row), formatCount(operations!))}
          </p>
        ),
      )}
    </>
  );
}

function MassEntries() {
  const book = useBook();
  const { entries, left } = book.typeset.mass!;
  const counts = left.map(({ operations }) => operations);
  return (
    <>
      <h4>{headings.entries}</h4>
      {entries.map(({ row, column, latex }) => (
        <Formula
          key={`${row}.${column}`}
          latex={latex}
          title={`M, ${inWords(book, row)} by ${inWords(book, column)}`}
        />
      ))}
      {left.length > 0 && (
        <p class="hint" data-testid="equations-left">
          {equations.tooLong(left.length, formatCount(Math.min(...counts)), formatCount(Math.max(...counts)))}
        </p>
      )}
    </>
  );
}
