import { TableScroll } from '../../ui/kit/tableScroll.tsx';
import type { Motion } from '../../app/runs/motion.ts';
import type { InputMeta, SystemMeta } from '../../core/model/system.ts';
import { equations } from './words.ts';
import { useUi } from '../../ui/context.ts';
import { formatShort, THIN } from '../../ui/kit/format.ts';
import { sample, useSlowTime } from '../../ui/slowTime.ts';
import { MathSymbol } from '../../charts/textView.tsx';
import { useBook } from './context.ts';
import { Letter } from './formula.tsx';

const words = equations.inputs;

/** The named inputs and their columns of B, which the system's meta holds, and what they are now. */
export function InputsSection() {
  const { meta } = useBook().view;
  const { motion } = useUi().app.state;
  const time = useSlowTime();
  if (meta.order === 1) return <p class="hint">{words.none}</p>;
  return (
    <>
      <TableScroll label={equations.sections.inputs}>
        <table data-testid="equations-inputs">
          <thead>
            <tr>
              {words.columns.map((title) => (
                <th key={title} scope="col">
                  {title}
                </th>
              ))}
            </tr>
          </thead>
          <tbody>
            {meta.inputs.map((input) => (
              <Row key={input.name} input={input} meta={meta} value={valueOf(input, motion.value, time)} />
            ))}
          </tbody>
        </table>
      </TableScroll>
      <p class="hint">{words.raw}</p>
    </>
  );
}

function Row({
  input: { symbol, label, unit, column },
  meta,
  value,
}: {
  input: InputMeta;
  meta: SystemMeta;
  value: number | null;
}) {
  return (
    <tr>
      <td>
        <MathSymbol of={symbol} />
      </td>
      <th scope="row" class="words">
        {label}
      </th>
      <td class="column">
        {meta.coordinates
          .filter(({ name }) => column[name])
          .map(({ name }) => (
            <span key={name}>
              {formatShort(column[name]!)}
              {THIN}·{THIN}
              <Letter mark={`Q.${name}`} />
            </span>
          ))}
      </td>
      <td class="number">{value === null ? '–' : `${formatShort(value)}${THIN}${unit}`}</td>
    </tr>
  );
}

/** Null where the motion does not say; a run's input that its scenario does not use is zero. */
function valueOf({ name }: InputMeta, motion: Motion | null, time: number): number | null {
  if (!motion) return null;
  return motion.trajectory.has(name) ? sample(motion.trajectory, name, time) : motion.scenario ? 0 : null;
}
