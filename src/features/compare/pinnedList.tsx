import { bytesOf, MOST_PINNED_BYTES, MOST_PINNED, type PinnedRun } from '../../app/runs/pinnedRuns.ts';
import { firstWords } from './firstWords.ts';
import { words } from './words.ts';
import { text } from '../../ui/words.ts';
import { useUi } from '../../ui/context.ts';
import { Icon, Toggle } from '../../ui/kit/controls.tsx';
import { CURVES } from '../../app/runs/curveStyles.ts';
import { formatCount, formatDrift, formatShort, THIN } from '../../ui/kit/format.ts';

/** A short line as a curve is drawn. */
export function Swatch({ style }: { style: (typeof CURVES)[number] | null }) {
  return (
    <svg class="swatch" width="22" height="8" aria-hidden="true">
      <line
        x1="0"
        y1="4"
        x2="22"
        y2="4"
        stroke={style?.color ?? 'currentColor'}
        stroke-width="2.5"
        stroke-dasharray={style?.dash?.join(' ')}
      />
    </svg>
  );
}

export function PinnedList() {
  const {
    app: { state, pinned },
  } = useUi();
  const motion = state.motion.value;
  const stage = pinned.ofStage();
  const removed = pinned.removed.value;
  void state.rowsVersion.value;
  return (
    <section aria-label={words.list}>
      <div class="compare-head">
        <button
          type="button"
          class={stage ? '' : 'primary'}
          data-testid="compare-keep"
          disabled={!motion || stage !== undefined}
          onClick={() => pinned.pin()}
        >
          {stage ? words.kept : motion?.source === 'file' ? words.keepFile : firstWords.keep}
        </button>
        <span class="spring" />
        {removed && (
          <span role="status">
            {words.removed(removed.run.name)}{' '}
            <button type="button" class="link" data-testid="kept-undo" onClick={() => pinned.undo()}>
              {words.undo}
            </button>
          </span>
        )}
      </div>
      {state.pinned.value.length > 0 && (
        <>
          <ul class="pinned-list" data-testid="kept-list">
            {state.pinned.value.map((run) => (
              <Row key={run.id} run={run} />
            ))}
          </ul>
          <p class="hint">
            {words.room(
              formatShort(state.pinned.value.reduce((sum, r) => sum + bytesOf(r.motion), 0) / 1e6, 3),
              formatShort(MOST_PINNED_BYTES / 1e6),
              MOST_PINNED,
            )}
          </p>
        </>
      )}
    </section>
  );
}

function Row({ run }: { run: PinnedRun }) {
  const {
    app: { state, pinned },
  } = useUi();
  const { id, name, motion, visible, ghost } = run;
  const onStage = state.motion.value?.id === motion.id;
  const sameSystem = state.motion.value?.system.meta.id === motion.system.meta.id;
  const drawn = motion.system.meta.bodies.length > 0;
  return (
    <li data-testid={`kept-${id}`}>
      <Swatch style={CURVES[run.style % CURVES.length]!} />
      <div class="pinned-words">
        <input
          type="text"
          value={name}
          aria-label={words.name(name)}
          data-testid={`kept-name-${id}`}
          maxLength={80}
          onChange={(event) => {
            pinned.change(id, { name: event.currentTarget.value });
            event.currentTarget.value = state.pinned.peek().find((r) => r.id === id)?.name ?? name;
          }}
        />
        <span class="pinned-facts">
          {factsOf(run)}
          {onStage && ` · ${words.present}`}
        </span>
      </div>
      <Toggle
        pressed={visible}
        label={words.showPlots(name)}
        testId={`kept-visible-${id}`}
        onClick={() => pinned.change(id, { visible: !visible })}
      >
        {words.plots}
      </Toggle>
      {drawn && (
        <Toggle
          pressed={ghost}
          label={words.showGhost(name)}
          testId={`kept-ghost-${id}`}
          {...(sameSystem ? {} : { title: words.otherSystem })}
          onClick={() => pinned.change(id, { ghost: !ghost })}
        >
          {words.ghost}
        </Toggle>
      )}
      <button
        type="button"
        class="quiet square"
        aria-label={words.remove(name)}
        title={words.remove(name)}
        data-testid={`kept-remove-${id}`}
        onClick={() => pinned.remove(id)}
      >
        <Icon name="close" />
      </button>
      {ghost && !sameSystem && <p class="pinned-note">{words.otherSystem}</p>}
    </li>
  );
}

function factsOf({ motion, ending, statistics }: PinnedRun): string {
  const { trajectory, scenario, source, system } = motion;
  const facts = [
    source === 'file' ? words.file : (scenario?.method.name ?? ''),
    source === 'run' && (ending ? (text.status.reasons[ending.reason] ?? ending.reason) : words.computing),
    `${formatShort(trajectory.start, 4) === '0' ? '' : `${formatShort(trajectory.start, 4)} – `}${formatShort(trajectory.end, 4)}${THIN}s`,
    `${formatCount(trajectory.length)} ${words.rows}`,
    statistics && system.meta.order !== 1 && `${text.status.energy} ${formatDrift(statistics)}`,
    system.meta.title,
  ];
  return facts.filter(Boolean).join(' · ');
}
