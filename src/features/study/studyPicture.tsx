import { useSignal } from '@preact/signals';
import { useLayoutEffect, useMemo, useRef } from 'preact/hooks';
import type { Chart } from '../../charts/chart.ts';
import { ChartView } from '../../charts/chartView.tsx';
import { differentValues } from '../../core/sweep/studyResults.ts';
import { useUi } from '../../ui/context.ts';
import { formatCount, THIN } from '../../ui/kit/format.ts';
import { SaveMenu } from '../../ui/kit/saveMenu.tsx';
import { drawingOf, type Drawing } from './picture.ts';
import { written, type Quantities, type Quantity } from './quantities.ts';
import { words } from './words.ts';

/** A list that a person chooses one of. */
const MOST_CHOICES = 200;

interface Props {
  title: string;
  quantities: Quantities;
  /** Names of the columns that are varied. */
  varied: readonly string[];
  /** Every row. */
  all: readonly number[];
  /** The rows that are shown. */
  onRows(rows: readonly number[]): void;
  /** Puts a row on the stage; null where that can't be. */
  onOpen: ((row: number) => void) | null;
}

const isNumber = ({ kinds }: Quantity): boolean => kinds === null;

/** What to begin with: the first two that are varied, coloured by how runs ended, or by what was measured where all ended alike. */
function beginning(quantities: Quantities, varied: readonly string[]): { x: string; y: string; colour: string } {
  const numbers = varied.filter((id) => isNumber(quantities.get(id)!));
  const measured = [...quantities.keys()].find(
    (id) => !varied.includes(id) && !['index', 'reason', 'time'].includes(id) && isNumber(quantities.get(id)!),
  );
  const ends = quantities.get('reason')!.kinds!.length > 1;
  const other = measured ?? 'time';
  return {
    x: numbers[0] ?? other,
    y: numbers[1] ?? (numbers[0] === undefined ? '' : other),
    colour: ends ? 'reason' : other,
  };
}

export function StudyPicture({ title, quantities, varied, all, onRows, onOpen }: Props) {
  const { app } = useUi();
  const first = useMemo(() => beginning(quantities, varied), []);
  const x = useSignal(first.x);
  const y = useSignal(first.y);
  const colour = useSignal(first.colour);
  const fixed = useSignal<Readonly<Record<string, string>>>({});
  const [ofX, ofY, ofColour] = [x, y, colour].map(({ value }) => quantities.get(value)) as [
    Quantity,
    Quantity?,
    Quantity?,
  ];
  const others = useMemo(() => fixable(quantities, varied, [x.value, y.value]), [quantities, x.value, y.value]);
  const rows = useMemo(() => rowsWith(all, others, fixed.value), [all, others, fixed.value]);
  const drawing = useMemo(() => drawingOf(ofX, ofY ?? null, ofColour ?? ofX, rows), [ofX, ofY, ofColour, rows]);
  useLayoutEffect(() => onRows(rows), [rows]);
  const numbers = [...quantities.values()].filter((q) => isNumber(q) && q.id !== 'index');
  return (
    <section class="pad">
      <div class="study-row">
        <Choice label={words.across} of={numbers} chosen={x} testId="study-x" />
        <Choice label={words.up} of={numbers} chosen={y} none={words.count} testId="study-y" />
        {ofY && <Choice label={words.colour} of={[...quantities.values()]} chosen={colour} testId="study-colour" />}
        {others.map(({ id, label, choices }) => (
          <label key={id}>
            {words.fixed(label)}{' '}
            <select
              value={fixed.value[id] ?? choices[0]!.value}
              data-testid={`study-fixed-${id}`}
              onChange={(e) => {
                fixed.value = { ...fixed.value, [id]: e.currentTarget.value };
              }}
            >
              {choices.map(({ value, name }) => (
                <option key={value} value={value}>
                  {name}
                </option>
              ))}
            </select>
          </label>
        ))}
      </div>
      <Picture
        key={`${drawing.kind} ${x.value} ${y.value} ${colour.value} ${String(app.state.theme.value)}`}
        {...{ title, quantities, varied, drawing, onOpen, x: ofX, y: ofY, colour: ofColour ?? ofX }}
      />
      {drawing.hidden > 0 && <p class="hint">{words.hidden(formatCount(drawing.hidden))}</p>}
      {drawing.left > 0 && <p class="hint">{words.left(formatCount(drawing.left))}</p>}
    </section>
  );
}

function Choice({
  label,
  of,
  chosen,
  none,
  testId,
}: {
  label: string;
  of: readonly Quantity[];
  chosen: { value: string };
  none?: string;
  testId: string;
}) {
  return (
    <label>
      {label}{' '}
      <select
        value={chosen.value}
        data-testid={testId}
        onChange={(e) => {
          chosen.value = e.currentTarget.value;
        }}
      >
        {none !== undefined && <option value="">{none}</option>}
        {of.map((q) => (
          <option key={q.id} value={q.id}>
            {q.unit === '' ? q.label : `${q.label}, ${q.unit}`}
          </option>
        ))}
      </select>
    </label>
  );
}

interface Fixable {
  id: string;
  label: string;
  /** `''` is any. */
  choices: readonly { value: string; name: string }[];
  holds(row: number, value: string): boolean;
}

/**
 * What is varied besides the axes and comes in few values. In a map of two varied quantities one of them is looked at, the
 * first to begin with; elsewhere all are.
 */
function fixable(quantities: Quantities, varied: readonly string[], axes: readonly string[]): Fixable[] {
  const any = { value: '', name: words.any };
  return varied
    .filter((id) => !axes.includes(id))
    .flatMap((id) => {
      const { values, kinds, factor, unit, label } = quantities.get(id)!;
      const different = kinds ?? differentValues(values as Float64Array, MOST_CHOICES)?.map(String);
      if (!different || different.length < 2) return [];
      const name = (value: string): string =>
        kinds ? value : `${written(Number(value) * factor)}${unit && THIN}${unit}`;
      const single = different.map((value) => ({ value, name: name(value) }));
      const choices = axes.every((axis) => varied.includes(axis)) ? [...single, any] : [any, ...single];
      return [{ id, label, choices, holds: (row: number, value: string) => String(values[row]) === value }];
    });
}

function rowsWith(
  all: readonly number[],
  others: readonly Fixable[],
  fixed: Readonly<Record<string, string>>,
): readonly number[] {
  return others.reduce((rows, { id, choices, holds }) => {
    const value = fixed[id] ?? choices[0]!.value;
    return value === '' ? rows : rows.filter((row) => holds(row, value));
  }, all);
}

interface PictureProps extends Pick<Props, 'title' | 'quantities' | 'varied' | 'onOpen'> {
  drawing: Drawing;
  x: Quantity;
  y: Quantity | undefined;
  colour: Quantity;
}

function Picture({ title, quantities, varied, drawing, onOpen, x, y, colour }: PictureProps) {
  const chart = useRef<Chart | null>(null);
  const at = useSignal<number | null>(null);
  const latest = useRef(drawing);
  if (latest.current !== drawing) {
    latest.current = drawing;
    at.value = null;
  }
  const draw = (): void => chart.current?.setPicture(latest.current.picture(at.peek()));
  const move = (next: number | null): void => {
    at.value = next;
    draw();
  };
  const open = (place: number): void => {
    const row = latest.current.rowAt(place);
    if (row !== null) onOpen?.(row);
  };
  const label = y ? words.map(colour.label, x.label, y.label) : words.histogram(x.label);
  return (
    <>
      <ChartView
        class="study-chart"
        label={label}
        testId="study-chart"
        options={{
          onHover: move,
          ...(onOpen && y ? { onPick: open } : {}),
          onStep: (by, across) => {
            if (by !== 0 || across !== 0) move(latest.current.beside(at.peek(), by, across));
            else if (at.peek() !== null) open(at.peek()!);
            return true;
          },
        }}
        attach={(made) => {
          chart.current = made;
          draw();
          return () => {
            chart.current = null;
          };
        }}
        update={draw}
      />
      <div class="study-row">
        <p class="hint study-read" role="status" data-testid="study-read">
          {at.value === null ? (y ? words.hint : words.hintBars) : sentence(drawing, at.value, quantities, varied)}
        </p>
        <SaveMenu title={`${title}, ${label}`} picture={() => chart.current} testId="study" />
      </div>
    </>
  );
}

function sentence(drawing: Drawing, at: number, quantities: Quantities, varied: readonly string[]): string {
  const row = drawing.rowAt(at);
  if (row === null) return drawing.describe(at);
  const ids = [...varied, ...[...quantities.keys()].filter((id) => id !== 'index' && !varied.includes(id))];
  return ids.map((id) => quantities.get(id)!.say(row)).join('; ');
}
