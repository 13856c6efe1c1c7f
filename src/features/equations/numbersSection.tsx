/** M, h, B u and the constraint rows at the time on the stage, named by row and column. */
import { TableScroll } from '../../ui/kit/tableScroll.tsx';
import type { Motion } from '../../app/runs/motion.ts';
import { equations } from './words.ts';
import { formatScientific, formatShort } from '../../ui/kit/format.ts';
import { useBook } from './context.ts';
import { Letter } from './formula.tsx';
import { titleOfRow } from './meaning.ts';
import { constraintForce, type Present } from './present.ts';
import { usePresent } from './usePresent.ts';

const words = equations.table;
const DIGITS = 4;

export function NumbersSection() {
  const { view } = useBook();
  const shown = usePresent();
  if (!shown) return <p class="hint">{equations.noMotion}</p>;
  const { present, motion } = shown;
  if (view.meta.order === 1) return <Rate present={present} />;
  return (
    <>
      <MassTable present={present} hold={motion.scenario?.hold ?? []} />
      <VectorTable present={present} />
      <OmegaTable present={present} constraints={motion.constraints} />
      <p class="hint">{words.unitNote}</p>
    </>
  );
}

function Rate({ present }: { present: Present }) {
  const { view } = useBook();
  return (
    <dl class="energies">
      {view.meta.coordinates.map(({ name }, i) => (
        <div key={name}>
          <dt>
            <Letter mark={`${name}_dot`} />
          </dt>
          <dd>{formatShort(present.rate![i]!, 5)}</dd>
        </div>
      ))}
    </dl>
  );
}

/** A number of a matrix; a structural zero is quiet. */
function Entry({ value }: { value: number }) {
  const zero = Math.abs(value) < 1e-15;
  return <td class={zero ? 'number zero' : 'number'}>{zero ? '0' : shown(value)}</td>;
}

const shown = (x: number): string => (Math.abs(x) < 1e-4 ? formatScientific(x, 1) : formatShort(x, DIGITS));

function MassTable({ present: { n, mass, condition }, hold }: { present: Present; hold: readonly string[] }) {
  const { coordinates } = useBook().view.meta;
  return (
    <>
      <TableScroll label={words.mass} class="matrix">
        <table data-testid="equations-mass">
          <caption>{words.mass}</caption>
          <thead>
            <tr>
              <th scope="col">
                <span class="hidden">{words.row}</span>
              </th>
              {coordinates.map(({ name }) => (
                <th key={name} scope="col" class="number">
                  <Letter mark={name} said />
                </th>
              ))}
            </tr>
          </thead>
          <tbody>
            {coordinates.map(({ name }, i) => (
              <tr key={name}>
                <th scope="row">
                  <Letter mark={name} said />
                </th>
                {coordinates.map((c, j) => (
                  <Entry key={c.name} value={mass[i * n + j]!} />
                ))}
              </tr>
            ))}
          </tbody>
        </table>
      </TableScroll>
      <p class="hint" data-testid="equations-condition">
        {condition === null ? words.indefinite : words.condition(formatShort(condition, 3))}
      </p>
      {hold.length > 0 && <p class="hint">{words.held(hold.join(', '))}</p>}
    </>
  );
}

function VectorTable({ present }: { present: Present }) {
  const { coordinates } = useBook().view.meta;
  const constraint = constraintForce(present);
  return (
    <>
      <TableScroll label={words.vectors} class="matrix">
        <table data-testid="equations-vectors">
          <caption>{words.vectors}</caption>
          <thead>
            <tr>
              <th scope="col">
                <span class="hidden">{words.row}</span>
              </th>
              <th scope="col" class="number">
                {words.h}
              </th>
              <th scope="col" class="number">
                {words.inputs}
              </th>
              {present.m > 0 && (
                <th scope="col" class="number">
                  {words.constraint}
                </th>
              )}
              <th scope="col">{words.unit}</th>
            </tr>
          </thead>
          <tbody>
            {coordinates.map(({ name, kind }, i) => (
              <tr key={name}>
                <th scope="row">
                  <Letter mark={name} said />
                </th>
                <Entry value={present.h[i]!} />
                {present.inputs ? <Entry value={present.inputs[i]!} /> : <td class="number">–</td>}
                {present.m > 0 && (constraint ? <Entry value={constraint[i]!} /> : <td class="number">–</td>)}
                <td class="unit">{kind === 'angle' ? 'N·m' : 'N'}</td>
              </tr>
            ))}
          </tbody>
        </table>
      </TableScroll>
      {present.inputs === null && <p class="hint">{words.unknownInputs}</p>}
    </>
  );
}

function OmegaTable({
  present: { n, m, omega, lambda, slip, computed },
  constraints,
}: {
  present: Present;
  constraints: Motion['constraints'];
}) {
  const {
    typeset,
    view: {
      meta: { coordinates },
    },
  } = useBook();
  if (m === 0) return <p class="hint">{words.noConstraints}</p>;
  return (
    <>
      <TableScroll label={words.omega} class="matrix">
        <table data-testid="equations-omega">
          <caption>{words.omega}</caption>
          <thead>
            <tr>
              <th scope="col">{words.row}</th>
              {coordinates.map(({ name }) => (
                <th key={name} scope="col" class="number">
                  <Letter mark={name} said />
                </th>
              ))}
              <th scope="col" class="number">
                {words.lambda}
              </th>
              <th scope="col" class="number">
                {words.slip}
              </th>
            </tr>
          </thead>
          <tbody>
            {Array.from({ length: m }, (_, r) => (
              <tr key={r}>
                <th scope="row">{titleOfRow(typeset, constraints, r)}</th>
                {coordinates.map(({ name }, i) => (
                  <Entry key={name} value={omega[r * n + i]!} />
                ))}
                <td class="number" data-testid={`equations-lambda-${r + 1}`}>
                  {lambda ? shown(lambda[r]!) : '–'}
                </td>
                <td class="number">{formatScientific(slip[r]!, 0)}</td>
              </tr>
            ))}
          </tbody>
        </table>
      </TableScroll>
      {computed && <p class="hint">{words.computed}</p>}
    </>
  );
}
