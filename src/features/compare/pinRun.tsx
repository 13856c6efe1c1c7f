/** In the status line: pins the run that has ended, or says that it is pinned. */
import { useCommand, useUi } from '../../ui/context.ts';
import { firstWords } from './firstWords.ts';

export function PinRun() {
  const { pinned } = useUi().app;
  const pin = useCommand('pin');
  return pinned.ofStage() ? (
    <span>{firstWords.pinned}</span>
  ) : (
    <button type="button" class="link" data-testid="status-keep" onClick={pin.perform}>
      {pin.label}
    </button>
  );
}
