import { useSignal, type Signal } from '@preact/signals';
import type { ComponentChildren } from 'preact';
import { useLayoutEffect, useRef } from 'preact/hooks';
import { plainText } from '../core/motion/symbols.ts';
import { Chart, type ChartOptions, type TableColumn } from './chart.ts';
import type { Frame } from './frame.ts';
import { tickText } from './scales.ts';
import { TextView } from './textView.tsx';
import { words } from './words.ts';

export interface ChartViewProps {
  /** What it shows, for those who do not see it. */
  label: string;
  testId?: string;
  class?: string;
  options: ChartOptions;
  /** Begins to draw into it; returns how to end. Called once. */
  attach(chart: Chart): () => void;
  /** Called with the chart after every change of the component. */
  update?(chart: Chart): void;
  /** What stands over the canvas. */
  children?(frame: Frame): ComponentChildren;
  /** Its numbers, where those of the curves do not say enough. */
  values?(): TableColumn[];
  /** Whether its table stands open; its own where it is not given. */
  table?: Signal<boolean>;
}

/** The host of a chart, with its keys and its table. */
export function ChartView(props: ChartViewProps) {
  const { label, testId, options } = props;
  const host = useRef<HTMLDivElement>(null);
  const chart = useRef<Chart | null>(null);
  const latest = useRef(props);
  latest.current = props;
  const own = useSignal(false);
  const open = props.table ?? own;
  const drawn = useSignal(0);
  const frame = useSignal<Frame | null>(null);
  // Made in the same commit as what stands around it, so that a drag begun on what is seen is not lost.
  useLayoutEffect(() => {
    const now = (): ChartOptions => latest.current.options;
    const made = (chart.current = new Chart(host.current!, {
      alongX: options.alongX ?? false,
      ...(options.onSeek ? { onSeek: (x, y) => now().onSeek?.(x, y) } : {}),
      ...(options.onHover ? { onHover: (index) => now().onHover?.(index) } : {}),
      ...(options.onPick ? { onPick: (index) => now().onPick?.(index) } : {}),
      onZoom: (zoom) => now().onZoom?.(zoom),
      onStep: (by, across) => now().onStep?.(by, across) ?? false,
      onTable: () => {
        open.value = !open.value;
      },
      onLayout: (laid) => {
        now().onLayout?.(laid);
        if (latest.current.children && !sameFrame(frame.peek(), laid)) frame.value = laid;
        if (open.peek()) drawn.value++;
      },
    }));
    const end = latest.current.attach(made);
    return () => {
      end();
      made.destroy();
      chart.current = null;
    };
  }, []);
  useLayoutEffect(() => {
    if (chart.current) latest.current.update?.(chart.current);
  });
  const { hint } = words;
  return (
    <>
      <div
        ref={host}
        class={`chart ${props.class ?? ''}`}
        tabIndex={0}
        role="application"
        data-testid={testId}
        aria-label={label}
        title={`${options.onPick ? hint.pick : options.onSeek ? hint.seek : hint.plain} ${hint.keys}`}
        onKeyDown={(event) => {
          if (event.ctrlKey || event.metaKey || event.altKey || !chart.current?.key(event.key)) return;
          event.preventDefault();
          event.stopPropagation();
        }}
      >
        {frame.value && props.children?.(frame.value)}
      </div>
      {open.value && (
        <Table columns={() => props.values?.() ?? chart.current?.table() ?? []} drawn={drawn} label={label} />
      )}
    </>
  );
}

/** What stands over the canvas is asked for again only where it would lie elsewhere. */
const sameFrame = (a: Frame | null, b: Frame): boolean =>
  a !== null &&
  a.left === b.left &&
  a.width === b.width &&
  a.height === b.height &&
  (['x', 'y'] as const).every((axis) =>
    [0, 1].every((share) => a[axis].value(share) === b[axis].value(share) && a[axis].share(0) === b[axis].share(0)),
  );

function Table({
  columns: columnsOf,
  drawn,
  label,
}: {
  columns(): TableColumn[];
  drawn: Signal<number>;
  label: string;
}) {
  void drawn.value;
  const columns = columnsOf();
  const rows = columns[0]?.values.length ?? 0;
  return (
    <div class="chart-table" tabIndex={0} role="region" aria-label={`${words.table}: ${label}`}>
      <table data-testid="chart-values">
        <thead>
          <tr>
            {columns.map(({ title }) => (
              <th key={plainText(title)} scope="col">
                <TextView of={title} />
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {Array.from({ length: rows }, (_, row) => (
            <tr key={row}>
              {columns.map(({ values }, c) => {
                const text = shown(values[row]!);
                return c === 0 ? (
                  <th key={c} scope="row">
                    {text}
                  </th>
                ) : (
                  <td key={c}>{text}</td>
                );
              })}
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}

const shown = (x: number): string => (Number.isFinite(x) ? tickText(Number(x.toPrecision(6))) : '–');
