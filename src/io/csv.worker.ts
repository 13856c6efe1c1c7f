import type { SystemMeta } from '../core/systems/types.ts';
import { readCsv, writeCsv, type CsvResult } from './csv.ts';

/** Reading and writing large files off the main thread. Columns are transferred. */
export type CsvRequest =
  | { type: 'read'; id: number; text: string; systems: Readonly<Record<string, SystemMeta>>; timeStep?: number }
  | { type: 'write'; id: number; columns: string[]; data: Float64Array[]; comments: string[] };

export type CsvReply =
  | { type: 'read'; id: number; result: CsvResult }
  | { type: 'written'; id: number; text: string }
  | { type: 'failed'; id: number; message: string };

const port = self as unknown as { postMessage(message: CsvReply, transfer?: Transferable[]): void };

self.addEventListener('message', ({ data }: MessageEvent<CsvRequest>) => {
  try {
    if (data.type === 'write') {
      port.postMessage({ type: 'written', id: data.id, text: writeCsv(data.columns, data.data, data.comments) });
      return;
    }
    const result = readCsv(data.text, { systems: data.systems, timeStep: data.timeStep });
    const transfer = result.kind === 'motion' ? result.data.map((column) => column.buffer as ArrayBuffer) : [];
    port.postMessage({ type: 'read', id: data.id, result }, transfer);
  } catch (error) {
    port.postMessage({ type: 'failed', id: data.id, message: error instanceof Error ? error.message : String(error) });
  }
});
