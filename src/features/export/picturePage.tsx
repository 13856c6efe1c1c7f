import { sizeInWords } from '../../app/files/exportPlan.ts';
import type { ExportRenderer } from '../../app/files/exportRenderer.ts';
import type { Motion } from '../../app/runs/motion.ts';
import { words as text } from './words.ts';
import { useUi } from '../../ui/context.ts';
import { Check, Choice } from '../../ui/kit/controls.tsx';
import { SizeFields, ViewField } from './fields.tsx';
import { choices, job, picturePlan, savePicture } from './jobs.ts';
import { Preview } from './preview.tsx';

/** Saves, or says why it can't. */
export function SaveButton({ testId, reason }: { testId: string; reason: string | null }) {
  const why = job.value ? text.busy : reason;
  return (
    <div class="dialog-buttons">
      <button type="submit" class="primary" data-testid={testId} disabled={why !== null}>
        {text.save}
      </button>
      {reason && (
        <span class="error" role="status">
          {reason}
        </span>
      )}
    </div>
  );
}

/** A PNG typically takes this many bytes a pixel of such a scene. */
const PNG_BYTES = 0.35;

export function PicturePage({ motion, renderer }: { motion: Motion; renderer: ExportRenderer }) {
  const { app } = useUi();
  const now = choices.picture.value;
  // While it plays a new one each second is enough.
  const time = app.state.playing.value ? Math.floor(app.state.time.value) : app.state.time.value;
  const set = (change: Partial<typeof now>): void =>
    void (choices.picture.value = { ...choices.picture.peek(), ...change });
  return (
    <form
      onSubmit={(event) => {
        event.preventDefault();
        void savePicture(app, renderer, motion);
      }}
    >
      <Preview renderer={renderer} plan={picturePlan(time)} time={time} />
      <SizeFields prefix="png" width={now.width} height={now.height} onChange={set} />
      <ViewField view={now.view} motion={motion} testId="png-view" onChange={(view) => set({ view })} />
      <Choice
        label={text.background}
        value={now.transparent ? 'transparent' : 'theme'}
        testId="png-background"
        options={(['theme', 'transparent'] as const).map((id) => ({ id, label: text.backgrounds[id] }))}
        onChange={(id) => set({ transparent: id === 'transparent' })}
      />
      {!now.transparent && (
        <Check label={text.labels} checked={now.labels} testId="png-labels" onChange={(labels) => set({ labels })} />
      )}
      <Check label={text.fine} checked={now.fine} testId="png-fine" onChange={(fine) => set({ fine })} />
      <p class="hint">
        {text.atTime(app.state.time.value.toFixed(3))} {text.about(sizeInWords(PNG_BYTES * now.width * now.height))}
      </p>
      <SaveButton testId="save-png" reason={null} />
    </form>
  );
}
