/** One line that is always there: how the numbers were made and whether to trust them. */
import type { Motion } from '../../app/runs/motion.ts';
import { DEFAULTS } from '../../core/scenario/defaults.ts';
import { Connection } from './connection.tsx';
import { useUi } from '../context.ts';
import { formatCount, formatPower, THIN, type EnergyFacts } from '../kit/format.ts';
import { Term } from '../kit/term.tsx';
import { Slot } from '../slot.tsx';
import { text } from '../words.ts';

/** Ends that nothing went wrong in; only the others are red. */
const EXPECTED: ReadonlySet<string> = new Set(['end', 'cancelled', 'touchdown']);

export function StatusLine() {
  const ui = useUi();
  const motion = ui.app.state.motion.value;
  return (
    <footer class="status" data-testid="status" aria-label={text.status.label} tabIndex={0}>
      {motion?.source === 'mode' ? (
        <span>{text.viewMenu.modeFacts}</span>
      ) : motion?.source === 'file' ? (
        <FileFacts />
      ) : (
        <RunFacts />
      )}
      <span class="spring" />
      <Connection />
      {motion?.source !== 'mode' && <RunStanding />}
    </footer>
  );
}

function RunFacts() {
  const ui = useUi();
  const { state } = ui.app;
  const statistics = state.statistics.value;
  const method = (state.motion.value?.scenario ?? state.draft.value).method;
  const name = method?.name ?? DEFAULTS.method;
  const words = text.status;
  const energyless = (state.motion.value?.system ?? ui.system.value)?.meta.order === 1;
  return (
    <>
      <span title={name === 'ida' ? undefined : (method?.formulation ?? DEFAULTS.formulation)}>{name}</span>
      <span data-testid="steps">
        {statistics ? formatCount(statistics.steps) : '–'} {words.steps}
      </span>
      <Trust numbers={energyless ? null : statistics} driven={isDriven(state.motion.value)} />
    </>
  );
}

/** Units of what takes energy away as it moves. */
const LOSSES: ReadonlySet<string> = new Set(['N·s/m', 'N·m·s/rad', 'kg/s']);

/** Whether something does work on the system, so that its energy is no measure of accuracy. */
function isDriven(motion: Motion | null): boolean {
  const scenario = motion?.scenario;
  if (!scenario) return false;
  const losses = motion.system.meta.parameters.filter(({ unit }) => LOSSES.has(unit));
  return (
    scenario.control !== null ||
    Object.keys(scenario.inputs).length > 0 ||
    motion.system.meta.losses === true ||
    losses.some(({ name }) => (scenario.parameters[name] ?? 0) > 0)
  );
}

/** What energy did, by what says most of how good the numbers are. */
function Energy({ numbers, driven }: { numbers: (EnergyFacts & { work?: number | null }) | null; driven: boolean }) {
  const words = text.status;
  const joules = (x: number) => <b data-testid="energy">{`${formatPower(x)}${THIN}J`}</b>;
  if (numbers && (driven || (numbers.work ?? null) !== null)) {
    const { work = null, energyChange } = numbers;
    return work === null ? (
      <span title={words.energyChangeTitle}>
        {words.energyChange} {joules(energyChange)}
      </span>
    ) : (
      <span title={words.workBalanceTitle}>
        {words.workBalance} {joules(energyChange - work)}
      </span>
    );
  }
  return (
    <span title={words.energyTitle}>
      {words.drift}{' '}
      {numbers === null ? (
        <b data-testid="energy">–</b>
      ) : numbers.energyDrift === null ? (
        joules(numbers.energyChange)
      ) : (
        <>
          <b data-testid="energy">{formatPower(numbers.energyDrift)}</b> {words.ofKinetic}
        </>
      )}
    </span>
  );
}

/** Energy and constraint residual; dashes where they are not known. */
function Trust({
  numbers,
  driven,
}: {
  numbers: (EnergyFacts & { work?: number | null; residual: number }) | null;
  driven: boolean;
}) {
  const words = text.status;
  return (
    <>
      <Energy numbers={numbers} driven={driven} />
      <span title={words.residualTitle}>
        <Term id="residual">{words.residual}</Term>{' '}
        <b data-testid="residual">{numbers ? formatPower(numbers.residual) : '–'}</b>
      </span>
    </>
  );
}

/** Lines that something is noted on, ranges by their length. */
function linesOf({ issues }: Motion): number {
  const lines = new Set<number>();
  for (const { line, to = line } of issues) for (let l = line; l <= to && l > 0; l++) lines.add(l);
  return lines.size;
}

function FileFacts() {
  const { state } = useUi().app;
  void state.rowsVersion.value;
  const motion = state.motion.value!;
  const skipped = linesOf(motion);
  return (
    <>
      <span class="file-name">{motion.title}</span>
      <span data-testid="rows">
        {formatCount(motion.trajectory.length)} {text.status.rows}
      </span>
      <span data-testid="columns">
        {motion.trajectory.columns.length} {text.status.columns}
      </span>
      {skipped > 0 && <span data-testid="skipped">{text.status.skipped(skipped)}</span>}
      {motion.judgement && <Trust numbers={motion.judgement} driven={isDriven(motion)} />}
    </>
  );
}

function RunStanding() {
  const { state, actions } = useUi().app;
  const reading = state.reading.value;
  if (reading) {
    return (
      <span class="standing" data-testid="reading">
        <progress max={1} value={reading.share} aria-label={text.status.reading(reading.name)} />
        {text.status.readingRows(reading.name, formatCount(reading.rows))}
        <button type="button" class="link" data-testid="cancel-reading" onClick={() => actions.cancelReading()}>
          {text.panel.cancel}
        </button>
      </span>
    );
  }
  const writing = state.writing.value;
  if (writing) {
    return (
      <span class="standing" data-testid="writing">
        <progress max={1} value={writing.share} aria-label={text.status.writing(writing.name)} />
        {text.status.writingShare(writing.name, Math.floor(100 * writing.share))}
        <button type="button" class="link" data-testid="cancel-writing" onClick={() => actions.cancelWriting()}>
          {text.panel.cancel}
        </button>
      </span>
    );
  }
  const run = state.run.value;
  if (run?.kind === 'computing') {
    return (
      <span class="standing" data-testid="run-state">
        <progress max={1} value={run.derived ?? run.progress} aria-label={text.said.computing} />
        {run.derived === undefined
          ? text.status.computing(Math.floor(100 * run.progress))
          : text.status.deriving(Math.floor(100 * run.derived))}
        <button type="button" class="link" onClick={() => actions.cancel()}>
          {text.panel.cancel}
        </button>
      </span>
    );
  }
  if (run?.kind === 'ended') {
    const failed = !EXPECTED.has(run.reason);
    return (
      <>
        <span
          class={`standing${failed ? ' failed' : ''}`}
          data-testid="run-state"
          data-reason={run.reason}
          title={run.message}
        >
          {text.status.ended(text.status.reasons[run.reason] ?? run.reason)}
        </span>
        <Slot name="runStatus" />
      </>
    );
  }
  return (
    <span class="standing" data-testid="run-state">
      {state.motion.value ? '' : text.status.idle}
    </span>
  );
}
