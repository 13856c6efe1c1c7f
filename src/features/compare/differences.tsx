/** One run less another: every column's numbers, and the curve of one. */
import type { Chart } from '../../charts/chart.ts';
import { SaveMenu } from '../../ui/kit/saveMenu.tsx';
import { TableScroll } from '../../ui/kit/tableScroll.tsx';
import { useSignal } from '@preact/signals';
import { useEffect, useRef } from 'preact/hooks';
import { download } from '../../app/files/download.ts';
import { ChartView } from '../../charts/chartView.tsx';
import { curveMark } from '../../charts/curves.ts';
import { TextView } from '../../charts/textView.tsx';
import { token } from '../../charts/tokens.ts';
import {
  axisText,
  columnOf,
  shownFactor,
  shownUnit,
  spoken,
  symbolOf,
  type Column,
} from '../../core/motion/columns.ts';
import { symbolText, words as plain } from '../../core/motion/symbols.ts';
import { commonTimes, differenceOf, type Difference } from '../../core/motion/difference.ts';
import { words } from './words.ts';
import { Check, Section } from '../../ui/kit/controls.tsx';
import { useUi } from '../../ui/context.ts';
import { formatFixed, formatScientific, formatShort } from '../../ui/kit/format.ts';
import { csvText } from './csvText.ts';
import type { ShownRun } from './shownRuns.ts';

interface Line {
  info: Column;
  difference: Difference;
}

type Key = keyof typeof words.headings;

export function Differences({ runs }: { runs: readonly ShownRun[] }) {
  const first = useSignal('');
  const second = useSignal('');
  const turns = useSignal(true);
  const a = runs.find((r) => r.key === first.value) ?? runs[0]!;
  const b = runs.find((r) => r.key === second.value && r !== a) ?? runs.find((r) => r !== a)!;
  const choice = (value: ShownRun, set: (key: string) => void, label: string, testId: string, not?: ShownRun) => (
    <label>
      {label}{' '}
      <select value={value.key} data-testid={testId} onChange={(e) => set(e.currentTarget.value)}>
        {runs
          .filter((r) => r !== not)
          .map((r) => (
            <option key={r.key} value={r.key}>
              {r.name}
            </option>
          ))}
      </select>
    </label>
  );
  return (
    <Section title={words.differences} open>
      <div class="compare-row">
        {choice(
          a,
          (key) => {
            first.value = key;
          },
          words.first,
          'difference-first',
        )}
        {choice(
          b,
          (key) => {
            second.value = key;
          },
          words.reference,
          'difference-reference',
          a,
        )}
      </div>
      <Check
        label={words.wholeTurns}
        checked={turns.value}
        testId="difference-turns"
        onChange={(on) => {
          turns.value = on;
        }}
      />
      <Table a={a} b={b} turns={turns.value} />
    </Section>
  );
}

/** A column at a time, the page between: long runs take a while. Renewed when rows come, once they rest. */
function useLines(a: ShownRun, b: ShownRun, turns: boolean): readonly Line[] | null {
  const {
    app: { state },
  } = useUi();
  const lines = useSignal<readonly Line[] | null>(null);
  const version = a.motion === state.motion.value || b.motion === state.motion.value ? state.rowsVersion.value : 0;
  useEffect(() => {
    let ended = false;
    const [one, other] = [a.motion.trajectory, b.motion.trajectory];
    const names = one.columns.filter((name) => name !== 't' && other.has(name));
    const found: Line[] = [];
    let times: Float64Array | null = null;
    const step = (i: number): void => {
      if (ended) return;
      if (i === 0) times = commonTimes(one, other);
      const name = names[i];
      if (!times || name === undefined) {
        lines.value = found;
        return;
      }
      const info = columnOf(a.motion.system.meta, name);
      const difference = differenceOf(one, other, name, turns && info.turns ? 2 * Math.PI : 0, times);
      if (difference) found.push({ info, difference });
      setTimeout(() => step(i + 1));
    };
    const timer = setTimeout(() => step(0), version > 0 && lines.peek() ? 150 : 0);
    return () => {
      ended = true;
      clearTimeout(timer);
    };
  }, [a.motion.id, b.motion.id, turns, version]);
  return lines.value;
}

function Table({ a, b, turns }: { a: ShownRun; b: ShownRun; turns: boolean }) {
  const { degrees } = useUi().app.state.plots.value;
  const lines = useLines(a, b, turns);
  const sort = useSignal<{ key: Key; down: boolean }>({ key: 'name', down: false });
  const chosen = useSignal('');
  const chart = useRef<Chart | null>(null);
  if (!lines)
    return (
      <p class="hint" role="status">
        {words.working}
      </p>
    );
  if (lines.length === 0) return <p class="hint">{words.noCommon}</p>;
  const { times } = lines[0]!.difference;
  const drawn = lines.find((l) => l.info.name === chosen.value) ?? lines[0]!;
  const { key, down } = sort.value;
  const valueOf = ({ difference: d }: Line): number =>
    key === 'final' ? Math.abs(d.final) : key === 'name' ? 0 : d[key];
  // Numbers of different units are compared as they are recorded, SI.
  const sorted =
    key === 'name' && !down
      ? lines
      : [...lines].sort((p, q) =>
          key === 'name' ? lines.indexOf(q) - lines.indexOf(p) : (down ? -1 : 1) * (valueOf(p) - valueOf(q)),
        );
  const save = () =>
    download(
      'difference.csv',
      [
        csvText(
          ['column', 'rms', 'largest', 'largest_at_s', 'final'],
          sorted.map(({ info, difference: d }) => [info.name, d.rms, d.max, d.maxTime, d.final]),
        ),
      ],
      'text/csv',
    );
  return (
    <>
      <p class="hint">{words.overTime(formatFixed(times[0]!, 3), formatFixed(times[times.length - 1]!, 3))}</p>
      <DifferencePlot
        key={drawn.info.name}
        line={drawn}
        onChart={(made) => {
          chart.current = made;
        }}
      />
      <TableScroll label={words.differences}>
        <table data-testid="difference-table">
          <thead>
            <tr>
              {(Object.keys(words.headings) as Key[]).map((k) => (
                <th key={k} scope="col" aria-sort={k !== key ? 'none' : down ? 'descending' : 'ascending'}>
                  <button
                    type="button"
                    class="link sort"
                    data-testid={`difference-sort-${k}`}
                    onClick={() => {
                      sort.value = { key: k, down: k === key ? !down : k !== 'name' };
                    }}
                  >
                    {words.headings[k]}
                    <span aria-hidden="true">{k !== key ? '' : down ? ' ↓' : ' ↑'}</span>
                  </button>
                </th>
              ))}
            </tr>
          </thead>
          <tbody>
            {sorted.map(({ info, difference: d }) => (
              <tr
                key={info.name}
                data-testid={`difference-${info.name}`}
                class={drawn.info.name === info.name ? 'chosen' : ''}
              >
                <th scope="row">
                  <button
                    type="button"
                    class="link"
                    aria-pressed={drawn.info.name === info.name}
                    aria-label={words.showDifference(info.label)}
                    onClick={() => {
                      chosen.value = info.name;
                    }}
                  >
                    <TextView of={symbolOf(info)} />
                  </button>{' '}
                  <span class="unit">{shownUnit(info, degrees)}</span>
                </th>
                <td>{number(d.rms * shownFactor(info, degrees))}</td>
                <td>{number(d.max * shownFactor(info, degrees))}</td>
                <td>{formatFixed(d.maxTime, 3)}</td>
                <td>{number(d.final * shownFactor(info, degrees))}</td>
              </tr>
            ))}
          </tbody>
        </table>
      </TableScroll>
      <div class="compare-row">
        <span class="spring" />
        <button type="button" data-testid="difference-csv" onClick={save}>
          {words.tableCsv}
        </button>
        <SaveMenu title={words.differencePlot(drawn.info.label)} picture={() => chart.current} testId="difference" />
      </div>
    </>
  );
}

const number = (x: number): string =>
  x !== 0 && (Math.abs(x) < 1e-3 || Math.abs(x) >= 1e5) ? formatScientific(x, 2) : formatShort(x, 4);

function DifferencePlot({ line: { info, difference }, onChart }: { line: Line; onChart(chart: Chart | null): void }) {
  const { app } = useUi();
  const { degrees } = app.state.plots.value;
  // Drawn again in another theme's colours, which are in force after the page's own effect: in the next frame.
  void app.state.theme.value;
  const title = [...plain('Δ '), ...axisText([info], degrees)];
  return (
    <ChartView
      class="low"
      label={words.differencePlot(spoken(info, degrees))}
      testId="difference-plot"
      options={{ alongX: true, onSeek: (time) => app.actions.seek(time) }}
      attach={(chart) => {
        onChart(chart);
        const end = app.state.time.subscribe((time) => chart.setCursor(time));
        return () => {
          end();
          onChart(null);
        };
      }}
      update={(chart) =>
        void requestAnimationFrame(() =>
          chart.setPicture({
            x: { title: [...symbolText('t'), ...plain(', s')], air: 0 },
            y: { title, unit: shownUnit(info, degrees) },
            marks: [
              curveMark({
                label: title,
                color: token('--accent'),
                x: difference.times,
                y: difference.values,
                yFactor: shownFactor(info, degrees),
                rising: true,
              }),
            ],
          }),
        )
      }
    />
  );
}
