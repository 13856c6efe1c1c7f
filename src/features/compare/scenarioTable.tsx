import { TableScroll } from '../../ui/kit/tableScroll.tsx';
import { useSignal } from '@preact/signals';
import { scenarioDifferences } from '../../core/scenario/scenarioDifference.ts';
import { words } from './words.ts';
import { Section } from '../../ui/kit/controls.tsx';
import type { ShownRun } from './shownRuns.ts';

/** What two runs were asked to do differently. */
export function ScenarioTable({ runs }: { runs: readonly ShownRun[] }) {
  const first = useSignal('');
  const second = useSignal('');
  const a = runs.find((r) => r.key === first.value) ?? runs[0]!;
  const b = runs.find((r) => r.key === second.value && r !== a) ?? runs.find((r) => r !== a)!;
  const select = (run: ShownRun, set: (key: string) => void, testId: string, not?: ShownRun) => (
    <select value={run.key} aria-label={words.first} data-testid={testId} onChange={(e) => set(e.currentTarget.value)}>
      {runs
        .filter((r) => r !== not)
        .map((r) => (
          <option key={r.key} value={r.key}>
            {r.name}
          </option>
        ))}
    </select>
  );
  const lines = differencesOf(a, b);
  return (
    <Section title={words.scenarios} open>
      {!lines && <p class="hint">{words.noScenario}</p>}
      {lines?.length === 0 && <p class="hint">{words.same}</p>}
      <TableScroll label={words.scenarios}>
        <table data-testid="scenario-table" class="scenario-table">
          <thead>
            <tr>
              <th scope="col">{words.key}</th>
              <th scope="col">
                {select(
                  a,
                  (key) => {
                    first.value = key;
                  },
                  'scenario-first',
                )}
              </th>
              <th scope="col">
                {select(
                  b,
                  (key) => {
                    second.value = key;
                  },
                  'scenario-second',
                  a,
                )}
              </th>
            </tr>
          </thead>
          <tbody>
            {lines?.map((line) => (
              <tr key={line.path} data-testid={`scenario-${line.path}`}>
                <th scope="row">{line.path}</th>
                <td>{told(line.first)}</td>
                <td>{told(line.second)}</td>
              </tr>
            ))}
          </tbody>
        </table>
      </TableScroll>
    </Section>
  );
}

const told = (value: string | null) =>
  value === null ? <span class="unit">{words.notNamed}</span> : value === '' ? '–' : value;

function differencesOf(a: ShownRun, b: ShownRun) {
  const [one, other] = [a.motion, b.motion];
  if (!one.scenario || !other.scenario) return null;
  return scenarioDifferences(
    { checked: one.scenario, written: one.written },
    { checked: other.scenario, written: other.written },
  );
}
