import { useSignal, type Signal } from '@preact/signals';
import { columnOf, groundCoordinates } from '../../core/motion/columns.ts';
import type { FactKind, SweepMeasure } from '../../core/motion/sweepMeasures.ts';
import type { SystemMeta } from '../../core/model/system.ts';
import { words } from './words.ts';
import { Icon } from '../../ui/kit/controls.tsx';
import { measureInfo } from './sweepChoices.ts';

const own = words.sweep;
const MOST_MEASURES = 8;
const OF_COLUMN = ['end', 'max', 'min'] as const;
type ColumnKind = (typeof OF_COLUMN)[number];

/** Which numbers are kept of each run. */
export function MeasureFields({
  measures,
  columns,
  meta,
}: {
  measures: Signal<readonly SweepMeasure[]>;
  columns: readonly string[];
  meta: SystemMeta;
}) {
  const kind = useSignal<SweepMeasure['kind']>('max');
  const column = useSignal(columns[0]!);
  const ofColumn = (k: SweepMeasure['kind']): k is ColumnKind => (OF_COLUMN as readonly string[]).includes(k);
  const facts = (Object.keys(own.units) as FactKind[]).filter(
    (k) =>
      (meta.order !== 1 || k === 'time' || k === 'steps' || k === 'seconds') &&
      (!/^(distance|costOfTransport)$/.test(k) || groundCoordinates(meta).length > 0),
  );
  const made: SweepMeasure = ofColumn(kind.value) ? { kind: kind.value, column: column.value } : { kind: kind.value };
  const there = measures.value.some((m) => measureInfo(m, meta, true).id === measureInfo(made, meta, true).id);
  return (
    <fieldset class="sweep-measures">
      <ul class="measure-list">
        {measures.value.map((m) => {
          const { id, label } = measureInfo(m, meta, true);
          return (
            <li key={id} class="measure" title={own.notes[m.kind]}>
              <span>{label}</span>
              <button
                type="button"
                class="quiet square small"
                aria-label={own.drop(label)}
                data-testid={`sweep-drop-${id}`}
                onClick={() => {
                  measures.value = measures.value.filter((other) => other !== m);
                }}
              >
                <Icon name="close" />
              </button>
            </li>
          );
        })}
      </ul>
      <div class="compare-row">
        <label>
          {own.measures}{' '}
          <select
            value={kind.value}
            data-testid="sweep-measure"
            onChange={(e) => {
              kind.value = e.currentTarget.value as SweepMeasure['kind'];
            }}
          >
            {[...OF_COLUMN, ...facts].map((k) => (
              <option key={k} value={k}>
                {own.kinds[k]}
                {ofColumn(k) ? ' …' : ''}
              </option>
            ))}
          </select>
        </label>
        {ofColumn(kind.value) && (
          <select
            value={column.value}
            aria-label={own.column}
            data-testid="sweep-measure-column"
            onChange={(e) => {
              column.value = e.currentTarget.value;
            }}
          >
            {columns.map((c) => (
              <option key={c} value={c}>
                {columnOf(meta, c).label}
              </option>
            ))}
          </select>
        )}
        <button
          type="button"
          data-testid="sweep-measure-add"
          disabled={there || measures.value.length >= MOST_MEASURES}
          onClick={() => {
            measures.value = [...measures.value, made];
          }}
        >
          {own.add}
        </button>
      </div>
    </fieldset>
  );
}
