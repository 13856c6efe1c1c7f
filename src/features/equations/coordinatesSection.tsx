import { coordinateUnit } from '../../core/model/units.ts';
import { TableScroll } from '../../ui/kit/tableScroll.tsx';
import type { CoordinateMeta } from '../../core/model/system.ts';
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
  const trajectory = useUi().app.state.motion.value?.trajectory;
  const time = useSlowTime();
  const of = (column: string) => (trajectory ? sample(trajectory, column, time) : null);
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
              <Row key={c.name} coordinate={c} value={of(c.name)} rate={of(`${c.name}_dot`)} />
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

function Row({ coordinate, value, rate }: { coordinate: CoordinateMeta; value: number | null; rate: number | null }) {
  const { name, label, kind, role } = coordinate;
  const unit = coordinateUnit(coordinate);
  const shown = (x: number | null) => (x === null ? '–' : formatValue(x, kind));
  return (
    <tr>
      <td>
        <Chip role={role} />
        <Letter mark={name} />
      </td>
      <th scope="row" class="words">
        {label}
      </th>
      <td class="number" data-testid={`equations-value-${name}`}>
        {shown(value)}
      </td>
      <td class="unit">{unit}</td>
      <td class="number">{shown(rate)}</td>
      <td class="unit">{unit}/s</td>
    </tr>
  );
}
