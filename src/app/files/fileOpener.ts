import { modelsOf } from '../../core/model/system.ts';
import { settled } from '../../core/scenario/own.ts';
import type { SystemMeta, SystemView } from '../../core/model/system.ts';
import { dataView } from '../../core/motion/dataView.ts';
import type { ImportChoices, Question } from '../../csv/plan.ts';
import type { Kind } from '../../csv/units/units.ts';
import { learnSystem, learnSystemOf, systemViews } from '../../core/systems/registry.ts';
import { Trajectory } from '../../core/motion/trajectory.ts';
import type { ScenarioFile } from '../../core/scenario/types.ts';
import type { CsvResult } from '../../csv/csv.ts';
import type { FileReading } from '../../compute/services/csvTypes.ts';
import type { CsvClient } from '../../compute/client/csvClient.ts';
import type { FileIssue, Motion } from '../runs/motion.ts';
import type { StageState } from '../runs/stageState.ts';
import { ownCase, type CaseInfo } from '../state/cases.ts';
import type { ExperimentState } from '../state/experiment.ts';
import type { MessageActions } from '../state/messages.ts';
import { kindOf } from './fileKind.ts';
import { mergedChoices, remembering } from './mergedChoices.ts';
import { scenarioIn } from './scenarioText.ts';
import type { SettingsSlice } from '../state/settings.ts';
import type { FileSlice } from './fileState.ts';
import type { SampleInfo } from './samples.ts';

interface Context {
  files: FileSlice;
  stage: StageState;
  experiment: ExperimentState;
  csv: CsvClient;
  messages: MessageActions;
  metas: Readonly<Record<string, SystemMeta>>;
  settings: SettingsSlice;
  show(motion: Omit<Motion, 'id'>): void;
  /** In place of another reading of the same file: where and whether it is played stays. */
  showAgain(motion: Omit<Motion, 'id'>): void;
  openScenario(origin: CaseInfo, scenario: ScenarioFile): void;
}

/** Larger files are refused by name and size; what a table holds is limited by the reader (`MOST_NUMBERS`). */
const LARGEST_TABLE = 2e9;
const LARGEST_SCENARIO = 5e6;

/** A table on its way, with what a person chose for its reading. */
interface Table {
  name: string;
  file: Blob;
  choices: ImportChoices;
}

/** Opens dropped and chosen files; whatever is wrong with one leaves what is on the stage untouched. */
export class FileOpener {
  private readonly context: Context;
  private waiting: Table | null = null;
  private reading: AbortController | null = null;

  constructor(context: Context) {
    this.context = context;
  }

  async open(files: readonly File[]): Promise<void> {
    const kinds = await Promise.all(files.map((file) => kindOf(file.name, file).catch(() => 'table' as const)));
    const meshes = files.filter((_, i) => kinds[i] === 'mesh');
    if (meshes.length > 0) await this.openMeshes(meshes);
    for (const file of files.filter((f) => !meshes.includes(f))) await this.openFile(file.name, file);
  }

  async openSample(id: string, samples: readonly SampleInfo[]): Promise<void> {
    const sample = samples.find((s) => s.id === id);
    if (!sample) return;
    try {
      const response = await fetch(sample.url);
      if (!response.ok) throw new Error(`the server answered ${response.status}`);
      await this.readTable(sample.title, await response.blob());
    } catch (error) {
      this.fail(sample.title, [messageOf(error)]);
    }
  }

  /** Goes on with the file that a question was asked about; null gives it up. */
  async answerPending(answer: ImportChoices | null): Promise<void> {
    const { waiting, context } = this;
    this.waiting = null;
    context.files.actions.setPendingFile(null);
    if (!waiting || !answer) return;
    const table = { ...waiting, choices: mergedChoices(waiting.choices, answer) };
    await this.read(table).catch((error: unknown) => this.fail(table.name, [messageOf(error)]));
  }

  /**
   * Reads the file on the stage again; the motion stays until the new one is there. What is chosen while it is read, or
   * after it could not be, comes on top of what was.
   * @param change of the choices; null: everything as it is found
   */
  async readAgain(change: ImportChoices | null): Promise<void> {
    const { state, actions } = this.context.files;
    const shown = this.context.stage.motion.peek();
    if (!shown?.imported) return;
    const { file, choices: chosen } = shown.imported;
    const before = state.readingAgain.peek() ?? state.refusedReading.peek()?.choices ?? chosen;
    const choices = change ? mergedChoices(before, change) : {};
    actions.setReadingAgain(choices);
    actions.setRefusedReading(null);
    try {
      await this.read({ name: shown.title, file, choices }, shown);
    } catch (error) {
      actions.setRefusedReading({ choices, message: messageOf(error) });
    } finally {
      if (state.readingAgain.peek() === choices) actions.setReadingAgain(null);
    }
  }

  /** What could not be read is given up: the choices are those of the motion on the stage. */
  keepReading(): void {
    this.context.files.actions.setRefusedReading(null);
  }

  /** Gives up the file being read; what is on the stage stays. */
  cancel(): void {
    this.reading?.abort(CANCELLED);
  }

  /**
   * A table or a scenario; done when it is on the stage or refused with a message.
   * @param choices of a file that was read before
   */
  async openFile(name: string, file: Blob, choices?: ImportChoices): Promise<void> {
    try {
      const kind = await kindOf(name, file);
      const isScenario = kind === 'scenario' || kind === 'system';
      const most = isScenario ? LARGEST_SCENARIO : LARGEST_TABLE;
      if (file.size > most)
        throw new Error(
          `${(file.size / 1e6).toFixed(0)} MB is more than the ${most / 1e6} MB this page reads${isScenario ? ' of a scenario' : '; export fewer rows or columns'}`,
        );
      if (kind === 'study') await this.readStudy(name, file);
      else if (kind === 'lesson') await this.readLesson(file);
      else if (kind === 'system') await this.readSystem(name, await file.text());
      else if (isScenario) await this.readScenario(name, await file.text());
      else await this.readTable(name, file, choices);
    } catch (error) {
      this.fail(name, [messageOf(error)]);
    }
  }

  /** A sweep's results open beside the stage; what is on it stays. */
  private async readStudy(name: string, file: Blob): Promise<void> {
    const { files, settings, metas } = this.context;
    const { readStudyFile } = await import('./studyFile.ts');
    this.reading?.abort();
    const { signal } = (this.reading = new AbortController());
    const onProgress = (share: number, rows: number): void => files.actions.setReading({ name, share, rows });
    try {
      files.actions.setStudy(await readStudyFile(name, file, metas, { signal, onProgress }));
    } catch (error) {
      if (!signal.aborted) throw error;
      // Results that gave way to another file are no one's concern.
      if (signal.reason === CANCELLED) this.tellUnread(name);
      return;
    } finally {
      if (this.reading.signal === signal) files.actions.setReading(null);
    }
    settings.actions.set('tool', 'study');
  }

  private tellUnread(name: string): void {
    const kept = ['What was on the stage is still there.'];
    this.context.messages.report('info', `${name} was not read to its end`, kept, undefined, 'opened');
  }

  /** A lesson opens beside the stage too. */
  private async readLesson(file: Blob): Promise<void> {
    const { files, settings } = this.context;
    const { lessonIn } = await import('./ownLesson.ts');
    files.actions.setLesson(await lessonIn(file));
    settings.actions.set('tool', 'lessons');
  }

  /** A description by itself: everything at its default. */
  private async readSystem(name: string, text: string): Promise<void> {
    const { meta } = await learnSystem(text.replace(/^\ufeff/, ''));
    this.run(name, 'system', meta.title, { version: 1, system: meta.id });
  }

  private async readScenario(name: string, text: string): Promise<void> {
    const scenario = await scenarioIn(text, this.context.metas);
    this.run(name, 'scenario', name.replace(/\.json$/i, ''), scenario);
  }

  private run(name: string, what: 'system' | 'scenario', title: string, scenario: ScenarioFile): void {
    const said = `The ${what} is in the panel and running.`;
    this.context.messages.report('info', `Opened ${name}`, [said], undefined, 'opened');
    this.context.openScenario(ownCase(title, scenario), scenario);
  }

  /** With what was chosen for files of its shape; asks first where it has to. */
  private async readTable(name: string, file: Blob, known?: ImportChoices): Promise<void> {
    const { csv, settings } = this.context;
    if (known) return this.read({ name, file, choices: known });
    const found = await csv.understand(file, {});
    if (found.kind === 'refused') return this.fail(name, [describe({ ...found, column: '' })]);
    const remembered = settings.state.imports.peek()?.[found.plan.shape] ?? {};
    // A step is offered, not taken: another file of the shape may have another.
    const { step: _, ...others } = remembered;
    const again = Object.keys(others).length > 0 ? await csv.understand(file, others) : found;
    const [choices, { questions }] = again.kind === 'plan' ? [remembered, again.plan] : [{}, found.plan];
    if (!this.ask({ name, file, choices }, questions)) await this.read({ name, file, choices });
  }

  /** Asks what comes before reading; says whether there is such a question. */
  private ask(table: Table, questions: readonly Question[]): boolean {
    const question = questions.find(({ first }) => first);
    if (!question) return false;
    this.waiting = table;
    this.context.files.actions.setPendingFile({ name: table.name, question: offering(question, table.choices) });
    return true;
  }

  /** @param shown the motion on the stage that this is another reading of */
  private async read({ name, file, choices }: Table, shown: Motion | null = null): Promise<void> {
    const { files, csv, stage } = this.context;
    this.reading?.abort();
    const { signal } = (this.reading = new AbortController());
    const show = (share: number, rows: number): void => {
      if (!signal.aborted) files.actions.setReading({ name, share, rows });
    };
    const reading = await csv.read(file, { choices, signal, onProgress: show }).finally(() => {
      if (this.reading?.signal === signal) files.actions.setReading(null);
    });
    if (!reading || signal.aborted) {
      // A reading that gave way to another is no one's concern.
      if (signal.reason === CANCELLED || !shown) this.tellUnread(name);
      return;
    }
    if (shown && stage.motion.peek()?.id !== shown.id) return;
    const { result } = reading;
    if (result.kind === 'unusable') {
      const most = result.issues.slice(0, 8).map(describe);
      if (shown) files.actions.setRefusedReading({ choices, message: most[0] ?? '' });
      else this.fail(name, [...most, ...(result.issues.length > 8 ? [`… and ${result.issues.length - 8} more`] : [])]);
      return;
    }
    if (result.kind === 'needs-time-step') {
      const found = await csv.understand(file, choices);
      if (found.kind === 'plan') this.ask({ name, file, choices }, found.plan.questions);
      return;
    }
    files.actions.setRefusedReading(null);
    // The worker has read its system, where the file brings one; here it is read for the stage.
    if (result.systemId !== null && !systemViews[result.systemId]) await learnSystemOf(result.scenario);
    this.showMotion({ name, file, choices }, result, reading, shown);
    this.remember(result.plan.shape, choices);
    files.opened.emit({ name, file, choices });
  }

  /** All but the run: another file of the shape holds others. */
  private remember(shape: string, { run: _, ...choices }: ImportChoices): void {
    const { state, actions } = this.context.settings;
    actions.set('imports', remembering(state.imports.peek(), shape, choices));
  }

  private showMotion(
    { name, file, choices }: Table,
    result: Extract<CsvResult, { kind: 'motion' }>,
    { scenario, judgement }: FileReading,
    again: Motion | null,
  ): void {
    const { stage, messages, show, showAgain } = this.context;
    const system = result.systemId === null ? dataViewOf(name, result) : systemViews[result.systemId]!;
    const trajectory = Trajectory.of(result.columns, result.data);
    trajectory.recorded = true;
    const shown = stage.motion.peek();
    const defaults = Object.fromEntries(system.meta.parameters.map((p) => [p.name, p.default]));
    const notes = result.notes.map((note) => ({ line: 0, column: '', message: note }));
    (again ? showAgain : show)({
      source: 'file',
      title: name,
      system,
      // A file that names its scenario is drawn with its proportions; another with those on the stage.
      parameters: scenario?.parameters ?? (shown?.system === system ? shown.parameters : defaults),
      trajectory,
      constraints: scenario?.constraints ?? null,
      scenario,
      written: scenario ? settled(result.scenario as ScenarioFile) : null,
      adjustments: [],
      issues: [...notes, ...result.issues],
      marks: [],
      // The rows may have left more open, or less, than the beginning.
      imported: { file, plan: { ...result.plan, questions: result.questions }, choices },
      judgement,
    });
    if (result.skippedRows > 0 && !again) {
      messages.report(
        'warning',
        `${name}: ${result.skippedRows} of ${result.rows + result.skippedRows} rows could not be used`,
        [...result.issues.slice(0, 3).map(describe), 'The rest plays; every row is listed with the file.'],
        undefined,
        'opened',
      );
    }
  }

  /** Pairs by base name; a lone half joins the half that is already in place. */
  private async openMeshes(files: readonly File[]): Promise<void> {
    const { files: own, stage, experiment, metas } = this.context;
    const next = new Map(own.state.meshes.peek());
    const shown = stage.motion.peek()?.system.meta;
    const meta = shown && shown.bodies.length > 0 ? shown : metas[experiment.draft.peek().system]!;
    const names = modelsOf(meta);
    for (const file of files) {
      const [, base = '', ending = ''] = /^(.*)\.(mdl|mat)$/i.exec(file.name.toLowerCase()) ?? [];
      if (!names.includes(base)) {
        this.fail(file.name, [
          `no body of ${meta.title} has that name; right would be ${names.map((n) => `${n}.mdl with ${n}.mat`).join(', ')}`,
        ]);
        continue;
      }
      const key = `${meta.id}/${base}`;
      next.set(key, { ...next.get(key), [ending === 'mdl' ? 'mdl' : 'mat']: await file.text() });
    }
    own.actions.setMeshes(next);
  }

  private fail(name: string, details: readonly string[]): void {
    this.context.messages.report('error', `${name} could not be opened`, [
      ...details,
      'What was on the stage is still there.',
    ]);
  }
}

/** Why a reading ended, when the person ended it. */
const CANCELLED = 'cancelled';

/** What was answered for such a file before is offered again. */
function offering(question: Question, { step }: ImportChoices): Question {
  const offered = question.answers[question.safest]!;
  if (question.id !== 'time-step' || step === undefined) return question;
  return { ...question, answers: [{ ...offered, choices: { step } }], safest: 0 };
}

/** Columns under their own names, in the units that they were read into. */
function dataViewOf(name: string, { columns, plan }: Extract<CsvResult, { kind: 'motion' }>): SystemView {
  const planned = new Map(plan.columns.flatMap((column) => (column.name === null ? [] : [[column.name, column]])));
  return dataView(
    name,
    columns
      .filter((column) => column !== 't')
      .map((column) => {
        const own = planned.get(column);
        return { name: column, label: own?.source ?? column, unit: own ? siUnit(own.kind, own.unit) : '' };
      }),
  );
}

const SI: Readonly<Partial<Record<Kind, string>>> = {
  time: 's',
  length: 'm',
  angle: 'rad',
  'length rate': 'm/s',
  'angle rate': 'rad/s',
};

/** A number without a unit stays one. */
const siUnit = (kind: Kind, unit: string): string => (unit === '' ? '' : (SI[kind] ?? unit));

function describe(issue: FileIssue): string {
  const { line, to } = issue;
  const lines = line === 0 ? '' : to === undefined ? `line ${line}` : `lines ${line} to ${to}`;
  const place = [lines, issue.column ? `column ${issue.column}` : ''].filter(Boolean).join(', ');
  return place ? `${place}: ${issue.message}` : issue.message;
}

function messageOf(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}
