/** What came of the tests: verdicts with their figures, pictures, and the report to save. */
import { useSignal } from '@preact/signals';
import { useEffect } from 'preact/hooks';
import { download } from '../../app/files/download.ts';
import type { VehicleTests } from '../../app/runs/vehicleTests.ts';
import { unstableLoop } from '../../core/control/sampled/unstableLoop.ts';
import { junitOf, outcomeOf, reportOf, type Outcome } from '../../core/manoeuvres/report.ts';
import type { ScenarioFile } from '../../core/scenario/types.ts';
import { useUi } from '../../ui/context.ts';
import { TableScroll } from '../../ui/kit/tableScroll.tsx';
import { words } from './words.ts';

/** What is to be said of the regulator of what was tested. */
function useNotes(file: ScenarioFile | null): readonly string[] {
  const { app } = useUi();
  const notes = useSignal<readonly string[]>([]);
  useEffect(() => {
    notes.value = [];
    const control = file?.control;
    if (!file || control?.type !== 'lqr') return;
    let wanted = true;
    void app.control.computer(file, 'tests').then((answer) => {
      const why = answer?.ok ? unstableLoop(control, answer.value.sampled) : null;
      if (wanted && why) notes.value = [why];
    });
    return () => {
      wanted = false;
    };
  }, [file]);
  return notes.value;
}

export function Results({ vehicle }: { vehicle: VehicleTests }) {
  const { app, system } = useUi();
  const { tests } = vehicle;
  // Read anew whenever an answer came.
  const seen = vehicle.version.value;
  const answers = seen >= 0 ? vehicle.answers : [];
  const outcomes = tests.map((test, i): Outcome | null => {
    const runs = answers[i] ?? [];
    if (runs.length === 0 || runs.some((run) => !run)) return null;
    return outcomeOf(
      test,
      runs.map((run) => run!.measured),
      runs.reduce((sum, run) => sum + run!.seconds, 0),
    );
  });
  const over = outcomes.filter((o) => o !== null);
  const runs = answers.flat();
  const notes = useNotes(vehicle.file);
  const report = reportOf(system.value!.meta.id, over, notes);
  return (
    <section aria-label={words.results}>
      <p data-testid="tests-summary" aria-live="polite">
        {over.length === tests.length
          ? words.passed(report.passed, tests.length)
          : (vehicle.state.value === 'cancelled' ? words.cancelled : words.going)(
              runs.filter(Boolean).length,
              runs.length,
            )}
      </p>
      {vehicle.state.value === 'computing' && (
        <progress max={runs.length} value={runs.filter(Boolean).length} aria-label={words.progress} />
      )}
      {notes.map((note) => (
        <p key={note} class="error" role="alert" data-testid="tests-note">
          {note}
        </p>
      ))}
      {vehicle.file !== app.state.draft.value && <p class="hint">{words.stale}</p>}
      <TableScroll label={words.results}>
        <table data-testid="tests-results">
          <thead>
            <tr>
              {words.columns.map((name, i) => (
                <th key={i} scope="col">
                  {name}
                </th>
              ))}
            </tr>
          </thead>
          <tbody>
            {tests.map((test, i) => (
              <tr key={i} data-passed={outcomes[i]?.passed}>
                <td class="verdict">{outcomes[i] ? (outcomes[i].passed ? words.pass : words.fail) : words.waiting}</td>
                <th scope="row">{test.name}</th>
                <td>{outcomes[i]?.message}</td>
                <td>
                  <PathPicture name={test.name} pictures={(answers[i] ?? []).map((run) => run?.picture ?? null)} />
                </td>
              </tr>
            ))}
          </tbody>
        </table>
      </TableScroll>
      {over.length > 0 && (
        <div class="row" role="group" aria-label={words.save}>
          <span>{words.save}</span>
          <button
            type="button"
            data-testid="tests-json"
            onClick={() => download('tests.json', [`${JSON.stringify(report, null, 2)}\n`], 'application/json')}
          >
            {words.formats.json}
          </button>
          <button
            type="button"
            data-testid="tests-junit"
            onClick={() => download('tests.xml', [junitOf(report)], 'application/xml')}
          >
            {words.formats.junit}
          </button>
        </div>
      )}
    </section>
  );
}

type Picture = { x: number[]; y: number[] } | null;

/** The paths of all runs over the ground, to one scale. */
function PathPicture({ name, pictures }: { name: string; pictures: readonly Picture[] }) {
  const drawn = pictures.filter((p) => p !== null);
  if (drawn.length === 0) return null;
  const xs = drawn.flatMap((p) => p.x).filter(Number.isFinite);
  const ys = drawn.flatMap((p) => p.y).filter(Number.isFinite);
  if (xs.length === 0) return null;
  const [left, right] = [xs.reduce((a, b) => Math.min(a, b)), xs.reduce((a, b) => Math.max(a, b))];
  const [low, high] = [ys.reduce((a, b) => Math.min(a, b)), ys.reduce((a, b) => Math.max(a, b))];
  const size = Math.max(right - left, (high - low) * 1.5, 0.5);
  const [midX, midY] = [(left + right) / 2, (low + high) / 2];
  return (
    <svg viewBox="-52 -35 104 70" role="img" aria-label={words.picture(name)}>
      {drawn.map((p, i) => (
        <polyline
          key={i}
          points={p.x.map((x, row) => `${((x - midX) / size) * 100},${(-(p.y[row]! - midY) / size) * 100}`).join(' ')}
        />
      ))}
    </svg>
  );
}
