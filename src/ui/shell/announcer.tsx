/** Says run states and passed events to those who cannot see them. */
import { useSignal } from '@preact/signals';
import { useEffect } from 'preact/hooks';
import type { Ui } from '../context.ts';
import { useUi } from '../context.ts';
import { formatTime } from '../kit/format.ts';
import { text } from '../words.ts';

export function Announcer() {
  const ui = useUi();
  const said = useSignal('');
  useEffect(
    () =>
      announceRuns(ui, (what) => {
        said.value = what;
      }),
    [],
  );
  useEffect(
    () =>
      announceMarks(ui, (what) => {
        said.value = what;
      }),
    [],
  );
  return (
    <p class="hidden" aria-live="polite" data-testid="announcer">
      {said}
    </p>
  );
}

function announceRuns(ui: Ui, say: (what: string) => void): () => void {
  let before = '';
  return ui.app.state.run.subscribe((run) => {
    const now = !run
      ? ''
      : run.kind === 'computing'
        ? text.said.computing
        : text.said.ended(run.message || (text.status.reasons[run.reason] ?? run.reason), formatTime(run.time));
    if (now !== before) say(now);
    before = now;
  });
}

/** An event counts as passed when playback, not a jump, crosses it. */
function announceMarks(ui: Ui, say: (what: string) => void): () => void {
  const { state } = ui.app;
  let before = state.time.peek();
  return state.time.subscribe((time) => {
    const passed =
      state.playing.peek() && time > before
        ? state.motion.peek()?.marks.filter((m) => m.time > before && m.time <= time)
        : undefined;
    before = time;
    if (passed?.length) say(passed.map((m) => text.said.passed(m.name, formatTime(m.time))).join('; '));
  });
}
