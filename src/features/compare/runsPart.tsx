import { useComputed } from '@preact/signals';
import { words } from './words.ts';
import { useUi } from '../../ui/context.ts';
import { Differences } from './differences.tsx';
import { PinnedList } from './pinnedList.tsx';
import { Overlay } from './overlay.tsx';
import { ScenarioTable } from './scenarioTable.tsx';
import { shownRuns } from './shownRuns.ts';

export function RunsPart() {
  const { app } = useUi();
  const runs = useComputed(() => shownRuns(app)).value;
  return (
    <>
      <PinnedList />
      {app.state.pinned.value.length === 0 && (
        <p class="hint" data-testid="compare-empty">
          {words.empty}
        </p>
      )}
      {runs.length > 0 && <Overlay runs={runs} />}
      {runs.length > 1 && <Differences runs={runs} />}
      {runs.length > 1 && <ScenarioTable runs={runs} />}
    </>
  );
}
