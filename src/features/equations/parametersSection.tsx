import { TableScroll } from '../../ui/kit/tableScroll.tsx';
import type { ParameterMeta } from '../../core/model/system.ts';
import { equations } from './words.ts';
import { useUi } from '../../ui/context.ts';
import { formatQuantity } from '../../ui/kit/format.ts';
import { useBook } from './context.ts';
import { Letter } from './formula.tsx';

const words = equations.parameters;

/** What each parameter is, what it is in the motion on the stage, and where its default comes from. */
export function ParametersSection() {
  const { meta } = useBook().view;
  const values = useUi().app.state.motion.value?.parameters;
  return (
    <TableScroll label={equations.sections.parameters}>
      <table data-testid="equations-parameters">
        <thead>
          <tr>
            <th scope="col">{words.symbol}</th>
            <th scope="col">{words.what}</th>
            <th scope="col" class="number">
              {words.now}
            </th>
            <th scope="col" class="number">
              {words.default}
            </th>
            <th scope="col">{words.source}</th>
          </tr>
        </thead>
        <tbody>
          {meta.parameters.map((p) => (
            <Row key={p.name} parameter={p} value={values?.[p.name] ?? p.default} />
          ))}
        </tbody>
      </table>
    </TableScroll>
  );
}

function Row({ parameter: p, value }: { parameter: ParameterMeta; value: number }) {
  const shown = (x: number) => formatQuantity(x, p.kind === 'angle' ? '°' : p.unit);
  const differs = Math.abs(value - p.default) > 1e-12 * Math.abs(p.default);
  return (
    <tr class={differs ? 'differs' : undefined}>
      <td>
        <Letter mark={p.name} />
      </td>
      <th scope="row" class="words">
        {p.label}
        {p.note && <small>{p.note}</small>}
      </th>
      <td class="number" title={differs ? words.differs : undefined}>
        {shown(value)}
      </td>
      <td class="number">{shown(p.default)}</td>
      <td class="words source">{p.source}</td>
    </tr>
  );
}
