/** Eigenvalues against speed or any parameter: asked for, computed aside, drawn twice, listed, saved. */
import { useRef } from 'preact/hooks';
import type { Chart } from '../../charts/chart.ts';
import { symbolText, words as plain } from '../../core/motion/symbols.ts';
import { SaveMenu } from '../../ui/kit/saveMenu.tsx';
import { TableScroll } from '../../ui/kit/tableScroll.tsx';
import { useSignal } from '@preact/signals';
import type { Signal } from '@preact/signals';
import { useEffect } from 'preact/hooks';
import { locusCsv } from '../../core/control/design/exports.ts';
import type { LocusRequest, ScenarioLocus } from '../../core/control/locus/scenarioLocus.ts';
import type { ScenarioFile } from '../../core/scenario/types.ts';
import type { SystemView } from '../../core/model/system.ts';
import { useUi } from '../../ui/context.ts';
import { Check, Section } from '../../ui/kit/controls.tsx';
import { formatShort, THIN } from '../../ui/kit/format.ts';
import { words } from './words.ts';
import type { SaveText } from './gainSection.tsx';
import { LocusChart } from './locusChart.tsx';
import { LocusForm } from './locusForm.tsx';
import { LocusPlane } from './locusPlane.tsx';
import { eigenvalueText, signed } from './modes.ts';
import type { Column } from '../../core/motion/columns.ts';
import { analysedPart } from './names.ts';
import { bendOf, isWide } from './planeScale.ts';
import { parametersOf, subjectsOf, type LocusSubject } from './subjects.ts';

type Standing = { kind: 'idle' } | { kind: 'computing'; share: number } | { kind: 'failed'; message: string };

/** A locus with what it was asked for. */
interface Done {
  locus: ScenarioLocus;
  subject: LocusSubject;
  scenario: ScenarioFile;
}

export function LocusSection({
  names,
  system,
  save,
}: {
  names: ReadonlyMap<string, Column>;
  system: SystemView;
  save: SaveText;
}) {
  const ui = useUi();
  const { app } = ui;
  const standing = useSignal<Standing>({ kind: 'idle' });
  const done = useSignal<Done | null>(null);
  useEffect(() => () => app.locus.cancel(), []);
  const lqr = app.state.draft.value.control?.type === 'lqr';
  const closed = useSignal(false);
  const start = (subject: LocusSubject, range: Pick<LocusRequest, 'from' | 'to' | 'count'>) => {
    const scenario = analysedPart(app.state.draft.peek());
    standing.value = { kind: 'computing', share: 0 };
    const request = { vary: subject.vary, name: subject.name, ...range, closed: closed.peek() && lqr };
    void app.locus
      .start(scenario, request, (share) => {
        standing.value = { kind: 'computing', share };
      })
      .then((answer) => {
        if (answer === null) {
          if (standing.peek().kind === 'computing') standing.value = { kind: 'idle' };
        } else if (answer.ok) {
          standing.value = { kind: 'idle' };
          done.value = { locus: answer.value, subject, scenario };
        } else {
          standing.value = { kind: 'failed', message: answer.message };
        }
      });
  };
  const now = standing.value;
  return (
    <Section title={words.locus} open>
      <LocusForm
        key={system.meta.id}
        subjects={subjectsOf(system, names, words.speed)}
        parameters={parametersOf(ui.app.state.draft.value, system)}
        computing={now.kind === 'computing'}
        onStart={start}
        onCancel={() => app.locus.cancel()}
      >
        {lqr && (
          <Check
            label={words.keepGain}
            checked={closed.value}
            testId="locus-closed"
            onChange={(on) => {
              closed.value = on;
            }}
          />
        )}
      </LocusForm>
      <p class="locus-standing" role="status">
        {now.kind === 'computing' && (
          <>
            <progress value={now.share} max={1} aria-label={words.locus} />{' '}
            {words.computingShare(Math.round(100 * now.share))}
          </>
        )}
        {now.kind === 'failed' && (
          <span class="error" data-testid="locus-error">
            {now.message}
          </span>
        )}
      </p>
      {done.value && done.value.scenario.system === system.meta.id && (
        <Locus
          key={JSON.stringify(done.value.locus.request)}
          done={done.value}
          save={save}
          stale={JSON.stringify(done.value.scenario) !== JSON.stringify(analysedPart(app.state.draft.value))}
        />
      )}
    </Section>
  );
}

function Locus({ done: { locus, subject }, save, stale }: { done: Done; save: SaveText; stale: boolean }) {
  const index = useSignal(Math.floor(locus.values.length / 2));
  const sizes = locus.branches.flatMap((branch) => branch.map((e) => Math.hypot(...e)));
  const wide = isWide(sizes.filter((x) => x > 1e-3 * Math.max(...sizes)));
  const chart = useRef<Chart | null>(null);
  const symbol = symbolText(subject.symbol, subject.rate);
  const show = (value: number) =>
    `${formatShort(value * subject.factor, 5)}${subject.unit === '°' ? '' : THIN}${subject.unit}`;
  return (
    <div class="locus" data-testid="locus">
      {stale && <p class="hint">{words.stale}</p>}
      <p class="legend">
        <span>
          <svg width="18" height="8" aria-hidden="true">
            <line class="locus-swings" x1="0" x2="18" y1="4" y2="4" />
          </svg>{' '}
          {words.swings}
        </span>
        <span>
          <svg width="18" height="8" aria-hidden="true">
            <line class="locus-plain" x1="0" x2="18" y1="4" y2="4" />
          </svg>{' '}
          {words.doesNotSwing}
        </span>
        {locus.critical.length > 0 && (
          <span>
            <svg width="18" height="8" aria-hidden="true">
              <line class="locus-critical" x1="9" x2="9" y1="0" y2="8" />
            </svg>{' '}
            {words.critical}
          </span>
        )}
      </p>
      <LocusChart
        locus={locus}
        xTitle={subject.unit ? [...symbol, ...plain(`, ${subject.unit}`)] : symbol}
        onChart={(made) => {
          chart.current = made;
        }}
        yLabel={words.realPart}
        label={words.locusPlot(subject.label)}
        factor={subject.factor}
        bend={wide ? bendOf(locus.branches.flatMap((branch) => branch.map(([re]) => Math.abs(re)))) : undefined}
        onPoint={(at) => {
          if (at !== null) index.value = at;
        }}
      />
      <Walk locus={locus} index={index} label={subject.label} show={show} />
      <LocusPlane locus={locus} index={index} logarithmic={wide} label={words.locusPlane(subject.label)} />
      <Critical locus={locus} show={show} />
      {locus.skipped.length > 0 && (
        <p class="hint">
          {words.skipped(locus.skipped.length, show(locus.skipped[0]!.value), locus.skipped[0]!.reason)}
        </p>
      )}
      <div class="export-row">
        <button
          type="button"
          data-testid="locus-csv"
          onClick={() => save(`${subject.name}-locus.csv`, locusCsv(locus), 'text/csv')}
        >
          {words.locusCsv}
        </button>
        <span class="spring" />
        <SaveMenu title={words.locusPlot(subject.label)} picture={() => chart.current} testId="locus" />
      </div>
    </div>
  );
}

/** A slider along the locus: what the pointer does in the plot, for keys and fingers. */
function Walk({
  locus,
  index,
  label,
  show,
}: {
  locus: ScenarioLocus;
  index: Signal<number>;
  label: string;
  show(value: number): string;
}) {
  const i = Math.min(index.value, locus.values.length - 1);
  const spectrum = locus.branches.map((branch) => branch[i]!);
  const fastest = spectrum.reduce((best, e) => (e[0] > best[0] ? e : best));
  const value = show(locus.values[i]!);
  const said = words.fastest(eigenvalueText([fastest[0], Math.abs(fastest[1])]));
  return (
    <div class="walk">
      <input
        type="range"
        min={0}
        max={locus.values.length - 1}
        step={1}
        value={i}
        aria-label={label}
        aria-valuetext={`${value}: ${said}`}
        data-testid="locus-walk"
        onInput={(event) => {
          index.value = Number(event.currentTarget.value);
        }}
      />
      <output>{value}</output>
      <span class="hint">{said}</span>
    </div>
  );
}

function Critical({ locus: { critical }, show }: { locus: ScenarioLocus; show(value: number): string }) {
  if (critical.length === 0) return <p data-testid="locus-critical">{words.noCritical}</p>;
  return (
    <TableScroll label={words.critical}>
      <table data-testid="locus-critical">
        <caption>{words.critical}</caption>
        <thead>
          <tr>
            {words.criticalColumns.map((column) => (
              <th key={column} scope="col">
                {column}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {critical.map(({ value, eigenvalues, unstableBelow, unstableAbove }) => (
            <tr key={value}>
              <th scope="row" class="number">
                {show(Math.abs(value) < 1e-6 ? 0 : value)}
              </th>
              <td>
                {eigenvalues
                  .map((e) => (e[1] === 0 ? words.divergence : words.oscillation(formatShort(e[1] / (2 * Math.PI), 3))))
                  .join(', ')}
              </td>
              <td class="number">
                {unstableBelow} → {unstableAbove}
              </td>
              <td>
                {unstableAbove === 0
                  ? words.stableAbove
                  : unstableBelow === 0
                    ? words.stableBelow
                    : signed(unstableAbove - unstableBelow)}
              </td>
            </tr>
          ))}
        </tbody>
      </table>
    </TableScroll>
  );
}
