/** One plot: its curves, what they are at the present time, and how to change it. */
import { effect, useSignal, type Signal } from '@preact/signals';
import { useEffect, useLayoutEffect, useMemo, useRef } from 'preact/hooks';
import type { App } from '../../app/app.ts';
import type { Motion } from '../../app/runs/motion.ts';
import type { PlotPane } from '../../app/state/plotPanes.ts';
import { createPanePlot, type PanePicture } from '../../charts/panePlot.ts';
import { text } from './words.ts';
import { useUi } from '../../ui/context.ts';
import { Icon } from '../../ui/kit/controls.tsx';
import { formatShort, formatTime } from '../../ui/kit/format.ts';
import { Menu } from '../../ui/kit/menu.tsx';
import { useSlowTime } from '../../ui/slowTime.ts';
import { columnOf, shownFactor, unitsOf, type Column } from '../../core/motion/columns.ts';
import type { ColumnValues } from '../../core/motion/columnValues.ts';
import { curvesOf, limits } from './drawing.ts';
import { attachPointers, onPaneKey } from './pointers.ts';
import { saveCsv, savePng, saveSvg } from './save.ts';
import { stylesOf } from './style.ts';

/** Curves grow at most so often, ms. */
const REDRAW_MS = 100;

export interface PaneProps {
  pane: PlotPane;
  motion: Motion;
  columns: readonly Column[];
  /** The columns again, for the long lists to choose from: they may come a little later. */
  choices: readonly Column[];
  values(name: string): ColumnValues;
  /** Of all plots over time; null for the whole. */
  range: Signal<readonly [number, number] | null>;
  first: boolean;
  onChange(pane: PlotPane | null): void;
  onUp(): void;
}

export function PaneView(props: PaneProps) {
  const { pane, motion, choices, first, onChange, onUp } = props;
  // Built once: most of what is to be compared when a pane is drawn anew.
  const options = useMemo(() => <Options columns={choices} />, [choices]);
  const { app } = useUi();
  const infoOf = infoIn(motion);
  const host = useRef<HTMLDivElement>(null);
  const latest = useRef(props);
  latest.current = props;
  const tableOpen = useSignal(false);
  const info = pane.y.map(infoOf);
  const shown = info.filter((c) => !pane.hidden?.includes(c.name));
  const { degrees } = app.state.plots.value;
  usePlot(app, host, latest);
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
        <Menu
          label={`${text.save}: ${pane.title}`}
          testId="plot-save"
          align="right"
          items={[
            { id: 'png', title: text.png, testId: 'plot-png', choose: () => savePng(host.current!, pane.title) },
            { id: 'svg', title: text.svg, testId: 'plot-svg', choose: () => saveSvg(latest.current, app, infoOf) },
            { id: 'csv', title: text.csv, testId: 'plot-csv', choose: () => saveCsv(latest.current) },
          ]}
        >
          <Icon name="export" />
        </Menu>
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
      <div
        ref={host}
        class={`pane-plot${pane.equal ? ' equal' : ''}`}
        tabIndex={0}
        role="img"
        data-testid="plot-canvas"
        aria-label={text.pane(pane.title, names || text.noCurve, infoOf(pane.x).label)}
        title={text.keysHint}
        onKeyDown={(event) => onPaneKey(event, app, latest.current)}
      />
      <Legend info={info} {...props} degrees={degrees} />
      {tableOpen.value && (
        <ValueTable info={[infoOf(pane.x), ...shown.filter((c) => c.name !== pane.x)]} {...props} degrees={degrees} />
      )}
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
      <Spent pane={pane} motion={motion} values={props.values} />
    </section>
  );
}

const infoIn =
  ({ system, constraints }: Motion) =>
  (name: string): Column =>
    columnOf(system.meta, name, constraints === null ? [] : system.contacts);

/** Makes the drawing once, in the same commit as the legend, so that a drag begun on what is seen is not lost; draws when motion, rows, range, units, curves or theme change. */
function usePlot(app: App, host: { current: HTMLDivElement | null }, latest: { current: PaneProps }): void {
  const redraw = useRef<() => void>(() => {});
  useLayoutEffect(() => {
    const { state } = app;
    const element = host.current!;
    const plot = createPanePlot(element);
    let last = 0;
    let timer: ReturnType<typeof setTimeout> | undefined;
    const draw = (): void => {
      timer = undefined;
      last = performance.now();
      plot.draw(pictureOf(latest.current, state.plots.peek().degrees, plot.width));
      mark();
      const { pane, values } = latest.current;
      if (pane.y.some((name) => values(name).behind) || (pane.x !== 't' && values(pane.x).behind)) soon();
    };
    const soon = (): void => void (timer ??= setTimeout(draw, Math.max(0, REDRAW_MS - (performance.now() - last))));
    const mark = (): void => {
      const { pane, motion, values } = latest.current;
      const time = state.time.peek();
      if (pane.x === 't') return plot.mark(time, []);
      const info = infoIn(motion);
      const value = (name: string): number =>
        values(name).at(time) * shownFactor(info(name), state.plots.peek().degrees);
      const styles = stylesOf(pane.y.map(info));
      plot.mark(
        null,
        pane.y.flatMap((name, i) =>
          pane.hidden?.includes(name) ? [] : [{ x: value(pane.x), y: value(name), color: styles[i]!.color }],
        ),
      );
    };
    redraw.current = soon;
    const ends = [
      effect(() => {
        void state.rowsVersion.value;
        void state.plots.value;
        void state.theme.value;
        void latest.current.range.value;
        soon();
      }),
      state.time.subscribe(mark),
      attachPointers(plot, app, latest),
    ];
    const observer = new ResizeObserver(() => {
      plot.resize(element.clientWidth, element.clientHeight);
      soon();
    });
    observer.observe(element);
    return () => {
      clearTimeout(timer);
      for (const end of ends) end();
      observer.disconnect();
      plot.destroy();
    };
  }, []);
  const { pane, motion } = latest.current;
  useEffect(() => redraw.current(), [pane, motion.id]);
}

function pictureOf(props: PaneProps, degrees: boolean, width: number): PanePicture {
  const { pane, motion } = props;
  const info = infoIn(motion);
  const x = info(pane.x);
  const y = pane.y.map(info);
  return {
    ...curvesOf(props, info, degrees, stylesOf(y), width),
    xLabel: pane.x === 't' ? 't, s' : [pane.x, unitsOf([x], degrees)].filter(Boolean).join(', '),
    yLabel: unitsOf(y, degrees),
    equal: pane.equal ?? false,
  };
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

function Legend({ info, degrees, ...props }: PaneProps & { info: readonly Column[]; degrees: boolean }) {
  const { pane, onChange } = props;
  const styles = stylesOf(info);
  const hidden = new Set(pane.hidden);
  const toggle = (name: string) =>
    onChange({ ...pane, hidden: hidden.has(name) ? [...hidden].filter((n) => n !== name) : [...hidden, name] });
  const isolate = (name: string) => onChange({ ...pane, hidden: pane.y.filter((n) => n !== name) });
  return (
    <ul class="pane-legend">
      {info.map((c, i) => {
        return (
          <li key={c.name} class={hidden.has(c.name) ? 'off' : undefined}>
            <button
              type="button"
              aria-pressed={!hidden.has(c.name)}
              aria-label={text.hide(c.label)}
              title={`${c.label}. ${text.isolateHint}`}
              data-testid={`legend-${c.name}`}
              onClick={() => toggle(c.name)}
              onDblClick={() => isolate(c.name)}
            >
              <svg width="20" height="8" aria-hidden="true">
                <line
                  x1="0"
                  y1="4"
                  x2="20"
                  y2="4"
                  stroke={styles[i]!.color}
                  stroke-width="2.5"
                  stroke-dasharray={styles[i]!.dash?.join(' ')}
                />
              </svg>
              <span>{c.name}</span> <LegendValue of={c} degrees={degrees} {...props} />{' '}
              <span class="unit">{unitsOf([c], degrees)}</span>
            </button>
            <button
              type="button"
              class="quiet square remove"
              aria-label={text.removeCurve(c.name)}
              title={text.removeCurve(c.name)}
              onClick={() => onChange({ ...pane, y: pane.y.filter((n) => n !== c.name) })}
            >
              <Icon name="close" />
            </button>
          </li>
        );
      })}
      {pane.exact && (
        <li>
          <svg width="20" height="8" aria-hidden="true">
            <line x1="0" y1="4" x2="20" y2="4" stroke="currentColor" stroke-width="1.5" stroke-dasharray="2 2" />
          </svg>{' '}
          <span>{pane.exact.label || text.exact}</span>
        </li>
      )}
    </ul>
  );
}

/** On its own: it follows the time, and the colours around it are not asked for again. */
function LegendValue({ of: c, motion, values, degrees }: PaneProps & { of: Column; degrees: boolean }) {
  const time = useSlowTime();
  return <span class="number">{formatShort(values(c.name).at(time) * shownFactor(c, degrees), 4)}</span>;
}

/** The same in numbers, for those who read rather than see. */
function ValueTable({
  info,
  pane,
  motion,
  values,
  range,
  degrees,
}: PaneProps & { info: readonly Column[]; degrees: boolean }) {
  const [from, to] = limits(motion, range.value, pane.to);
  const times = Array.from({ length: 21 }, (_, i) => from + ((to - from) * i) / 20);
  const list = pane.x === 't' ? info.slice(1) : info;
  return (
    <div class="pane-table">
      <table data-testid="plot-values">
        <caption class="hidden">{text.values(pane.title)}</caption>
        <thead>
          <tr>
            <th scope="col">t, s</th>
            {list.map((c) => (
              <th key={c.name} scope="col">
                {c.name} {unitsOf([c], degrees)}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {times.map((time) => (
            <tr key={time}>
              <th scope="row">{formatTime(time)}</th>
              {list.map((c) => (
                <td key={c.name}>{formatShort(values(c.name).at(time) * shownFactor(c, degrees), 6)}</td>
              ))}
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}

/** Under the plot of the power: the work so far. */
function Spent({ pane, motion, values }: Pick<PaneProps, 'pane' | 'motion' | 'values'>) {
  const time = useSlowTime();
  if (!pane.y.includes('power')) return null;
  return (
    <p class="hint" data-testid="plot-spent">
      {text.spent(formatShort(values('work').at(time), 4))}
    </p>
  );
}
