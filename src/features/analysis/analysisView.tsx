/** Linearization and control of the scenario in the panel, computed again whenever what it depends on changes. */
import { useComputed, useSignal, useSignalEffect } from '@preact/signals';
import type { ComponentChildren } from 'preact';
import { useEffect } from 'preact/hooks';
import type { ControlAnalysis } from '../../core/control/analysis.ts';
import type { ScenarioFile } from '../../core/scenario/types.ts';
import { useUi } from '../../ui/context.ts';
import { text } from '../../ui/words.ts';
import { words } from './words.ts';
import './analysis.css';
import { Eigenvalues } from './eigenvalues.tsx';
import { GainSection, type SaveText } from './gainSection.tsx';
import { LocusSection } from './locusSection.tsx';
import { analysedPart, statesOf } from './names.ts';
import { OrdersSection } from './ordersSection.tsx';
import { PointSection } from './pointSection.tsx';
import { later } from '../../ui/kit/later.tsx';
import { ReachSection } from './reachSection.tsx';

const ASKER = 'analysis';

/** Loaded and computed when its section is opened. */
const ResponsesBody = later(async () => (await import('./responsesSection.tsx')).ResponsesBody);
const TurnsBody = later(async () => (await import('./turnsSection.tsx')).TurnsBody);
const CurvesBody = later(async () => (await import('./curvesSection.tsx')).CurvesBody);

export interface AnalysisProps {
  save: SaveText;
}

export function AnalysisView({ save }: AnalysisProps) {
  const ui = useUi();
  const system = ui.system.value;
  const { analysis, problem, computing } = useAnalysis();
  if (!system) return null;
  const names = statesOf(system.meta);
  const current = analysis?.system === system.meta.id ? analysis : null;
  return (
    <div
      class="scroll analysis"
      aria-busy={computing}
      data-testid="analysis"
      data-state={computing ? 'computing' : problem ? 'refused' : 'ready'}
    >
      <p class="analysis-about">{words.about(ui.origin.value?.title ?? text.ownScenario)}</p>
      {problem && (
        <p class="error analysis-problem" role="alert" data-testid="analysis-problem">
          {problem}
          {current && ` ${words.lastGood}`}
        </p>
      )}
      <PointSection analysis={current} names={names} system={system} />
      <div class={problem ? 'analysis-stale' : undefined}>
        {current && (
          <>
            <Eigenvalues analysis={current} names={names} />
            <ReachSection analysis={current} names={names} meta={system.meta} />
            <OrdersSection analysis={current} />
            <GainSection analysis={current} names={names} meta={system.meta} save={save} />
          </>
        )}
      </div>
      <OpenedSection title={words.responses} testId="responses-section">
        <ResponsesBody names={names} />
      </OpenedSection>
      <OpenedSection title={words.curves} testId="curves-section">
        <CurvesBody names={names} system={system} save={save} />
      </OpenedSection>
      {(system.meta.forward ?? system.meta.speed) && (
        <OpenedSection title={words.turns} testId="turns-section">
          <TurnsBody />
        </OpenedSection>
      )}
      <LocusSection names={names} system={system} save={save} />
    </div>
  );
}

/** A section whose inside is made when it is opened. */
function OpenedSection({ title, testId, children }: { title: string; testId: string; children: ComponentChildren }) {
  const open = useSignal(false);
  return (
    <details class="section" data-testid={testId} onToggle={(event) => (open.value = event.currentTarget.open)}>
      <summary>
        <h3>{title}</h3>
      </summary>
      <div class="section-body">{open.value && children}</div>
    </details>
  );
}

/** The last analysis that could be had, and why there is no newer one. */
function useAnalysis(): { analysis: ControlAnalysis | null; problem: string; computing: boolean } {
  const { app } = useUi();
  const analysis = useSignal<ControlAnalysis | null>(null);
  const problem = useSignal('');
  const computing = useSignal(true);
  const asked = useComputed(() => JSON.stringify(analysedPart(app.state.draft.value)));
  useSignalEffect(() => {
    const file = JSON.parse(asked.value) as ScenarioFile;
    computing.value = true;
    void app.control.analyse(file, ASKER).then((answer) => {
      if (answer === null) return;
      computing.value = false;
      problem.value = answer.ok
        ? ''
        : answer.path && !answer.message.startsWith(answer.path)
          ? `${answer.path}: ${answer.message}`
          : answer.message;
      if (answer.ok) analysis.value = answer.value;
    });
  });
  useEffect(() => () => app.control.forget(ASKER), []);
  return { analysis: analysis.value, problem: problem.value, computing: computing.value };
}
