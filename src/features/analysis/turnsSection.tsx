/** Steady turns over radius and speed: how fast each falls by itself, and what holds it. */
import { useSignal } from '@preact/signals';
import { useEffect } from 'preact/hooks';
import { ChartView } from '../../charts/chartView.tsx';
import { cells, scaleColour } from '../../charts/marks.ts';
import type { TurnMap, TurnOrders } from '../../core/control/path/turnMap.ts';
import { words as plain } from '../../core/motion/symbols.ts';
import type { InputMeta } from '../../core/model/system.ts';
import { useUi } from '../../ui/context.ts';
import { formatScientific, formatShort } from '../../ui/kit/format.ts';
import { words } from './words.ts';

const ASKER = 'turns';

export function TurnsBody() {
  const ui = useUi();
  const { app } = ui;
  const map = useSignal<TurnMap | null>(null);
  const problem = useSignal('');
  const computing = useSignal(false);
  const effort = useSignal(false);
  useEffect(() => () => app.control.forget(ASKER), []);
  const compute = async () => {
    computing.value = true;
    const found = await app.control.turns(app.state.draft.value, ASKER);
    if (!found) return;
    computing.value = false;
    problem.value = found.ok ? '' : found.message;
    if (found.ok) map.value = found.value;
  };
  const shown = map.value;
  const title = effort.value ? words.turnEffort : words.turnGrowth;
  return (
    <div data-testid="turns">
      <p class="hint">{words.turnsNote}</p>
      <button type="button" data-testid="turns-compute" disabled={computing.value} onClick={() => void compute()}>
        {computing.value ? words.turnsComputing : words.turnsCompute}
      </button>
      {problem.value && (
        <p class="error" role="alert">
          {problem.value}
        </p>
      )}
      {shown && (
        <>
          <label>
            {words.turnShow}{' '}
            <select
              value={effort.value ? 'effort' : 'growth'}
              onChange={(event) => (effort.value = event.currentTarget.value === 'effort')}
            >
              <option value="growth">{words.turnGrowth}</option>
              <option value="effort">{words.turnEffort}</option>
            </select>
          </label>
          <ChartView
            class="response tall"
            testId="turns-map"
            label={words.turnsMap(title)}
            options={{}}
            values={() => [
              { title: plain(words.turnRadius), values: shown.speeds.flatMap(() => [...shown.radii]) },
              { title: plain(words.turnSpeed), values: shown.speeds.flatMap((v) => shown.radii.map(() => v)) },
              { title: plain(title), values: valuesOf(shown, effort.value) },
            ]}
            attach={(chart) => app.state.theme.subscribe(() => void requestAnimationFrame(() => chart.redraw()))}
            update={(chart) => {
              const mark = cells(shown.radii.length, shown.speeds.length, valuesOf(shown, effort.value), null);
              chart.setPicture({
                x: {
                  title: plain(words.turnRadius),
                  kind: 'steps',
                  names: shown.radii.map(String),
                  air: 0,
                },
                y: {
                  title: plain(words.turnSpeed),
                  kind: 'steps',
                  names: shown.speeds.map(String),
                  air: 0,
                },
                marks: [mark],
                bar: { title: plain(title), low: mark.range[0], high: mark.range[1], colour: scaleColour },
              });
            }}
          />
          {shown.orders && (
            <p data-testid="turn-orders">{ordersLine(shown.orders, ui.system.value?.meta.inputs ?? [])}</p>
          )}
        </>
      )}
    </div>
  );
}

/** That the orders of linearizing and eliminating agree under the inputs that hold a turn, and what freezing does. */
function ordersLine(
  { radius, speed, u0, difference, frozenDifference }: TurnOrders,
  inputs: readonly InputMeta[],
): string {
  const held = Object.entries(u0).map(([name, value]) => {
    const input = inputs.find((i) => i.name === name);
    return `${input?.label ?? name} ${formatShort(value, 3)} ${input?.unit ?? ''}`.trim();
  });
  return words.turnOrders(
    formatShort(radius, 3),
    formatShort(speed, 3),
    held.join(', '),
    formatScientific(difference),
    formatShort(frozenDifference, 3),
  );
}

const valuesOf = ({ growth, effort }: TurnMap, efforts: boolean): number[] =>
  (efforts ? effort : growth).flat().map((x) => x ?? NaN);
