/** The state at the playback time, in numbers. Follows at most 15 times a second. */
import { perSecond } from '../../core/model/units.ts';
import type { Motion } from '../../app/runs/motion.ts';
import type { ColourRole } from '../../core/model/system.ts';
import { columnOf, columnsOf, shownFactor, shownUnit, sumsOf, type Column } from '../../core/motion/columns.ts';
import { DATA } from '../../core/motion/dataView.ts';
import { valuesOf } from '../../core/motion/columnValues.ts';
import { useUi } from '../../ui/context.ts';
import { Slot } from '../../ui/slot.tsx';
import { sample, useSlowTime } from '../../ui/slowTime.ts';
import { formatFixed, formatShort, formatTime, formatValue, THIN } from '../../ui/kit/format.ts';
import { Chip } from '../../ui/kit/chip.tsx';
import { Term } from '../../ui/kit/term.tsx';
import { MathSymbol } from '../../charts/textView.tsx';
import { words } from './words.ts';

/** Rows drawn fifteen times a second; a logger may have hundreds. */
const MOST_DATA = 60;

/** With what the features have to say of what is on the stage. */
export function NowTool() {
  return (
    <div class="scroll" tabIndex={0} role="region" aria-label={words.title}>
      <NowPanel />
      <Slot name="notes" />
    </div>
  );
}

export function NowPanel() {
  const { state } = useUi().app;
  const time = useSlowTime();
  const motion = state.motion.value;
  if (!motion || motion.trajectory.length === 0) return <p class="hint pad">{words.empty}</p>;
  if (motion.system.meta.id === DATA) return dataNow(motion, time);
  // Rows are given numbers: Preact keeps what was drawn before, and with it what that was given.
  const at = (column: string): number | null => {
    const value = valuesOf(motion, column).at(time);
    return Number.isFinite(value) ? value : null;
  };
  const multipliers = motion.trajectory.columns.filter((name) => name.startsWith('lambda_'));
  return (
    <div class="now">
      <table data-testid="now">
        <caption>
          t = {formatTime(time)}
          {THIN}s
        </caption>
        <thead>
          <tr>
            <th scope="col">
              <span class="hidden">{words.title}</span>
            </th>
            <th scope="col" colSpan={2}>
              {words.value}
            </th>
            <th scope="col" colSpan={2}>
              {words.rate}
            </th>
          </tr>
        </thead>
        <tbody>
          {rowsOf(motion).map((name) => (
            <Row key={name} column={columnOf(motion.system.meta, name)} value={at(name)} rate={at(`${name}_dot`)} />
          ))}
        </tbody>
      </table>
      {multipliers.length > 0 && (
        <Multipliers
          contacts={motion.system.contacts}
          values={multipliers.map((name) => [name, sample(motion.trajectory, name, time)])}
        />
      )}
    </div>
  );
}

/** Data: every column and its unit. */
function dataNow({ system, trajectory }: Motion, time: number) {
  const columns = columnsOf(system, trajectory.columns).filter(({ name }) => name !== 't');
  return (
    <div class="now">
      <table data-testid="now">
        <caption>
          t = {formatTime(time)}
          {THIN}s
        </caption>
        <tbody>
          {columns.slice(0, MOST_DATA).map((column) => {
            const value = sample(trajectory, column.name, time);
            return (
              <tr key={column.name}>
                <th scope="row">{column.label}</th>
                <td class="number" data-testid={`now-${column.name}`}>
                  {value === null ? '–' : formatShort(value * shownFactor(column, true), 5)}
                </td>
                <td class="unit">{shownUnit(column, true)}</td>
              </tr>
            );
          })}
        </tbody>
      </table>
      {columns.length > MOST_DATA && <p class="hint">{words.moreColumns(columns.length - MOST_DATA)}</p>}
    </div>
  );
}

/** Coordinates, then what is a sum of them (the plates' own rolls). */
function rowsOf({ system: { meta }, trajectory }: Motion): string[] {
  const sums = sumsOf(meta, (name) => trajectory.has(name)).filter((name) => !columnOf(meta, name).rate);
  return [...meta.coordinates.map(({ name }) => name), ...sums];
}

function Row({ column: c, value, rate }: { column: Column; value: number | null; rate: number | null }) {
  const kind = c.degrees ? 'angle' : 'length';
  return (
    <tr>
      <th scope="row" title={c.label}>
        <Chip role={c.role ?? 'neutral'} />
        <MathSymbol of={c.symbol} />
        <span class="hidden">{c.label}</span>
      </th>
      <td class="number" data-testid={`now-${c.name}`}>
        {value === null ? '–' : formatValue(value, kind)}
      </td>
      <td class="unit">{shownUnit(c, true)}</td>
      <td class="number">{rate === null ? '–' : formatValue(rate, kind)}</td>
      <td class="unit">{rate === null ? '' : perSecond(shownUnit(c, true))}</td>
    </tr>
  );
}

function Multipliers({
  contacts,
  values,
}: {
  contacts: Motion['system']['contacts'];
  values: readonly (readonly [string, number | null])[];
}) {
  const forces = new Map<number, { role: ColourRole; label: string }>();
  for (const { role, label, lateral, vertical } of contacts) {
    forces.set(lateral, { role, label: `${label}, ${words.lateral}` });
    forces.set(vertical, { role, label: `${label}, ${words.vertical}` });
  }
  return (
    <table data-testid="now-multipliers">
      <caption>
        <Term id="multiplier">{words.multipliers}</Term>
      </caption>
      <tbody>
        {values.map(([name, value], i) => {
          const force = forces.get(i);
          return (
            <tr key={name}>
              <th scope="row">
                <Chip role={force?.role ?? 'neutral'} />
                <MathSymbol of={name.replace('lambda', 'λ')} /> <span class="name">{force?.label ?? ''}</span>
              </th>
              <td class="number" data-testid={`now-${name}`}>
                {value === null ? '–' : formatFixed(value, 3)}
              </td>
              <td class="unit">{force ? 'N' : ''}</td>
            </tr>
          );
        })}
      </tbody>
    </table>
  );
}
