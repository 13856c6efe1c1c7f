import { TableScroll } from '../../ui/kit/tableScroll.tsx';
import type { CoordinateMeta } from '../../core/model/system.ts';
import type { Motion } from '../../app/runs/motion.ts';
import { equations } from './words.ts';
import { useUi } from '../../ui/context.ts';
import { formatValue } from '../../ui/kit/format.ts';
import { sample, useSlowTime } from '../../ui/slowTime.ts';
import { Chip } from '../../ui/kit/chip.tsx';
import { useBook } from './context.ts';
import { Formula, Letter } from './formula.tsx';

const words = equations.coordinates;

export function CoordinatesSection() {
  const { view, typeset } = useBook();
  const { motion } = useUi().app.state;
  const time = useSlowTime();
  return (
    <>
      {/* scrolls by keys where it is wider than the tool */}
      <TableScroll label={equations.sections.coordinates}>
        <table data-testid="equations-coordinates">
          <thead>
            <tr>
              <th scope="col">{words.symbol}</th>
              <th scope="col">{words.what}</th>
              <th scope="col" class="number" colSpan={2}>
                {words.value}
              </th>
              <th scope="col" class="number" colSpan={2}>
                {words.rate}
              </th>
            </tr>
          </thead>
          <tbody>
            {view.meta.coordinates.map((c) => (
              <Row key={c.name} coordinate={c} motion={motion.value} time={time} />
            ))}
          </tbody>
        </table>
      </TableScroll>
      {typeset.letters.length > 0 && <h4>{equations.headings.letters}</h4>}
      {typeset.letters.map((latex, i) => (
        <Formula key={i} latex={latex} title={`${equations.headings.letters} ${i + 1}`} />
      ))}
    </>
  );
}

function Row({
  coordinate: { name, label, kind, role },
  motion,
  time,
}: {
  coordinate: CoordinateMeta;
  motion: Motion | null;
  time: number;
}) {
  const of = (column: string) => (motion ? sample(motion.trajectory, column, time) : null);
  const [value, rate] = [of(name), of(`${name}_dot`)];
  const unit = kind === 'angle' ? '°' : 'm';
  const shown = (x: number | null) => (x === null ? '–' : formatValue(x, kind));
  return (
    <tr>
      <th scope="row">
        <Chip role={role} />
        <Letter mark={name} />
      </th>
      <td class="words">{label}</td>
      <td class="number" data-testid={`equations-value-${name}`}>
        {shown(value)}
      </td>
      <td class="unit">{unit}</td>
      <td class="number">{shown(rate)}</td>
      <td class="unit">{unit}/s</td>
    </tr>
  );
}
