/** The regulator designed anew over the speed, or another number: how fast it falls, what gain and what haste it takes. */
import { useSignal } from '@preact/signals';
import { useEffect } from 'preact/hooks';
import { CURVES } from '../../app/runs/curveStyles.ts';
import { ChartView } from '../../charts/chartView.tsx';
import { curveMark } from '../../charts/curves.ts';
import type { Axis } from '../../charts/frame.ts';
import { stops } from '../../charts/marks.ts';
import { curvesCsv, type CurvePoint, type DesignCurves } from '../../core/control/locus/designCurves.ts';
import type { SystemView } from '../../core/model/system.ts';
import type { Column } from '../../core/motion/columns.ts';
import { symbolText, words as plain } from '../../core/motion/symbols.ts';
import type { ScenarioFile } from '../../core/scenario/types.ts';
import { useUi } from '../../ui/context.ts';
import { formatShort } from '../../ui/kit/format.ts';
import { TableScroll } from '../../ui/kit/tableScroll.tsx';
import type { SaveText } from './gainSection.tsx';
import { LocusForm, type Range } from './locusForm.tsx';
import { analysedPart } from './names.ts';
import { parametersOf, subjectsOf, type LocusSubject } from './subjects.ts';
import { words } from './words.ts';

const COUNT = 21;

type Standing = { kind: 'idle' } | { kind: 'computing'; share: number } | { kind: 'failed'; message: string };

/** Curves with what they were asked for. */
interface Done {
  curves: DesignCurves;
  subject: LocusSubject;
  scenario: ScenarioFile;
}

export interface CurvesProps {
  names: ReadonlyMap<string, Column>;
  system: SystemView;
  save: SaveText;
}

export function CurvesBody({ names, system, save }: CurvesProps) {
  const { app } = useUi();
  const standing = useSignal<Standing>({ kind: 'idle' });
  const done = useSignal<Done | null>(null);
  useEffect(() => () => app.locus.cancel(), []);
  const draft = app.state.draft.value;
  if (draft.control?.type !== 'lqr') return <p class="hint">{words.curvesNeedGain}</p>;
  const start = (subject: LocusSubject, range: Range) => {
    const scenario = analysedPart(app.state.draft.peek());
    standing.value = { kind: 'computing', share: 0 };
    void app.locus
      .curves(scenario, { vary: subject.vary, name: subject.name, ...range }, (share) => {
        standing.value = { kind: 'computing', share };
      })
      .then((answer) => {
        if (answer === null) {
          if (standing.peek().kind === 'computing') standing.value = { kind: 'idle' };
        } else if (answer.ok) {
          standing.value = { kind: 'idle' };
          done.value = { curves: answer.value, subject, scenario };
        } else standing.value = { kind: 'failed', message: answer.message };
      });
  };
  const now = standing.value;
  const shown = done.value;
  return (
    <div data-testid="curves">
      <p class="hint">{words.curvesNote}</p>
      <LocusForm
        key={system.meta.id}
        subjects={subjectsOf(system, names, words.speed)}
        parameters={parametersOf(draft, system)}
        computing={now.kind === 'computing'}
        onStart={start}
        onCancel={() => app.locus.cancel()}
        offered={COUNT}
        against={words.curvesAgainst}
        testId="curves"
      />
      <p class="locus-standing" role="status">
        {now.kind === 'computing' && (
          <>
            <progress value={now.share} max={1} aria-label={words.curves} />{' '}
            {words.computingShare(Math.round(100 * now.share))}
          </>
        )}
        {now.kind === 'failed' && <span class="error">{now.message}</span>}
      </p>
      {shown && JSON.stringify(shown.scenario.system) === JSON.stringify(draft.system) && (
        <Curves
          done={shown}
          save={save}
          stale={JSON.stringify(shown.scenario) !== JSON.stringify(analysedPart(draft))}
        />
      )}
    </div>
  );
}

type Pick = (point: CurvePoint) => number | null;

function Curves({ done: { curves, subject }, save, stale }: { done: Done; save: SaveText; stale: boolean }) {
  const { points, sample } = curves;
  const x = Float64Array.from(points, ({ value }) => value * subject.factor);
  const over: Axis = {
    title: [...symbolText(subject.symbol, subject.rate), ...plain(subject.unit && `, ${subject.unit}`)],
    air: 0,
  };
  const delays: [string, Pick][] = [[words.delayCurve, ({ delay }) => delay]];
  if (sample) delays.push([words.heldDelayCurve(formatShort(1000 * sample)), ({ heldDelay }) => heldDelay]);
  const refused = points.filter(({ problem }) => problem !== null);
  const number = (value: number | null, digits = 4): string => (value === null ? '–' : formatShort(value, digits));
  return (
    <div class="locus" data-testid="curves-found">
      {stale && <p class="hint">{words.stale}</p>}
      <Curve
        label={words.growthCurve}
        axis={words.growthColumn}
        x={x}
        over={over}
        points={points}
        curves={[[words.growthCurve, growthOf]]}
      />
      <Curve
        label={words.gainCurve}
        x={x}
        over={over}
        points={points}
        curves={[[words.gainCurve, ({ gain }) => gain]]}
        logarithmic
      />
      <Curve label={words.delayCurves} x={x} over={over} points={points} curves={delays} />
      <TableScroll label={words.curves}>
        <table data-testid="curves-table">
          <thead>
            <tr>
              <th scope="col">{subject.unit ? `${subject.label}, ${subject.unit}` : subject.label}</th>
              <th scope="col">{words.growthColumn}</th>
              <th scope="col">{words.gainColumn}</th>
              <th scope="col">{words.entryColumn}</th>
              {delays.map(([title]) => (
                <th key={title} scope="col">
                  {title}
                </th>
              ))}
            </tr>
          </thead>
          <tbody>
            {points.map((point) => (
              <tr key={point.value}>
                <th scope="row" class="number">
                  {number(point.value * subject.factor)}
                </th>
                <td class="number">{number(growthOf(point))}</td>
                <td class="number">{number(point.gain, 5)}</td>
                <td>{point.gainOf ? words.entry(point.gainOf.input, point.gainOf.state) : '–'}</td>
                {delays.map(([title, pick]) => (
                  <td key={title} class="number">
                    {number(pick(point))}
                  </td>
                ))}
              </tr>
            ))}
          </tbody>
        </table>
      </TableScroll>
      {refused.length > 0 && (
        <p class="hint">
          {words.noDesign(refused.length, number(refused[0]!.value * subject.factor), refused[0]!.problem!)}
        </p>
      )}
      <div class="export-row">
        <button
          type="button"
          data-testid="curves-csv"
          onClick={() => save(`${subject.name}-curves.csv`, curvesCsv(curves), 'text/csv')}
        >
          {words.curvesCsv}
        </button>
      </div>
    </div>
  );
}

const growthOf: Pick = ({ growth, growing, problem }) => (problem !== null && growing === 0 ? null : growth);

function Curve({
  label,
  axis = label,
  x,
  over,
  points,
  curves,
  logarithmic = false,
}: {
  label: string;
  axis?: string;
  x: Float64Array;
  over: Axis;
  points: readonly CurvePoint[];
  curves: readonly [string, Pick][];
  logarithmic?: boolean;
}) {
  const { app } = useUi();
  return (
    <ChartView
      class="response"
      label={label}
      options={{ alongX: true }}
      // The theme's colours are in force after the page's own effect: draw in the next frame.
      attach={(chart) => app.state.theme.subscribe(() => void requestAnimationFrame(() => chart.redraw()))}
      update={(chart) =>
        chart.setPicture({
          x: over,
          y: { title: plain(axis), ...(logarithmic ? { kind: 'logarithmic' as const } : { zero: true }) },
          marks: [
            ...curves.map(([title, pick], i) =>
              curveMark({
                ...CURVES[i]!,
                label: plain(title),
                x,
                rising: true,
                y: Float64Array.from(points, (point) => pick(point) ?? NaN),
              }),
            ),
            stops(x),
          ],
        })
      }
    />
  );
}
