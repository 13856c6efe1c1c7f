import { TableScroll } from '../../ui/kit/tableScroll.tsx';
import { useSignal } from '@preact/signals';
import { useMemo } from 'preact/hooks';
import { download } from '../../app/files/download.ts';
import { runsOf, valuesAt, type SweepPlan, type SweepResult } from '../../app/runs/sweep.ts';
import { words } from './words.ts';
import { text } from '../../ui/words.ts';
import { useUi } from '../../ui/context.ts';
import { csvText } from './csvText.ts';
import { TextView } from '../../charts/textView.tsx';
import { measureText, titleOf, type AxisInfo, type MeasureInfo } from './sweepChoices.ts';

const own = words.sweep;
/** Rows on a page of the table: more would make every renewal felt. */
const PAGE = 50;

export function SweepTable({
  plan,
  axes,
  infos,
  onPick,
}: {
  plan: SweepPlan;
  axes: readonly AxisInfo[];
  infos: readonly MeasureInfo[];
  onPick(job: number): void;
}) {
  const {
    app: { sweep },
  } = useUi();
  const page = useSignal(0);
  void sweep.version.value;
  const total = runsOf(plan);
  const pages = Math.ceil(total / PAGE);
  const from = Math.min(page.value, pages - 1) * PAGE;
  const jobs = Array.from({ length: Math.min(PAGE, total - from) }, (_, i) => from + i);
  return (
    <>
      <TableScroll label={own.table}>
        <table data-testid="sweep-table">
          <thead>
            <tr>
              {plan.axes.map(({ path }, a) => (
                <th key={path} scope="col">
                  <TextView of={axes[a]!.title} />
                </th>
              ))}
              {infos.map((m) => (
                <th key={m.id} scope="col">
                  <TextView of={titleOf(m)} />
                </th>
              ))}
              <th scope="col">{own.ended}</th>
              <th scope="col">
                <span class="hidden">{own.pick}</span>
              </th>
            </tr>
          </thead>
          <tbody>
            {jobs.map((job) => (
              <Row
                key={job}
                plan={plan}
                axes={axes}
                job={job}
                result={sweep.results[job]}
                infos={infos}
                onPick={onPick}
              />
            ))}
          </tbody>
        </table>
      </TableScroll>
      <div class="compare-row">
        {pages > 1 && (
          <>
            <button
              type="button"
              disabled={from === 0}
              onClick={() => {
                page.value = from / PAGE - 1;
              }}
            >
              {own.before}
            </button>
            <span>{own.page(from + 1, from + jobs.length, total)}</span>
            <button
              type="button"
              disabled={from + PAGE >= total}
              onClick={() => {
                page.value = from / PAGE + 1;
              }}
            >
              {own.after}
            </button>
          </>
        )}
        <span class="spring" />
        <button
          type="button"
          data-testid="sweep-csv"
          onClick={() => download('sweep.csv', [sweepCsv(plan, sweep.results)], 'text/csv')}
        >
          {own.csv}
        </button>
      </div>
    </>
  );
}

/** One run; the same element as long as its result is, so that a renewal costs only what is new. */
function Row({
  plan,
  axes,
  job,
  result,
  infos,
  onPick,
}: {
  plan: SweepPlan;
  axes: readonly AxisInfo[];
  job: number;
  result: SweepResult | undefined;
  infos: readonly MeasureInfo[];
  onPick(job: number): void;
}) {
  return useMemo(
    () => (
      <tr data-testid={`sweep-row-${job}`}>
        {valuesAt(plan, job).map((v, a) => (
          <th key={a} scope={a === 0 ? 'row' : undefined}>
            {axes[a]!.text(v)}
          </th>
        ))}
        {infos.map((m, i) => (
          <td key={m.id}>{result ? measureText(result.values[i]! * m.factor) : '…'}</td>
        ))}
        <td class="why" title={result?.message}>
          {result
            ? result.reason === 'refused'
              ? own.refused
              : (text.status.reasons[result.reason] ?? result.reason)
            : ''}
        </td>
        <td>
          <button type="button" class="link" data-testid={`sweep-pick-${job}`} onClick={() => onPick(job)}>
            {own.pick}
          </button>
        </td>
      </tr>
    ),
    [plan, job, result, infos.map((m) => m.factor).join(), axes.map((a) => a.unit).join()],
  );
}

/** In SI units and radians, a row a run that is done. */
function sweepCsv(
  plan: SweepPlan,
  results: readonly ({ values: readonly number[]; reason: string } | undefined)[],
): string {
  const headings = [
    ...plan.axes.map((a) => a.path),
    ...plan.measures.map((m) => ('column' in m ? `${m.kind} ${m.column}` : m.kind)),
    'ended',
  ];
  const rows = [...results.entries()].flatMap(([job, result]) =>
    result
      ? [[...valuesAt(plan, job).map((v) => (v.method ? v.label : v.value)), ...result.values, result.reason]]
      : [],
  );
  return csvText(headings, rows);
}
