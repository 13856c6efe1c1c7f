import { modelsOf } from '../../core/model/system.ts';
import { parseScenario } from '../../core/scenario/schema.ts';
import type { SystemMeta } from '../../core/model/system.ts';
import { systemViews } from '../../core/systems/registry.ts';
import { Trajectory } from '../../core/motion/trajectory.ts';
import type { ScenarioFile } from '../../core/scenario/types.ts';
import type { CsvResult } from '../../csv/csv.ts';
import type { FileReading } from '../../compute/services/csvTypes.ts';
import type { CsvClient } from '../../compute/client/csvClient.ts';
import type { Motion } from '../runs/motion.ts';
import type { StageState } from '../runs/stageState.ts';
import { ownCase, type CaseInfo } from '../state/cases.ts';
import type { ExperimentState } from '../state/experiment.ts';
import type { MessageActions } from '../state/messages.ts';
import type { FileSlice } from './fileState.ts';
import type { SampleInfo } from './samples.ts';

interface Context {
  files: FileSlice;
  stage: StageState;
  experiment: ExperimentState;
  csv: CsvClient;
  messages: MessageActions;
  metas: Readonly<Record<string, SystemMeta>>;
  show(motion: Omit<Motion, 'id'>): void;
  openScenario(origin: CaseInfo, scenario: ScenarioFile): void;
}

/** Larger files are refused by name and size; what a table holds is limited by the reader (`MOST_NUMBERS`). */
const LARGEST_TABLE = 2e9;
const LARGEST_SCENARIO = 5e6;

/** Opens dropped and chosen files; whatever is wrong with one leaves what is on the stage untouched. */
export class FileOpener {
  private readonly context: Context;
  private waiting: { name: string; file: Blob } | null = null;
  private reading: AbortController | null = null;

  constructor(context: Context) {
    this.context = context;
  }

  async open(files: readonly File[]): Promise<void> {
    const meshes = files.filter((f) => /\.(mdl|mat)$/i.test(f.name));
    if (meshes.length > 0) await this.openMeshes(meshes);
    for (const file of files.filter((f) => !meshes.includes(f))) await this.openFile(file.name, file);
  }

  async openSample(id: string, samples: readonly SampleInfo[]): Promise<void> {
    const sample = samples.find((s) => s.id === id);
    if (!sample) return;
    try {
      const response = await fetch(sample.url);
      if (!response.ok) throw new Error(`the server answered ${response.status}`);
      await this.readMotion(sample.title, await response.blob());
    } catch (error) {
      this.fail(sample.title, [messageOf(error)]);
    }
  }

  answerTimeStep(step: number | null): void {
    const { waiting, context } = this;
    this.waiting = null;
    context.files.actions.setPendingFile(null);
    if (waiting && step !== null)
      void this.readMotion(waiting.name, waiting.file, step).catch((error: unknown) =>
        this.fail(waiting.name, [messageOf(error)]),
      );
  }

  /** Gives up the file being read; what is on the stage stays. */
  cancel(): void {
    this.reading?.abort();
  }

  /**
   * A CSV or a scenario; done when it is on the stage or refused with a message.
   * @param timeStep of a file without a header, if it is known (s)
   */
  async openFile(name: string, file: Blob, timeStep?: number): Promise<void> {
    try {
      const start = await file.slice(0, 200).text();
      const isScenario = /\.json$/i.test(name) || (/^\s*\{/.test(start) && !/\.(csv|txt|tsv)$/i.test(name));
      const most = isScenario ? LARGEST_SCENARIO : LARGEST_TABLE;
      if (file.size > most)
        throw new Error(
          `${(file.size / 1e6).toFixed(0)} MB is more than the ${most / 1e6} MB this page reads${isScenario ? ' of a scenario' : '; export fewer rows or columns'}`,
        );
      if (isScenario) this.readScenario(name, await file.text());
      else await this.readMotion(name, file, timeStep);
    } catch (error) {
      this.fail(name, [messageOf(error)]);
    }
  }

  private readScenario(name: string, text: string): void {
    parseScenario(text, this.context.metas);
    const scenario = JSON.parse(text.replace(/^\ufeff/, '')) as ScenarioFile;
    this.context.messages.report('info', `Opened ${name}`, ['The scenario is in the panel and running.']);
    this.context.openScenario(ownCase(name.replace(/\.json$/i, ''), scenario), scenario);
  }

  private async readMotion(name: string, file: Blob, timeStep?: number): Promise<void> {
    const { files, csv, messages } = this.context;
    this.reading?.abort();
    const { signal } = (this.reading = new AbortController());
    const show = (share: number, rows: number): void => {
      if (!signal.aborted) files.actions.setReading({ name, share, rows });
    };
    const reading = await csv.read(file, { timeStep, signal, onProgress: show }).finally(() => {
      if (this.reading?.signal === signal) files.actions.setReading(null);
    });
    if (!reading || signal.aborted) {
      messages.report('info', `${name} was not read to its end`, ['What was on the stage is still there.']);
      return;
    }
    const { result } = reading;
    if (result.kind === 'needs-time-step') {
      this.waiting = { name, file };
      files.actions.setPendingFile({ name, offeredStep: result.offeredStep });
      return;
    }
    if (result.kind === 'unusable') {
      this.fail(name, [
        ...result.issues.slice(0, 8).map(describe),
        ...(result.issues.length > 8 ? [`… and ${result.issues.length - 8} more`] : []),
      ]);
      return;
    }
    this.showMotion(name, result, reading);
    files.opened.emit({ name, file, ...(timeStep === undefined ? {} : { timeStep }) });
  }

  private showMotion(
    name: string,
    result: Extract<CsvResult, { kind: 'motion' }>,
    { scenario, judgement }: FileReading,
  ): void {
    const { stage, messages } = this.context;
    const system = systemViews[result.systemId ?? '']!;
    const trajectory = Trajectory.of(result.columns, result.data);
    trajectory.recorded = true;
    const shown = stage.motion.peek();
    const defaults = Object.fromEntries(system.meta.parameters.map((p) => [p.name, p.default]));
    const notes = result.notes.map((note) => ({ line: 0, column: '', message: note }));
    this.context.show({
      source: 'file',
      title: name,
      system,
      // A file that names its scenario is drawn with its proportions; another with those on the stage.
      parameters: scenario?.parameters ?? (shown?.system === system ? shown.parameters : defaults),
      trajectory,
      constraints: scenario?.constraints ?? null,
      scenario,
      written: scenario ? (result.scenario as ScenarioFile) : null,
      adjustments: [],
      issues: [...notes, ...result.issues],
      marks: [],
      judgement,
    });
    if (result.skippedRows > 0) {
      messages.report(
        'warning',
        `${name}: ${result.skippedRows} of ${result.rows + result.skippedRows} rows could not be used`,
        [...result.issues.slice(0, 3).map(describe), 'The rest plays; every row is listed with the file.'],
      );
    }
  }

  /** Pairs by base name; a lone half joins the half that is already in place. */
  private async openMeshes(files: readonly File[]): Promise<void> {
    const { files: own, stage, experiment, metas } = this.context;
    const next = new Map(own.state.meshes.peek());
    const meta = stage.motion.peek()?.system.meta ?? metas[experiment.draft.peek().system]!;
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

function describe(issue: { line: number; column: string; message: string }): string {
  const place = [issue.line > 0 ? `line ${issue.line}` : '', issue.column ? `column ${issue.column}` : '']
    .filter(Boolean)
    .join(', ');
  return place ? `${place}: ${issue.message}` : issue.message;
}

function messageOf(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}
