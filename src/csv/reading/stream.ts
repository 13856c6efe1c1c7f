import { unpacked } from '../containers/gzip.ts';
import { jsonTable, whyNoTable } from '../containers/json.ts';
import { sniff } from '../containers/sniff.ts';
import type { Understanding } from '../plan.ts';
import { ENOUGH_TO_DECIDE, understand, understandText, type UnderstandOptions } from '../understand.ts';
import { CsvByteReader } from './byteReader.ts';
import type { CsvOptions, CsvResult } from './result.ts';
import { CsvReader } from './textReader.ts';

export type Bytes = ReadableStream<Uint8Array<ArrayBuffer>>;

/** JSON is read as a whole: more of it would not be held. */
const LARGEST_JSON = 300e6;
/** Bytes by which a container is known. */
const ENOUGH_TO_KNOW = 512;

export interface StreamOptions extends CsvOptions {
  /** Of the file in bytes, where it is known. */
  size?: number;
  /** After each piece: bytes and rows so far. True: no more is wanted. */
  after?: (bytes: number, rows: number) => boolean | Promise<boolean>;
}

/** Reads a file of any kind that is understood, piece by piece: of it no more is in memory than one piece and its numbers. */
export async function readStream(stream: Bytes, options: StreamOptions): Promise<CsvResult> {
  const opened = await open(stream);
  const { after = () => false, size = 0 } = options;
  if (opened.json) {
    const text = await textOf(opened.pieces, LARGEST_JSON);
    const table = text === null ? null : jsonTable(text);
    if (table === null) return refusal(whyNoJson(text));
    const reader = new CsvReader(options);
    for (let at = 0; at < table.length; at += 1 << 20) reader.push(table.slice(at, at + (1 << 20)));
    return reader.finish();
  }
  const reader = new CsvByteReader(options, opened.packed ? 0 : size);
  let [bytes, damage] = [0, ''];
  try {
    for (let piece; (piece = await opened.pieces.next());) {
      reader.push(piece);
      bytes += piece.length;
      const stop = reader.ended || after(bytes, reader.rows);
      if (stop === true || (stop !== false && (await stop))) break;
    }
    await opened.pieces.cancel();
  } catch (error) {
    if (!opened.packed) throw error;
    damage = 'the gzip archive is damaged or cut: what was before is read';
  }
  const result = reader.finish();
  if (damage && result.kind === 'motion') result.notes.push(damage);
  if (damage && result.kind === 'unusable')
    return refusal('this gzip archive is damaged: nothing of it could be unpacked');
  return result;
}

/** What a file is understood as, from as little of it as decides that. */
export async function understandStream(stream: Bytes, options: UnderstandOptions): Promise<Understanding> {
  const opened = await open(stream);
  if (opened.json) {
    const text = await textOf(opened.pieces, LARGEST_JSON);
    const table = text === null ? null : jsonTable(text);
    return table === null
      ? { kind: 'refused', line: 0, message: whyNoJson(text) }
      : understandText(table.slice(0, table.indexOf('\n', ENOUGH_TO_DECIDE) + 1 || table.length), 'utf-8', options);
  }
  const parts: Uint8Array[] = [];
  let length = 0;
  try {
    for (let piece; length < 2 * ENOUGH_TO_DECIDE && (piece = await opened.pieces.next());) {
      parts.push(piece);
      length += piece.length;
    }
    await opened.pieces.cancel();
  } catch (error) {
    if (!opened.packed) throw error;
  }
  return understand(joined(parts), options);
}

/** Bytes of a file's end that may hold its scenario. */
export const ENDING = 250_000;

/** The scenario behind a table, as it was written, from the last bytes of its file; null where there is none. */
export function scenarioIn(ending: Uint8Array): unknown {
  const json = /^#\s*scenario:\s*(\{.*\})\s*$/m.exec(new TextDecoder().decode(ending))?.[1];
  if (json === undefined) return null;
  try {
    return JSON.parse(json);
  } catch {
    return null;
  }
}

/** No generator: a large file has a thousand pieces. */
interface Pieces {
  /** The next piece, or undefined at the end. */
  next(): Promise<Uint8Array<ArrayBuffer> | undefined>;
  cancel(): Promise<void>;
}

interface Opened {
  pieces: Pieces;
  packed: boolean;
  json: boolean;
}

async function open(stream: Bytes): Promise<Opened> {
  const reader = stream.getReader();
  const first: Uint8Array<ArrayBuffer>[] = [];
  for (let length = 0; length < ENOUGH_TO_KNOW;) {
    const { value } = await reader.read();
    if (!value) break;
    first.push(value);
    length += value.length;
  }
  const start = joined(first);
  const packed = sniff(start).kind === 'gzip';
  const whole = piecesOf(reader, first);
  if (!packed) return { pieces: whole, packed, json: isJson(start) };
  try {
    return { ...(await open(unpacked(streamOf(whole), true))), packed };
  } catch (error) {
    return { pieces: { next: () => Promise.reject(error as Error), cancel: async () => {} }, packed, json: false };
  }
}

function isJson(start: Uint8Array): boolean {
  const text = new TextDecoder('utf-8')
    .decode(start.subarray(0, ENOUGH_TO_KNOW))
    .replace(/^\ufeff/, '')
    .trimStart();
  return /^(?:\{\s*"|\[\s*[[{])/.test(text);
}

function piecesOf(
  reader: ReadableStreamDefaultReader<Uint8Array<ArrayBuffer>>,
  first: Uint8Array<ArrayBuffer>[],
): Pieces {
  const rest = async (): Promise<Uint8Array<ArrayBuffer> | undefined> => (await reader.read()).value;
  return {
    next: () => (first.length > 0 ? Promise.resolve(first.shift()) : rest()),
    cancel: () => reader.cancel().catch(() => undefined),
  };
}

function streamOf(pieces: Pieces): Bytes {
  return new ReadableStream({
    async pull(controller) {
      const piece = await pieces.next();
      if (piece) controller.enqueue(piece);
      else controller.close();
    },
    cancel: () => pieces.cancel(),
  });
}

async function textOf(pieces: Pieces, most: number): Promise<string | null> {
  const decoder = new TextDecoder();
  let [text, length] = ['', 0];
  for (let piece; (piece = await pieces.next());) {
    length += piece.length;
    if (length > most) {
      await pieces.cancel();
      return null;
    }
    text += decoder.decode(piece, { stream: true });
  }
  return text + decoder.decode();
}

function joined(parts: readonly Uint8Array[]): Uint8Array {
  const whole = new Uint8Array(parts.reduce((length, part) => length + part.length, 0));
  let at = 0;
  for (const part of parts) {
    whole.set(part, at);
    at += part.length;
  }
  return whole;
}

const whyNoJson = (text: string | null): string =>
  text === null ? `this JSON is larger than ${LARGEST_JSON / 1e6} MB; write it as CSV` : whyNoTable(text);

function refusal(message: string): CsvResult {
  return { kind: 'unusable', issues: [{ line: 0, column: '', message }] };
}
