/** The work in progress survives a reload: drafts and settings in local storage, the open file and dropped meshes in IndexedDB. */
import { effect } from '@preact/signals';
import { modelsOf } from '../../core/model/system.ts';
import type { SystemMeta } from '../../core/model/system.ts';
import type { App } from '../app.ts';
import { choicesFrom } from '../files/importChoices.ts';
import type { Meshes, OpenedFile } from '../files/fileState.ts';
import { settingValues } from '../state/settings.ts';
import { SETTINGS, settingIds, type SettingValues } from '../state/settingsTable.ts';
import { text } from '../words.ts';
import type { BrowserStorage } from './browserStorage.ts';
import { descriptionsIn, fromText, toText, workOf, type SavedState, type Work } from './savedWork.ts';

/** Writing waits for this long (ms), so that dragging a number writes once. */
const CALM = 400;
/** Bytes of a file that is stored; a longer one is remembered by its name. */
export const LARGEST_SAVED_FILE = 40e6;
const LARGEST_SAVED_MESHES = 8e6;
/** Names in the browser's storage: permanent. */
const WORK = 'work';
const FILE = 'file';
const MESHES = 'meshes';

/** As it is stored; a step alone is what was stored once. */
interface StoredFile extends OpenedFile {
  timeStep?: unknown;
}

export class Autosave {
  private readonly app: App;
  private readonly storage: BrowserStorage;
  private readonly systems: Readonly<Record<string, SystemMeta>>;
  private readonly toolIds: readonly string[];
  /** What was stored before the page was opened or before a link was; it stays stored until something is edited. */
  private before: Work | null = null;
  /** What is in the panel was not worked on yet: it is not stored. */
  private suspended = false;
  /** Called once, when what was suspended is edited. */
  private onEdit: () => void = () => {};
  private timer: ReturnType<typeof setTimeout> | undefined;
  private stored: string | null = null;
  private complained = false;
  private lastFile: string | null = null;

  constructor(
    app: App,
    storage: BrowserStorage,
    systems: Readonly<Record<string, SystemMeta>>,
    toolIds: readonly string[],
  ) {
    this.app = app;
    this.storage = storage;
    this.systems = systems;
    this.toolIds = toolIds;
  }

  /** Descriptions in what was stored, which have to be read before `restore`. */
  get descriptions(): string[] {
    const stored = this.storage.text(WORK);
    return stored === null ? [] : descriptionsIn(stored);
  }

  /** Puts back what was stored. What can't be used is said and left where it is until something is edited. */
  restore(): Work | null {
    this.stored = this.storage.text(WORK);
    if (this.stored === null) return null;
    let saved: SavedState;
    try {
      saved = fromText(this.stored, { systems: this.systems, cases: this.app.cases, toolIds: this.toolIds });
    } catch (error) {
      this.app.actions.report('warning', text.unusable, [(error as Error).message, text.unusableHint]);
      this.suspended = true;
      return null;
    }
    this.app.actions.setAll(saved.settings);
    this.app.actions.restoreDrafts(saved.work, saved.work.drafts);
    this.before = saved.work;
    return saved.work;
  }

  /** From now on every change is stored. */
  watch(): void {
    const { state, events } = this.app;
    events.draftEdited.subscribe(() => {
      if (this.suspended) this.resume();
    });
    const watched = settingIds.filter((id) => SETTINGS[id].stored !== undefined).map((id) => state[id]);
    effect(() => {
      for (const signal of [...watched, state.draft, state.drafts, state.origin, state.motion]) void signal.value;
      clearTimeout(this.timer);
      this.timer = setTimeout(() => this.write(), CALM);
    });
    events.fileOpened.subscribe((opened) => this.storeFile(opened));
    let meshes = state.meshes.peek();
    effect(() => {
      if (state.meshes.value === meshes) return;
      meshes = state.meshes.value;
      this.storeMeshes(meshes);
    });
    addEventListener('pagehide', () => this.write());
    document.addEventListener('visibilitychange', () => document.visibilityState === 'hidden' && this.write());
  }

  /** What is on the page now came from a link: the work from before stays stored until something is edited. */
  suspend(before: Work, onEdit: () => void): void {
    this.before = before;
    this.suspended = true;
    this.onEdit = onEdit;
  }

  /** The work that a link took the place of, while that was not edited. */
  get suspendedWork(): Work | null {
    return this.suspended ? this.before : null;
  }

  /** Back to work that a link took the place of. */
  async restoreWork(work: Work): Promise<void> {
    this.suspended = false;
    this.edited();
    this.app.actions.restoreDrafts(work, work.drafts);
    if (work.file === null || !(await this.reopenFile(work.file))) this.app.actions.run();
  }

  /** Puts the stored file on the stage. False when it is not there any more. */
  async reopenFile(name: string): Promise<boolean> {
    const saved = (await this.storage.large(FILE)) as Partial<StoredFile> | undefined;
    if (saved?.name !== name || !(saved.file instanceof Blob)) {
      this.app.actions.report('info', text.fileGone(name), [text.fileGoneHint(LARGEST_SAVED_FILE / 1e6)]);
      return false;
    }
    await this.app.actions.openFile(name, saved.file, choicesFrom(saved.choices ?? { step: saved.timeStep }));
    const motion = this.app.state.motion.peek();
    return motion?.source === 'file' && motion.title === name;
  }

  async reopenMeshes(): Promise<void> {
    const saved = await this.storage.large(MESHES);
    if (!Array.isArray(saved)) return;
    const known = new Set(
      Object.values(this.systems).flatMap((meta) => modelsOf(meta).map((name) => `${meta.id}/${name}`)),
    );
    const good = (saved as [string, { mdl?: unknown; mat?: unknown }][]).filter(
      ([key, pair]) =>
        known.has(key) && [pair.mdl, pair.mat].every((half) => half === undefined || typeof half === 'string'),
    );
    if (good.length > 0 && this.app.state.meshes.peek().size === 0)
      this.app.actions.setMeshes(new Map(good as [string, { mdl?: string; mat?: string }][]));
  }

  async forget(): Promise<void> {
    clearTimeout(this.timer);
    const reason = await this.storage.clear();
    this.before = null;
    this.suspended = true;
    this.stored = null;
    this.app.actions.report(reason ? 'warning' : 'info', reason ? text.notForgotten : text.forgotten, [
      reason ?? text.forgottenHint,
    ]);
  }

  /** What was suspended is worked on now. */
  private resume(): void {
    this.suspended = false;
    this.before = null;
    this.edited();
  }

  private edited(): void {
    this.onEdit();
    this.onEdit = () => {};
  }

  private write(): void {
    clearTimeout(this.timer);
    const { state } = this.app;
    // A draft that cannot run would not be taken back: the last good one stays.
    if (state.draftErrors.peek().size > 0) return;
    const work = this.suspended ? this.before : workOf(state);
    if (!work) return;
    const now = toText({ work, settings: this.settings() });
    if (now === this.stored) return;
    this.stored = now;
    this.complain(this.storage.putText(WORK, now));
  }

  /** A mode is played at a speed of its own: what it suspends is stored. */
  private settings(): SettingValues {
    const { speed, loop } = this.app.state.modePreview.peek()?.suspended ?? {};
    return {
      ...settingValues(this.app.state),
      ...(speed === undefined ? {} : { speed }),
      ...(loop === undefined ? {} : { loop }),
    };
  }

  private storeFile({ name, file, choices }: OpenedFile): void {
    const saved: StoredFile | null = file.size > LARGEST_SAVED_FILE ? null : { name, file, choices };
    const again = name === this.lastFile;
    this.lastFile = name;
    // Read another way it is the same file.
    if (!saved && !again)
      this.app.actions.report('info', text.fileLarge(name), [text.fileLargeHint(LARGEST_SAVED_FILE / 1e6)]);
    void this.storage.putLarge(FILE, saved).then((reason) => this.complain(reason));
  }

  private storeMeshes(meshes: Meshes): void {
    const size = [...meshes].reduce((sum, [, { mdl = '', mat = '' }]) => sum + mdl.length + mat.length, 0);
    void this.storage
      .putLarge(MESHES, size > LARGEST_SAVED_MESHES ? null : [...meshes])
      .then((reason) => this.complain(reason));
  }

  /** Once is enough. */
  private complain(reason: string | null): void {
    if (reason === null || this.complained) return;
    this.complained = true;
    this.app.actions.report('info', text.notStored, [text.notStoredHint(reason)]);
  }
}
