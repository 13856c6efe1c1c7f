/** The experiment: what is run. Everything in it edits the draft. */
import { useEffect } from 'preact/hooks';
import { effect } from '@preact/signals';
import { goToField } from '../../ui/kit/goToField.ts';
import { Term } from '../../ui/kit/term.tsx';
import { useUi } from '../../ui/context.ts';
import { later } from '../../ui/kit/later.tsx';
import { TimeSection } from './timeSection.tsx';
import { RunBar } from './runBar.tsx';
import { StartSection } from './startSection.tsx';
import { SystemSection } from './systemSection.tsx';
import { words } from './words.ts';

const LowerSections = later(async () => (await import('./lowerSections.tsx')).LowerSections);

export function Experiment() {
  const { state } = useUi().app;
  useEffect(
    () =>
      effect(() => {
        const wanted = state.wantedField.value;
        // After a panel that was folded has been drawn.
        if (wanted) setTimeout(() => goToField(wanted.path));
      }),
    [],
  );
  return (
    <div class="experiment" data-enter="run">
      <FileApart />
      <div class="scroll">
        <div class="sections">
          <SystemSection />
          <StartSection />
          <TimeSection />
          <LowerSections />
        </div>
      </div>
      <RunBar />
    </div>
  );
}

/** While a file is on the stage: it is not what stands below. */
function FileApart() {
  const motion = useUi().app.state.motion.value;
  if (motion?.source !== 'file') return null;
  return (
    <div class="apart" role="note" data-testid="file-apart">
      <p>
        {words.onThe} <Term id="stage">{words.stage}</Term> {words.isFile} <b>{motion.title}</b>.
      </p>
      <p>{words.apart}</p>
    </div>
  );
}
