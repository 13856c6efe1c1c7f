/** Chosen columns of every visible run over one axis; the time cursor is the scene's. */
import { useSignal } from '@preact/signals';
import { useRef } from 'preact/hooks';
import { columnOf, groundCoordinates, spoken } from '../../core/motion/columns.ts';
import { words } from './words.ts';
import { Check, Icon, Section } from '../../ui/kit/controls.tsx';
import { useUi } from '../../ui/context.ts';
import { SaveMenu } from '../../ui/kit/saveMenu.tsx';
import type { Chart } from '../../charts/chart.ts';
import { CurvePane } from './curvePane.tsx';
import { Swatch } from './pinnedList.tsx';
import { columnsOf, type ShownRun } from './shownRuns.ts';

const MOST_PANES = 6;

export function Overlay({ runs }: { runs: readonly ShownRun[] }) {
  const { app } = useUi();
  const x = useSignal('t');
  const panes = useSignal<readonly { id: number; column: string }[]>([{ id: 0, column: '' }]);
  const zoom = useSignal<readonly [number, number] | null>(null);
  const { degrees } = app.state.plots.value;
  const charts = useRef(new Map<number, Chart>());
  const columns = columnsOf(runs);
  const meta = runs[0]!.motion.system.meta;
  const coordinate = meta.coordinates.find((c) => c.kind === 'angle') ?? meta.coordinates[0];
  // Data has no coordinates: its first column.
  const fallback = coordinate?.name ?? columns.find((c) => c !== 't') ?? 't';
  const known = (column: string, or: string): string => (columns.includes(column) ? column : or);
  const against = known(x.value, 't');
  const shown = runs.filter((run) => run.visible);
  const ground = groundCoordinates(meta);
  const infoOf = (name: string) =>
    columnOf(runs.find((run) => run.motion.trajectory.has(name))?.motion.system.meta ?? meta, name);
  const change = (id: number, column: string) => {
    panes.value = panes.value.map((pane) => (pane.id === id ? { ...pane, column } : pane));
  };
  return (
    <Section title={words.overlay} open>
      <div class="compare-row">
        <label>
          {words.against}{' '}
          <select
            value={against}
            data-testid="overlay-x"
            onChange={(e) => {
              x.value = e.currentTarget.value;
              zoom.value = null;
            }}
          >
            {columns.map((c) => (
              <option key={c} value={c}>
                {infoOf(c).label}
              </option>
            ))}
          </select>
        </label>
        {zoom.value && (
          <button
            type="button"
            class="link"
            data-testid="overlay-reset"
            onClick={() => {
              zoom.value = null;
            }}
          >
            {words.resetZoom}
          </button>
        )}
        <span class="spring" />
        <Check
          label={words.degrees}
          testId="overlay-degrees"
          checked={degrees}
          onChange={(on) => app.actions.set('plots', { ...app.state.plots.peek(), degrees: on })}
        />
        {panes.value.length < MOST_PANES && (
          <button
            type="button"
            data-testid="overlay-add"
            onClick={() => {
              const used = panes.value.map((pane) => known(pane.column, fallback));
              panes.value = [
                ...panes.value,
                {
                  id: Math.max(...panes.value.map((p) => p.id)) + 1,
                  column: columns.find((c) => c !== 't' && !used.includes(c)) ?? fallback,
                },
              ];
            }}
          >
            {words.addPane}
          </button>
        )}
      </div>
      <div>
        {panes.value.map(({ id, column }) => {
          const y = known(column, fallback);
          const [infoX, infoY] = [infoOf(against), infoOf(y)];
          return (
            <div key={id} class="overlay-pane">
              <div class="compare-row">
                <label>
                  {words.curve}{' '}
                  <select value={y} data-testid={`overlay-y-${id}`} onChange={(e) => change(id, e.currentTarget.value)}>
                    {columns
                      .filter((c) => c !== 't')
                      .map((c) => (
                        <option key={c} value={c}>
                          {infoOf(c).label}
                        </option>
                      ))}
                  </select>
                </label>
                <Legend runs={shown} />
                <span class="spring" />
                <SaveMenu
                  title={`${words.overlay}, ${infoY.label}`}
                  picture={() => charts.current.get(id)}
                  testId={`overlay-${id}`}
                />
                {panes.value.length > 1 && (
                  <button
                    type="button"
                    class="quiet square"
                    aria-label={words.removePane(infoY.label)}
                    title={words.removePane(infoY.label)}
                    onClick={() => {
                      panes.value = panes.value.filter((p) => p.id !== id);
                    }}
                  >
                    <Icon name="close" />
                  </button>
                )}
              </div>
              <CurvePane
                key={`${against}/${y}`}
                app={app}
                runs={shown}
                x={infoX}
                y={infoY}
                zoom={zoom}
                onChart={(chart) => (chart ? charts.current.set(id, chart) : charts.current.delete(id))}
                testId={`overlay-plot-${id}`}
                equal={ground.includes(against) && ground.includes(y)}
                label={words.plot(spoken(infoY, degrees), spoken(infoX, degrees), shown.length)}
              />
            </div>
          );
        })}
      </div>
    </Section>
  );
}

function Legend({ runs }: { runs: readonly ShownRun[] }) {
  return (
    <span class="legend">
      {runs.map((run) => (
        <span key={run.key} class="legend-entry" title={run.name}>
          <Swatch style={run.style} />
          <span>{run.name}</span>
        </span>
      ))}
    </span>
  );
}
