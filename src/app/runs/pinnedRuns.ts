import { effect, signal, type ReadonlySignal } from '@preact/signals';
import type { MessageActions } from '../state/messages.ts';
import { readonly } from '../state/signals.ts';
import type { Motion, RunState, RunStatistics } from './motion.ts';
import type { StageState } from './stageState.ts';

/** A motion that stays, beside the one on the stage. */
export interface PinnedRun {
  id: number;
  /** As the person calls it. */
  name: string;
  /** Place in the list of curves' colours and dashes. */
  style: number;
  motion: Motion;
  /** Null for files. */
  statistics: RunStatistics | null;
  ending: Extract<RunState, { kind: 'ended' }> | null;
  /** Shown in the plots. */
  visible: boolean;
  /** Shown in the scene. */
  ghost: boolean;
}

/** Numbers that pinned runs may hold together, in bytes; and how many there may be, as many as curves can be told apart. */
export const MOST_PINNED_BYTES = 256e6;
export const MOST_PINNED = 11;

/** Names are cut here. */
const LONGEST_NAME = 80;

export const bytesOf = ({ trajectory }: Motion): number => 8 * trajectory.columns.length * trajectory.length;

interface Removed {
  run: PinnedRun;
  /** Where it stood. */
  place: number;
}

/** Pins what is on the stage. A run still computing is pinned as it goes on. */
export class PinnedRuns {
  private readonly list = signal<readonly PinnedRun[]>([]);
  private readonly lastRemoved = signal<Removed | null>(null);
  readonly runs: ReadonlySignal<readonly PinnedRun[]> = readonly(this.list);
  /** What was removed last. */
  readonly removed: ReadonlySignal<Removed | null> = readonly(this.lastRemoved);
  private readonly stage: StageState;
  private readonly messages: MessageActions;
  private next = 1;

  constructor(stage: StageState, messages: MessageActions) {
    this.stage = stage;
    this.messages = messages;
    effect(() => this.follow(stage.run.value));
  }

  /** Bytes held. */
  get bytes(): number {
    return this.runs.value.reduce((sum, { motion }) => sum + bytesOf(motion), 0);
  }

  /** Pins the motion on the stage; says so when there is no room. Its entry, or null. */
  pin(): PinnedRun | null {
    const { stage } = this;
    const motion = stage.motion.peek();
    if (!motion || motion.trajectory.length === 0)
      return this.refuse('There is nothing to pin', 'Run a scenario or open a file first.');
    const runs = this.runs.peek();
    const already = runs.find((r) => r.motion.id === motion.id);
    if (already) return this.refuse('This run is pinned already', `It is called “${already.name}”.`);
    if (runs.length >= MOST_PINNED)
      return this.refuse(
        'No more runs can be pinned',
        `There are ${MOST_PINNED}, as many as curves can be told apart; remove one first.`,
      );
    const bytes = this.runs.peek().reduce((sum, r) => sum + bytesOf(r.motion), bytesOf(motion));
    if (bytes > MOST_PINNED_BYTES)
      return this.refuse(
        'This run is too large to pin',
        `Pinned runs would take ${(bytes / 1e6).toFixed(0)} MB, more than ${MOST_PINNED_BYTES / 1e6} MB; remove some, or run with a larger output step.`,
      );
    const run = stage.run.peek();
    const pinned: PinnedRun = {
      id: this.next++,
      name: this.unusedName(motion.title),
      style: this.unusedStyle(),
      motion,
      statistics: motion.source === 'run' ? stage.statistics.peek() : null,
      ending: run?.kind === 'ended' && motion.source === 'run' ? run : null,
      visible: true,
      ghost: false,
    };
    this.list.value = [...runs, pinned];
    return pinned;
  }

  /** Puts back what was pinned before, ahead of what is; as many as there is room for. */
  restore(earlier: readonly Omit<PinnedRun, 'id'>[]): void {
    const now = this.runs.peek();
    const styles = new Set(now.map(({ style }) => style));
    const back = earlier
      .slice(0, MOST_PINNED - now.length)
      .map((run) => ({ ...run, id: this.next++ }))
      .map((run) => (styles.has(run.style) ? { ...run, style: freeStyle([...now, ...earlier]) } : run));
    if (back.length > 0) this.list.value = [...back, ...now];
  }

  /** The entry of the motion on the stage, if it is pinned. */
  ofStage(): PinnedRun | undefined {
    const id = this.stage.motion.value?.id;
    return this.runs.value.find((r) => r.motion.id === id);
  }

  change(id: number, change: Partial<Pick<PinnedRun, 'name' | 'visible' | 'ghost'>>): void {
    const name = change.name === undefined ? undefined : change.name.trim().slice(0, LONGEST_NAME);
    // An empty name is none.
    const clean = { ...change, ...(name === undefined ? {} : { name }) };
    if (name === '') delete clean.name;
    this.list.value = this.runs.peek().map((r) => (r.id === id ? { ...r, ...clean } : r));
  }

  remove(id: number): void {
    const runs = this.runs.peek();
    const place = runs.findIndex((r) => r.id === id);
    if (place < 0) return;
    this.lastRemoved.value = { run: runs[place]!, place };
    this.list.value = runs.filter((r) => r.id !== id);
  }

  /** Puts back what was removed last; in another colour when its own is taken. */
  undo(): void {
    const removed = this.removed.peek();
    if (!removed) return;
    const runs = [...this.runs.peek()];
    const style = runs.some((r) => r.style === removed.run.style) ? this.unusedStyle() : removed.run.style;
    runs.splice(removed.place, 0, { ...removed.run, style });
    this.lastRemoved.value = null;
    this.list.value = runs;
  }

  private follow(run: RunState | null): void {
    const motion = this.stage.motion.peek();
    const pinned = this.runs.peek().find((r) => r.motion.id === motion?.id);
    if (!pinned || run?.kind !== 'ended' || pinned.ending || motion?.source !== 'run') return;
    const statistics = this.stage.statistics.peek();
    this.list.value = this.runs.peek().map((r) => (r === pinned ? { ...r, motion, statistics, ending: run } : r));
  }

  private refuse(title: string, detail: string): null {
    this.messages.report('info', title, [detail]);
    return null;
  }

  private unusedName(title: string): string {
    const names = new Set(this.runs.peek().map((r) => r.name));
    if (!names.has(title)) return title;
    for (let n = 2; ; n++) if (!names.has(`${title} (${n})`)) return `${title} (${n})`;
  }

  private readonly unusedStyle = (): number => freeStyle(this.runs.peek());
}

function freeStyle(runs: readonly Pick<PinnedRun, 'style'>[]): number {
  const used = new Set(runs.map((r) => r.style));
  for (let n = 0; ; n++) if (!used.has(n)) return n;
}
