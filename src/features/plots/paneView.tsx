/** One plot: its curves, what they are at the present time, and how to change it. */
import { effect, useSignal } from '@preact/signals';
import { useEffect, useMemo, useRef } from 'preact/hooks';
import type { App } from '../../app/app.ts';
import type { Chart, TableColumn } from '../../charts/chart.ts';
import { ChartView } from '../../charts/chartView.tsx';
import { axisText, shownFactor, type Column } from '../../core/motion/columns.ts';
import { useUi } from '../../ui/context.ts';
import { Icon } from '../../ui/kit/controls.tsx';
import { formatShort } from '../../ui/kit/format.ts';
import { SaveMenu } from '../../ui/kit/saveMenu.tsx';
import { useSlowTime } from '../../ui/slowTime.ts';
import { dotsOf, infoIn, limits, nearestTime, pictureOf } from './drawing.ts';
import { Legend } from './legend.tsx';
import type { PaneProps } from './paneProps.ts';
import { saveCsv } from './save.ts';
import { text } from './words.ts';

/** Curves grow at most so often, ms. */
const REDRAW_MS = 100;
const TABLE_ROWS = 21;

export function PaneView(props: PaneProps) {
  const { pane, motion, choices, first, onChange, onUp } = props;
  // Built once: most of what is to be compared when a pane is drawn anew.
  const options = useMemo(() => <Options columns={choices} />, [choices]);
  const { app } = useUi();
  const infoOf = infoIn(motion);
  const latest = useRef(props);
  latest.current = props;
  const chart = useRef<Chart | null>(null);
  const redraw = useRef<() => void>(() => {});
  const tableOpen = useSignal(false);
  const info = pane.y.map(infoOf);
  const shown = info.filter((c) => !pane.hidden?.includes(c.name));
  const { degrees } = app.state.plots.value;
  const overTime = pane.x === 't';
  useEffect(() => redraw.current(), [pane, motion.id]);
  const names = shown.map((c) => c.label).join(', ');
  return (
    <section class="pane" aria-label={pane.title} data-testid="plot-pane">
      <div class="pane-head">
        <input
          class="pane-title"
          value={pane.title}
          aria-label={pane.title}
          onChange={(e) => onChange({ ...pane, title: e.currentTarget.value })}
        />
        <label class="pane-x">
          {text.over}{' '}
          <select
            value={pane.x}
            data-testid="plot-x"
            onChange={(e) => onChange({ ...pane, x: e.currentTarget.value, equal: false })}
          >
            {options}
          </select>
        </label>
        <SaveMenu
          title={pane.title}
          picture={() => chart.current}
          testId="plot"
          more={[{ id: 'csv', title: text.csv, testId: 'plot-csv', choose: () => saveCsv(latest.current) }]}
        />
        <button
          type="button"
          class="quiet square"
          aria-label={`${text.table}: ${pane.title}`}
          title={text.table}
          aria-expanded={tableOpen.value}
          data-testid="plot-table"
          onClick={() => {
            tableOpen.value = !tableOpen.value;
          }}
        >
          <Icon name="table" />
        </button>
        {!first && (
          <button
            type="button"
            class="quiet square"
            aria-label={text.up(pane.title)}
            title={text.up(pane.title)}
            onClick={onUp}
          >
            <Icon name="up" />
          </button>
        )}
        <button
          type="button"
          class="quiet square"
          aria-label={text.removePane(pane.title)}
          title={text.removePane(pane.title)}
          data-testid="plot-remove"
          onClick={() => onChange(null)}
        >
          <Icon name="close" />
        </button>
      </div>
      <ChartView
        key={overTime ? 'time' : 'phase'}
        class={pane.equal ? 'equal' : ''}
        testId="plot-canvas"
        label={text.pane(pane.title, names || text.noCurve, infoOf(pane.x).label)}
        table={tableOpen}
        values={() => tableOf(latest.current, app.state.plots.peek().degrees)}
        options={{
          alongX: overTime,
          onSeek: (x, y) =>
            app.actions.seek(overTime ? x : nearestTime(latest.current, app.state.plots.peek().degrees, x, y)),
          onZoom: ({ x }) => {
            if (overTime) latest.current.range.value = x;
          },
        }}
        attach={(made) => {
          chart.current = made;
          return drawn(app, made, latest, redraw);
        }}
      />
      <Legend info={info} {...props} degrees={degrees} />
      <label class="pane-add">
        <span class="hidden">{text.addCurve}</span>
        <select
          value=""
          data-testid="plot-add-curve"
          onChange={(e) => {
            if (e.currentTarget.value)
              onChange({ ...pane, y: [...pane.y.filter((n) => n !== e.currentTarget.value), e.currentTarget.value] });
          }}
        >
          <option value="">{text.addCurve}</option>
          {options}
        </select>
      </label>
      <Spent pane={pane} values={props.values} />
    </section>
  );
}

/** Draws when rows, curves, range, units or theme change, and marks the present. Returns how to end. */
function drawn(app: App, chart: Chart, latest: { current: PaneProps }, redraw: { current: () => void }): () => void {
  const { state } = app;
  let last = 0;
  let timer: ReturnType<typeof setTimeout> | undefined;
  const overTime = (): boolean => latest.current.pane.x === 't';
  const draw = (): void => {
    timer = undefined;
    last = performance.now();
    const { pane, values } = latest.current;
    chart.setPicture(pictureOf(latest.current, state.plots.peek().degrees));
    mark();
    if (pane.y.some((name) => values(name).behind) || (!overTime() && values(pane.x).behind)) soon();
  };
  const soon = (): void => void (timer ??= setTimeout(draw, Math.max(0, REDRAW_MS - (performance.now() - last))));
  const mark = (): void => {
    const time = state.time.peek();
    if (overTime()) chart.setCursor(time);
    else chart.setCursor(null, dotsOf(latest.current, state.plots.peek().degrees, time));
  };
  redraw.current = soon;
  const ends = [
    effect(() => {
      void state.rowsVersion.value;
      void state.plots.value;
      void state.theme.value;
      soon();
    }),
    effect(() => {
      const range = latest.current.range.value;
      if (overTime()) chart.setZoom({ x: range, y: null });
      else soon();
    }),
    state.readTime.subscribe(mark),
  ];
  return () => {
    clearTimeout(timer);
    for (const end of ends) end();
  };
}

/** The same in numbers, for those who read rather than see. */
function tableOf({ pane, motion, values, range }: PaneProps, degrees: boolean): TableColumn[] {
  const infoOf = infoIn(motion);
  const [from, to] = limits(motion, range.peek(), pane.to);
  const times = Array.from({ length: TABLE_ROWS }, (_, i) => from + ((to - from) * i) / (TABLE_ROWS - 1));
  const names = ['t', ...new Set([pane.x, ...pane.y])].filter((name, i) => i === 0 || name !== 't');
  return names
    .filter((name) => !pane.hidden?.includes(name))
    .map((name) => {
      const info = infoOf(name);
      const factor = shownFactor(info, degrees);
      return {
        title: axisText([info], degrees),
        values: name === 't' ? times : times.map((time) => values(name).at(time) * factor),
      };
    });
}

function Options({ columns }: { columns: readonly Column[] }) {
  const groups = [...new Set(columns.map((c) => c.group))];
  return (
    <>
      {groups.map((group) => (
        <optgroup key={group} label={text.groups[group]}>
          {columns
            .filter((c) => c.group === group)
            .map((c) => (
              <option key={c.name} value={c.name}>
                {c.label}
              </option>
            ))}
        </optgroup>
      ))}
    </>
  );
}

/** Under the plot of the power: the work so far. */
function Spent({ pane, values }: Pick<PaneProps, 'pane' | 'values'>) {
  const time = useSlowTime();
  if (!pane.y.includes('power')) return null;
  return (
    <p class="hint" data-testid="plot-spent">
      {text.spent(formatShort(values('work').at(time), 4))}
    </p>
  );
}
