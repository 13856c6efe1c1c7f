/** Manoeuvres with pass or fail: one click, a report with pictures, and the tests themselves to change. */
import { useSignal } from '@preact/signals';
import { useEffect } from 'preact/hooks';
import { download } from '../../app/files/download.ts';
import type { VehicleTests } from '../../app/runs/vehicleTests.ts';
import { shippedTests } from '../../core/manoeuvres/shipped.ts';
import { parseTests, type CheckedTest } from '../../core/manoeuvres/testFile.ts';
import { useUi } from '../../ui/context.ts';
import { FileButton, textOfFile } from '../../ui/kit/fileButton.tsx';
import { text as uiText } from '../../ui/words.ts';
import { AddTest } from './addTest.tsx';
import { Results } from './results.tsx';
import { words } from './words.ts';
import { write, writtenFor } from './written.ts';
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
  useEffect(() => {
    void app.vehicleTests().then((found) => (runner.value = found));
  }, []);
  const vehicle = runner.value;
  if (!vehicle) return <p class="hint pad">{words.loading}</p>;
  // What a person wrote, else what comes with it.
  const own = writtenFor(system);
  const text = own ?? shippedText(system);
  const put = (next: string): void => write(system, next);
  const first = ui.system.value?.meta.coordinates[0]?.name ?? 't';
  const found = text.trim() === '' ? null : read(text);
  const computing = vehicle.state.value === 'computing';
  const start = () => {
    if (!found || !('tests' in found)) return;
    vehicle.start(app.state.draft.value, system, found.tests);
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
      <div class="row">
        <button
          type="button"
          data-testid="tests-run"
          disabled={!computing && !(found && 'tests' in found)}
          onClick={() => (computing ? vehicle.cancel() : start())}
        >
          {computing ? words.stop : words.run}
        </button>
        <FileButton
          label={words.open}
          accept=".json,application/json"
          testId="tests-open"
          onFile={(file) => void textOfFile(file).then(put)}
        />
        {text.trim() !== '' && (
          <button
            type="button"
            data-testid="tests-keep"
            onClick={() => download('tests.json', [text], 'application/json')}
          >
            {words.keep}
          </button>
        )}
        {own !== undefined && (
          <button type="button" data-testid="tests-shipped" onClick={() => write(system, undefined)}>
            {shippedTests(system) ? words.shipped : words.noneOwn}
          </button>
        )}
      </div>
      {vehicle.file && vehicle.system === system && <Results vehicle={vehicle} />}
      {!(found && 'problem' in found) && <AddTest text={text} example={`abs(${first})`} put={put} />}
      <details>
        <summary>{words.edit}</summary>
        <p class="hint">{words.editNote}</p>
        <textarea
          data-testid="tests-text"
          aria-label={words.edit}
          rows={14}
          spellcheck={false}
          value={text}
          onInput={(event) => put(event.currentTarget.value)}
        />
      </details>
    </div>
  );
}
