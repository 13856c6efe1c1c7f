/** The last work survives a reload: drafts and settings in local storage, the open file and dropped meshes in IndexedDB. */
import { batch, effect, type Signal } from '@preact/signals';
import { modelsOf } from '../../core/model/system.ts';
import type { SystemMeta } from '../../core/model/system.ts';
import { text } from '../words.ts';
import { fromText, LOOKS, toText, workOf, type Kept, type Settings, type Work } from './savedWork.ts';
import type { Shelf } from './browserStorage.ts';
import type { App, AppState } from '../types.ts';

/** Writing waits for this long (ms), so that dragging a number writes once. */
const CALM = 400;
/** Bytes of a file that is kept; a longer one is remembered by its name. */
export const LARGEST_KEPT_FILE = 40e6;
const LARGEST_KEPT_MESHES = 8e6;
const WORK = 'work';

export interface KeptFile {
  name: string;
  file: Blob;
  timeStep?: number;
}

export class Keeper {
  private readonly app: App;
  private readonly shelf: Shelf;
  private readonly systems: Readonly<Record<string, SystemMeta>>;
  private readonly toolIds: readonly string[];
  /** What was kept before this visit or before a link was opened; it stays stored until something is edited. */
  private before: Work | null = null;
  /** The draft that is only looked at, not yet worked on. */
  private shown: unknown = null;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private stored: string | null = null;
  private complained = false;

  constructor(app: App, shelf: Shelf, systems: Readonly<Record<string, SystemMeta>>, toolIds: readonly string[]) {
    this.app = app;
    this.shelf = shelf;
    this.systems = systems;
    this.toolIds = toolIds;
  }

  /** Puts back what was kept. What can't be used is said and left where it is until something is edited. */
  restore(): Work | null {
    this.stored = this.shelf.text(WORK);
    if (this.stored === null) return null;
    let kept: Kept;
    try {
      kept = fromText(this.stored, { systems: this.systems, cases: this.app.cases, toolIds: this.toolIds });
    } catch (error) {
      this.app.actions.report('warning', text.unusable, [(error as Error).message, text.unusableHint]);
      this.shown = this.app.state.draft.peek();
      return null;
    }
    this.putSettings(kept.settings);
    this.putWork(kept.work);
    this.before = kept.work;
    return kept.work;
  }

  /** From now on every change is kept. */
  watch(): void {
    const { state } = this.app;
    effect(() => {
      for (const signal of this.watched()) void signal.value;
      if (this.shown !== null && state.draft.value !== this.shown) this.workOn();
      clearTimeout(this.timer);
      this.timer = setTimeout(() => this.write(), CALM);
    });
    effect(() => this.keepFile(state.opened.value));
    let meshes = state.meshes.peek();
    effect(() => {
      if (state.meshes.value === meshes) return;
      meshes = state.meshes.value;
      this.keepMeshes([...meshes]);
    });
    addEventListener('pagehide', () => this.write());
    document.addEventListener('visibilitychange', () => document.visibilityState === 'hidden' && this.write());
  }

  /** What is on the page now came from a link: the work from before stays stored until something is edited. */
  showOnly(before: Work, onEdit: () => void): void {
    this.before = before;
    this.shown = this.app.state.draft.peek();
    this.edited = onEdit;
  }

  /** The work that a link put aside. */
  get aside(): Work | null {
    return this.shown === null ? null : this.before;
  }

  /** Back to work that was put aside. */
  async putBack(work: Work): Promise<void> {
    this.shown = null;
    this.edited();
    this.edited = () => {};
    this.putWork(work);
    if (work.file === null || !(await this.reopenFile(work.file))) this.app.actions.run();
  }

  /** Puts the kept file on the stage. False when it is not there any more. */
  async reopenFile(name: string): Promise<boolean> {
    const kept = (await this.shelf.large('file')) as Partial<KeptFile> | undefined;
    if (kept?.name !== name || !(kept.file instanceof Blob)) {
      this.app.actions.report('info', text.fileGone(name), [text.fileGoneHint(LARGEST_KEPT_FILE / 1e6)]);
      return false;
    }
    await this.app.actions.openFile(name, kept.file, typeof kept.timeStep === 'number' ? kept.timeStep : undefined);
    const motion = this.app.state.motion.peek();
    return motion?.source === 'file' && motion.title === name;
  }

  async reopenMeshes(): Promise<void> {
    const kept = await this.shelf.large('meshes');
    if (!Array.isArray(kept)) return;
    const known = new Set(
      Object.values(this.systems).flatMap((meta) => modelsOf(meta).map((name) => `${meta.id}/${name}`)),
    );
    const good = (kept as [string, { mdl?: unknown; mat?: unknown }][]).filter(
      ([key, pair]) =>
        known.has(key) && [pair.mdl, pair.mat].every((half) => half === undefined || typeof half === 'string'),
    );
    if (good.length > 0 && this.app.state.meshes.peek().size === 0)
      this.app.state.meshes.value = new Map(good as [string, { mdl?: string; mat?: string }][]);
  }

  async forget(): Promise<void> {
    clearTimeout(this.timer);
    const reason = await this.shelf.clear();
    this.before = null;
    this.shown = this.app.state.draft.peek();
    this.stored = null;
    this.app.actions.report(reason ? 'warning' : 'info', reason ? text.notForgotten : text.forgotten, [
      reason ?? text.forgottenHint,
    ]);
  }

  private edited: () => void = () => {};

  private workOn(): void {
    this.shown = null;
    this.before = null;
    this.edited();
    this.edited = () => {};
  }

  private watched(): readonly Signal<unknown>[] {
    const {
      draft,
      drafts,
      origin,
      theme,
      tool,
      view,
      follow,
      showTrails,
      showForces,
      loop,
      speed,
      motion,
      plots,
      look,
    } = this.app.state;
    return [
      ...LOOKS.map((name) => look[name]),
      look.quality,
      draft,
      drafts,
      origin,
      theme,
      tool,
      view,
      follow,
      showTrails,
      showForces,
      loop,
      speed,
      motion,
      plots,
    ];
  }

  private write(): void {
    clearTimeout(this.timer);
    const { state } = this.app;
    // A draft that cannot run would not be taken back: the last good one stays.
    if (state.draftErrors.peek().size > 0) return;
    const work = this.shown === null ? workOf(state) : this.before;
    if (!work) return;
    const now = toText({ work, settings: this.settings() });
    if (now === this.stored) return;
    this.stored = now;
    this.complain(this.shelf.putText(WORK, now));
  }

  private settings(): Settings {
    const { theme, tool, view, follow, showTrails, showForces, loop, speed, plots, look } = this.app.state;
    const plain = Object.entries({ theme, tool, view, follow, showTrails, showForces, loop, speed, plots });
    const { speed: speedBefore, loop: loopBefore } = this.app.state.aside.peek() ?? {
      speed: speed.peek(),
      loop: loop.peek(),
    };
    return {
      ...(Object.fromEntries(plain.map(([name, signal]) => [name, signal.peek()])) as Settings),
      speed: speedBefore,
      loop: loopBefore,
      look: { ...Object.fromEntries(LOOKS.map((name) => [name, look[name].peek()])), quality: look.quality.peek() },
    };
  }

  private putSettings({ look = {}, ...settings }: Settings): void {
    batch(() => {
      for (const [name, value] of Object.entries(look))
        (this.app.state.look[name as keyof typeof look] as Signal<unknown>).value = value;
      for (const [name, value] of Object.entries(settings))
        (this.app.state[name as keyof typeof settings] as Signal<unknown>).value = value;
    });
  }

  private putWork({ draft, origin, drafts }: Work): void {
    const { state } = this.app;
    batch(() => {
      state.drafts.value = drafts;
      state.origin.value = origin;
      state.draft.value = draft;
    });
  }

  private keepFile(opened: AppState['opened']['value']): void {
    if (!opened) return;
    this.app.state.opened.value = null;
    const { name, file, timeStep } = opened;
    const kept: KeptFile | null =
      file.size > LARGEST_KEPT_FILE ? null : { name, file, ...(timeStep === undefined ? {} : { timeStep }) };
    if (!kept) this.app.actions.report('info', text.fileLarge(name), [text.fileLargeHint(LARGEST_KEPT_FILE / 1e6)]);
    void this.shelf.putLarge('file', kept).then((reason) => this.complain(reason));
  }

  private keepMeshes(meshes: readonly [string, { mdl?: string; mat?: string }][]): void {
    const size = meshes.reduce((sum, [, { mdl = '', mat = '' }]) => sum + mdl.length + mat.length, 0);
    void this.shelf
      .putLarge('meshes', size > LARGEST_KEPT_MESHES ? null : meshes)
      .then((reason) => this.complain(reason));
  }

  /** Once a visit is enough. */
  private complain(reason: string | null): void {
    if (reason === null || this.complained) return;
    this.complained = true;
    this.app.actions.report('info', text.notKept, [text.notKeptHint(reason)]);
  }
}
