import { written } from '../../core/scenario/own.ts';
import { systemMetas } from '../../core/systems/registry.ts';
import type { CsvClient } from '../../compute/client/csvClient.ts';
import { download } from './download.ts';
import { pushComments } from '../push/pushRecorder.ts';
import type { StageState } from '../runs/stageState.ts';
import type { RunTrust, TrustState } from '../runs/trust.ts';
import { trustSentence } from '../../core/simulation/trust.ts';
import type { MessageActions } from '../state/messages.ts';
import type { FileActions } from './fileState.ts';

/** The motion on the stage as a CSV file: a long one part by part, with its share on the page, until it is cancelled. */
export class CsvExport {
  private readonly stage: StageState & TrustState;
  private readonly files: FileActions;
  private readonly csv: CsvClient;
  private readonly messages: MessageActions;
  private going: AbortController | null = null;

  constructor(stage: StageState & TrustState, files: FileActions, csv: CsvClient, messages: MessageActions) {
    this.stage = stage;
    this.files = files;
    this.csv = csv;
    this.messages = messages;
  }

  /** One at a time: an export under way gives way to this one. */
  async write(): Promise<void> {
    const { stage, files, messages } = this;
    const motion = stage.motion.peek();
    if (!motion || motion.trajectory.length === 0) {
      messages.report('warning', 'Nothing to export', ['Run a scenario or open a file first.']);
      return;
    }
    this.cancel();
    const { signal } = (this.going = new AbortController());
    const name = `${
      motion.title
        .replace(/\.csv$/i, '')
        .replace(/[^\w-]+/g, '-')
        .replace(/^-|-$/g, '')
        .toLowerCase() || 'run'
    }.csv`;
    const comments = motion.scenario
      ? [
          `scenario: ${JSON.stringify(written(motion.written ?? motion.scenario, systemMetas))}`,
          ...(motion.engine ? [`engine: ${motion.engine}`] : []),
          ...pushComments(motion),
          ...trustComments(stage.trust.peek()),
        ]
      : [];
    const onProgress = (share: number): void => {
      if (!signal.aborted && share < 1) files.setWriting({ name, share });
    };
    try {
      const parts = await this.csv.write(motion.trajectory, comments, { onProgress, signal });
      if (parts) download(name, parts, 'text/csv');
    } catch (error) {
      messages.report('error', 'The CSV file was not written', [
        error instanceof Error ? error.message : String(error),
        'The run is still on the page.',
      ]);
    } finally {
      if (this.going?.signal === signal) files.setWriting(null);
    }
  }

  cancel(): void {
    this.going?.abort();
    this.files.setWriting(null);
  }
}

const trustComments = (known: RunTrust | null): string[] =>
  known?.kind === 'compared' ? [`trust: ${trustSentence(known.trust)}`] : [];
