import { useSignal } from '@preact/signals';
import { TextView } from '../../charts/textView.tsx';
import { download } from '../../app/files/download.ts';
import { formatCount } from '../../ui/kit/format.ts';
import { fileName } from '../../ui/kit/saveMenu.tsx';
import { TableScroll } from '../../ui/kit/tableScroll.tsx';
import type { Quantities, Quantity } from './quantities.ts';
import { words } from './words.ts';

const PAGE = 50;

/** Rows to a part of the file that is written, so that no text grows beyond what a page can hold. */
const PART = 10_000;

export function StudyTable({
  title,
  quantities,
  rows,
  onOpen,
}: {
  title: string;
  quantities: Quantities;
  rows: readonly number[];
  onOpen: ((row: number) => void) | null;
}) {
  const page = useSignal(0);
  const columns = [...quantities.values()];
  const from = PAGE * Math.min(page.value, Math.max(0, Math.ceil(rows.length / PAGE) - 1));
  const shown = rows.slice(from, from + PAGE);
  return (
    <section class="pad">
      <TableScroll label={words.table}>
        <table data-testid="study-table">
          <thead>
            <tr>
              {columns.map(({ id, title: heading }) => (
                <th key={id} scope="col">
                  <TextView of={heading} />
                </th>
              ))}
              {onOpen && (
                <th scope="col">
                  <span class="hidden">{words.pick}</span>
                </th>
              )}
            </tr>
          </thead>
          <tbody>
            {shown.map((row) => (
              <tr key={row}>
                {columns.map(({ id, cell }, c) =>
                  c === 0 ? (
                    <th key={id} scope="row">
                      {cell(row)}
                    </th>
                  ) : (
                    <td key={id}>{cell(row)}</td>
                  ),
                )}
                {onOpen && (
                  <td>
                    <button type="button" class="link" data-testid={`study-open-${row}`} onClick={() => onOpen(row)}>
                      {words.pick}
                    </button>
                  </td>
                )}
              </tr>
            ))}
          </tbody>
        </table>
      </TableScroll>
      <div class="study-row">
        {rows.length > PAGE && (
          <>
            <button type="button" disabled={from === 0} onClick={() => (page.value = from / PAGE - 1)}>
              {words.before}
            </button>
            <span>{words.page(formatCount(from + 1), formatCount(from + shown.length), formatCount(rows.length))}</span>
            <button type="button" disabled={from + PAGE >= rows.length} onClick={() => (page.value = from / PAGE + 1)}>
              {words.after}
            </button>
          </>
        )}
        <span class="spring" />
        <button
          type="button"
          data-testid="study-csv"
          onClick={() => download(`${fileName(title)}.csv`, csvOf(columns, rows), 'text/csv')}
        >
          {words.csv}
        </button>
      </div>
    </section>
  );
}

/** In SI units and radians, as the command line writes them. */
function csvOf(columns: readonly Quantity[], rows: readonly number[]): string[] {
  const cell = (value: number | string): string => {
    if (typeof value === 'number') return Number.isNaN(value) ? '' : Object.is(value, -0) ? '-0' : String(value);
    return /[",\n\r]/.test(value) ? `"${value.replaceAll('"', '""')}"` : value;
  };
  const parts = [`${columns.map(({ id }) => cell(id)).join(',')}\n`];
  for (let from = 0; from < rows.length; from += PART)
    parts.push(
      rows
        .slice(from, from + PART)
        .map((row) => `${columns.map(({ values }) => cell(values[row]!)).join(',')}\n`)
        .join(''),
    );
  return parts;
}
