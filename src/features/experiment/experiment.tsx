/** The experiment: what is run. Everything in it edits the draft. */
import { useEffect } from 'preact/hooks';
import { effect } from '@preact/signals';
import { goToField } from '../../ui/kit/goToField.ts';
import { useUi } from '../../ui/context.ts';
import { ControlSection, InputsSection } from './inputsSection.tsx';
import { MethodSection, TimeSection } from './methodSection.tsx';
import { ParametersSection } from './parametersSection.tsx';
import { RunBar } from './runBar.tsx';
import { StartSection } from './startSection.tsx';
import { SystemSection } from './systemSection.tsx';
import { words } from './words.ts';

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
        <SystemSection />
        <StartSection />
        <TimeSection />
        <ParametersSection />
        <MethodSection />
        <InputsSection />
        <ControlSection />
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
    <p class="apart" role="note" data-testid="file-apart">
      {words.onStage} <b>{motion.title}</b>. {words.apart}
    </p>
  );
}
