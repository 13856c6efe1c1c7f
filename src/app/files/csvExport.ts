import type { CsvClient } from '../../compute/client/csvClient.ts';
import { download } from './download.ts';
import type { Messages } from '../state/messages.ts';
import { pushComments } from '../push/pushRecorder.ts';
import type { AppState } from '../types.ts';

/** The motion on the stage as a CSV file: a long one part by part, with its share on the page, until it is cancelled. */
export class CsvExport {
  private readonly state: AppState;
  private readonly csv: CsvClient;
  private readonly messages: Messages;
  private going: AbortController | null = null;

  constructor(state: AppState, csv: CsvClient, messages: Messages) {
    this.state = state;
    this.csv = csv;
    this.messages = messages;
  }

  /** One at a time: an export under way gives way to this one. */
  async write(): Promise<void> {
    const { state, messages } = this;
    const motion = state.motion.peek();
    if (!motion || motion.trajectory.length === 0) {
      messages.add('warning', 'Nothing to export', ['Run a scenario or open a file first.']);
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
      ? [`scenario: ${JSON.stringify(motion.written ?? motion.scenario)}`, ...pushComments(motion)]
      : [];
    const onProgress = (share: number): void => {
      if (!signal.aborted && share < 1) state.writing.value = { name, share };
    };
    try {
      const parts = await this.csv.write(motion.trajectory, comments, { onProgress, signal });
      if (parts) download(name, parts, 'text/csv');
    } catch (error) {
      messages.add('error', 'The CSV file was not written', [
        error instanceof Error ? error.message : String(error),
        'The run is still on the page.',
      ]);
    } finally {
      if (this.going?.signal === signal) state.writing.value = null;
    }
  }

  cancel(): void {
    this.going?.abort();
    this.state.writing.value = null;
  }
}
