/** Everything that can leave the page: pictures, videos, 3-D files, tables, scenarios. */
import './export.css';
import { useUi } from '../../ui/context.ts';
import { Choice, Toggle } from '../../ui/kit/controls.tsx';
import { Dialog } from '../../ui/kit/dialog.tsx';
import { later } from '../../ui/kit/later.tsx';
import type { ExportRenderer } from '../../app/files/exportRenderer.ts';
import type { Motion } from '../../app/runs/motion.ts';
import { MOST_KEYS, sizeInWords } from '../../app/files/exportPlan.ts';
import { firstWords } from './firstWords.ts';
import { words as text } from './words.ts';
import { RangeFields } from './fields.tsx';
import { choices, job, keysOf, rangeOf, saveGlb, type Tab } from './jobs.ts';
import { ExchangePart } from './exchangePart.tsx';
import { PicturePage, SaveButton } from './picturePage.tsx';

/** With the encoder's code. */
const VideoPage = later(async () => (await import('./videoPage.tsx')).VideoPage);

export function ExportDialog() {
  const { state, actions, exportService } = useUi().app;
  const tab = choices.tab.value;
  void state.rowsVersion.value;
  const motion = state.motion.value;
  const renderer = exportService.available.value ? exportService.renderer() : null;
  const trouble = !motion || motion.trajectory.length === 0 ? text.noMotion : !renderer ? text.noScene : null;
  return (
    <Dialog title={firstWords.title} testId="export-dialog" document="page.md#export" onClose={actions.closeDialog}>
      <div class="export">
        <div class="segments" role="group" aria-label={text.kinds}>
          {(Object.keys(text.tabs) as Tab[]).map((id) => (
            <Toggle
              key={id}
              pressed={tab === id}
              testId={`export-tab-${id}`}
              onClick={() => {
                choices.tab.value = id;
              }}
            >
              {text.tabs[id]}
            </Toggle>
          ))}
        </div>
        {tab === 'data' ? (
          <DataPage motion={motion} />
        ) : trouble ? (
          <p class="hint" data-testid="export-trouble">
            {trouble}
          </p>
        ) : (
          <ScenePage tab={tab} motion={motion!} renderer={renderer!} />
        )}
        <Progress />
      </div>
    </Dialog>
  );
}

function ScenePage({ tab, motion, renderer }: { tab: Tab; motion: Motion; renderer: ExportRenderer }) {
  if (tab === 'picture') return <PicturePage motion={motion} renderer={renderer} />;
  return tab === 'video' ? (
    <VideoPage motion={motion} renderer={renderer} />
  ) : (
    <GlbPage motion={motion} renderer={renderer} />
  );
}

function GlbPage({ motion, renderer }: { motion: Motion; renderer: ExportRenderer }) {
  const { app } = useUi();
  const { from, to } = rangeOf(motion);
  const rate = choices.rate.value;
  const { trajectory } = motion;
  const rows = keysOf(motion, null);
  const keys = keysOf(motion);
  const bodies = motion.system.meta.bodies.length;
  // 28 bytes a body and key, 16 a wheel; meshes of a body take some 60 kB
  const bytes = keys * (4 + 28 * bodies + 16 * motion.system.contacts.length) + 60e3 * bodies;
  const reason =
    keys === 0 || (to <= from && trajectory.length > 1)
      ? text.empty
      : keys > MOST_KEYS
        ? text.tooManyKeys(String(MOST_KEYS))
        : null;
  return (
    <form
      onSubmit={(event) => {
        event.preventDefault();
        if (!reason) void saveGlb(app, renderer, motion);
      }}
    >
      <p class="hint">{text.glbAbout}</p>
      <RangeFields motion={motion} />
      <Choice
        label={text.rate}
        value={String(rate ?? 'rows')}
        testId="glb-rate"
        options={[
          { id: 'rows', label: text.rows(String(rows)) },
          ...[24, 30, 60, 120].map((n) => ({ id: String(n), label: text.perSecond(n) })),
        ]}
        onChange={(id) => {
          choices.rate.value = id === 'rows' ? null : Number(id);
        }}
      />
      <p class="hint" data-testid="glb-facts">
        {text.glbFacts(String(keys), bodies, (to - from).toFixed(2), sizeInWords(bytes))}
      </p>
      <SaveButton testId="save-glb" reason={reason} />
    </form>
  );
}

function DataPage({ motion }: { motion: Motion | null }) {
  const { actions } = useUi().app;
  return (
    <div class="data">
      <button type="button" data-testid="save-csv" disabled={!motion} onClick={actions.exportCsv}>
        {text.csv}
      </button>
      <p class="hint">{motion ? text.csvAbout : text.noMotion}</p>
      <button type="button" data-testid="save-scenario" onClick={actions.saveScenario}>
        {text.scenario}
      </button>
      <p class="hint">{text.scenarioAbout}</p>
      <ExchangePart />
    </div>
  );
}

function Progress() {
  const now = job.value;
  if (!now) return null;
  return (
    <div class="export-progress" data-testid="export-progress">
      <progress max={now.all} value={now.done} aria-label={text.progressLabel} />
      <span>{now.all > 1 ? text.progress[now.of](now.done, now.all) : text.preparing}</span>
      <button type="button" data-testid="export-cancel" onClick={now.cancel}>
        {text.cancel}
      </button>
      <p class="hint">{text.hide}</p>
    </div>
  );
}
