/** What is on the stage, in words: a case's own claim only while it is the case, unchanged. */
import { sameContent } from '../../app/state/draft.ts';
import { useUi } from '../context.ts';
import { later } from '../kit/later.tsx';
import { Slot } from '../slot.tsx';
import { text } from '../words.ts';

const Changes = later(async () => (await import('./changes.tsx')).Changes);

export function Caption() {
  const ui = useUi();
  const { state } = ui.app;
  const motion = state.motion.value;
  const origin = ui.origin.value;
  const asked = state.asked.value;
  const foreign = motion && motion.source !== 'run' ? motion.title : null;
  const changed = foreign === null && origin && asked !== null && !sameContent(asked, origin.scenario);
  const title = foreign ?? (changed ? text.changed(origin.title) : (origin?.title ?? ''));
  return (
    <div class="caption">
      <p class="caption-title">{title}</p>
      {foreign === null && origin && !changed && <p>{origin.summary}</p>}
      {changed && <Changes from={origin.scenario} to={asked} />}
      <Slot name="caption" />
      {motion === null && state.run.value === null && <p>{text.hint}</p>}
    </div>
  );
}
