/** Manoeuvres with pass or fail: one click, a report with pictures, and the tests themselves to change. */
import { useSignal } from '@preact/signals';
import { useEffect } from 'preact/hooks';
import { download } from '../../app/files/download.ts';
import type { VehicleTests } from '../../app/runs/vehicleTests.ts';
import { junitOf, outcomeOf, reportOf, type Outcome } from '../../core/manoeuvres/report.ts';
import { runsOf } from '../../core/manoeuvres/run.ts';
import { shippedTests } from '../../core/manoeuvres/shipped.ts';
import { parseTests, type CheckedTest } from '../../core/manoeuvres/testFile.ts';
import { useUi } from '../../ui/context.ts';
import { TableScroll } from '../../ui/kit/tableScroll.tsx';
import { text as uiText } from '../../ui/words.ts';
import { words } from './words.ts';
import './tests.css';

type Read = { tests: CheckedTest[] } | { problem: string };

function read(text: string): Read {
  try {
    return { tests: parseTests(text) };
  } catch (error) {
    return { problem: words.wrong((error as Error).message) };
  }
}

const shippedText = (system: string): string => {
  const shipped = shippedTests(system);
  return shipped ? JSON.stringify(shipped, null, 1) : '';
};

export function TestsTool() {
  const ui = useUi();
  const { app } = ui;
  const runner = useSignal<VehicleTests | null>(null);
  const system = ui.system.value?.meta.id ?? '';
  // By system: what a person wrote, else what comes with it.
  const written = useSignal<Record<string, string>>({});
  const tested = useSignal<{ tests: CheckedTest[]; system: string } | null>(null);
  useEffect(() => {
    void app.vehicleTests().then((found) => (runner.value = found));
  }, []);
  const vehicle = runner.value;
  if (!vehicle) return <p class="hint pad">{words.loading}</p>;
  const text = written.value[system] ?? shippedText(system);
  const found = text.trim() === '' ? null : read(text);
  const computing = vehicle.state.value === 'computing';
  const start = () => {
    if (!found || !('tests' in found)) return;
    const file = app.state.draft.value;
    const all = found.tests.map((test) => runsOf(test, file));
    tested.value = { tests: found.tests, system };
    vehicle.start(
      file,
      all.map((runs) => runs.length),
      all.flatMap((runs, place) =>
        runs.map(({ file: of, designedFor }) => ({ place, test: found.tests[place]!, file: of, designedFor })),
      ),
    );
  };
  return (
    <div class="scroll pad vehicle-tests" data-testid="tests-tool" data-state={vehicle.state.value}>
      <p>{words.about(ui.origin.value?.title ?? uiText.ownScenario)}</p>
      {!found && <p class="hint">{words.noTests}</p>}
      {found && 'problem' in found && (
        <p class="error" role="alert">
          {found.problem}
        </p>
      )}
      <div class="export-row">
        <button
          type="button"
          data-testid="tests-run"
          disabled={!computing && !(found && 'tests' in found)}
          onClick={() => (computing ? vehicle.cancel() : start())}
        >
          {computing ? words.stop : words.run}
        </button>
      </div>
      {tested.value && tested.value.system === system && <Results tests={tested.value.tests} vehicle={vehicle} />}
      <details>
        <summary>{words.edit}</summary>
        <p class="hint">{words.editNote}</p>
        <textarea
          data-testid="tests-text"
          aria-label={words.edit}
          rows={14}
          spellcheck={false}
          value={text}
          onInput={(event) => (written.value = { ...written.value, [system]: event.currentTarget.value })}
        />
        {written.value[system] !== undefined && (
          <button
            type="button"
            onClick={() => {
              const { [system]: _, ...rest } = written.value;
              written.value = rest;
            }}
          >
            {words.shipped}
          </button>
        )}
      </details>
    </div>
  );
}

function Results({ tests, vehicle }: { tests: readonly CheckedTest[]; vehicle: VehicleTests }) {
  const { app, system } = useUi();
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
  const report = reportOf(system.value!.meta.id, over);
  return (
    <section aria-label={words.results}>
      <p data-testid="tests-summary" aria-live="polite">
        {over.length === tests.length
          ? words.passed(report.passed, tests.length)
          : words.going(runs.filter(Boolean).length, runs.length)}
      </p>
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
        <div class="export-row" role="group" aria-label={words.save}>
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
