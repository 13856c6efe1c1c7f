/** Each column of the file: where it goes, and the unit of its numbers. */
import type { SystemMeta } from '../../core/model/system.ts';
import type { ColumnPlan, ImportPlan } from '../../csv/plan.ts';
import { useUi } from '../../ui/context.ts';
import { TableScroll } from '../../ui/kit/tableScroll.tsx';
import { missingOf, sentTo, targetsOf, unitsFor, type Target } from './choices.ts';
import { words } from './words.ts';

export function ColumnsTable({ plan, meta }: { plan: ImportPlan; meta: SystemMeta | null }) {
  const missing = missingOf(plan, meta);
  return (
    <>
      <TableScroll label={words.columnsTitle}>
        <table class="import-columns" data-testid="import-columns">
          <thead>
            <tr>
              <th scope="col">{words.inFile}</th>
              <th scope="col">{words.usedAs}</th>
              <th scope="col">{words.unit}</th>
            </tr>
          </thead>
          <tbody>
            {plan.columns.map((column) => (
              <Row key={column.index} column={column} meta={meta} />
            ))}
          </tbody>
        </table>
      </TableScroll>
      {missing.length > 0 && <p class="hint">{words.missing(missing.join(', '))}</p>}
    </>
  );
}

function Row({ column, meta }: { column: ColumnPlan; meta: SystemMeta | null }) {
  const { actions } = useUi().app;
  const { source, name, unit, role, unitFrom } = column;
  const units = unitsFor(column);
  return (
    <tr class={role === 'unused' ? 'unused' : undefined} data-testid={`import-column-${column.index}`}>
      <th scope="row">{source}</th>
      <td>
        {role === 'attitude' ? (
          words.attitude
        ) : (
          <Select
            label={words.usedAsOf(source)}
            value={name ?? ''}
            options={targetsOf(column, meta)}
            testId={`import-target-${column.index}`}
            onChange={(target) => actions.readAgain(sentTo(column, target))}
          />
        )}
      </td>
      <td>
        {role === 'unused' || units.length < 2 ? (
          unit
        ) : (
          <Select
            label={words.unitOf(source)}
            title={words.fromUnits[unitFrom]}
            value={unit}
            options={units}
            testId={`import-unit-${column.index}`}
            onChange={(next) => actions.readAgain(role === 'time' ? { timeUnit: next } : { units: { [source]: next } })}
          />
        )}
      </td>
    </tr>
  );
}

function Select({
  label,
  title,
  value,
  options,
  testId,
  onChange,
}: {
  label: string;
  title?: string;
  value: string;
  options: readonly Target[];
  testId: string;
  onChange(id: string): void;
}) {
  return (
    <select
      aria-label={label}
      title={title || undefined}
      value={value}
      data-testid={testId}
      onChange={(event) => onChange(event.currentTarget.value)}
    >
      {options.map((option) => (
        <option key={option.id} value={option.id}>
          {option.label}
        </option>
      ))}
    </select>
  );
}
