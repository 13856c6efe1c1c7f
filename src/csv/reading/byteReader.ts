import type { CsvOptions, CsvResult } from './result.ts';
import { CsvReader } from './textReader.ts';
import { sniff } from '../containers/sniff.ts';
import { encodingOf } from '../encoding/encoding.ts';
import { LONGEST_LINE } from '../layout/lines.ts';
import { ENOUGH_TO_DECIDE } from '../understand.ts';
import { DecimalReader } from './decimal.ts';

const [LF, CR, SPACE, QUOTE] = [10, 13, 32, 34] as const;
/** Bytes by which the encoding is known. */
const SAMPLE = 65536;
const NOTHING = new Uint8Array(0);

/**
 * Reads a CSV file from its bytes, given in pieces. Lines that hold a number in every cell, nearly all of a large file,
 * go straight into columns; everything else (header, comments, quotes, gaps, mistakes) goes through `CsvReader`, which
 * also decides what the columns mean. Either way gives the same result.
 */
export class CsvByteReader {
  private reader: CsvReader;
  private readonly options: CsvOptions;
  private refused: string | null = null;
  private readonly decimal = new DecimalReader();
  private decoder: TextDecoder | null = null;
  /** Bytes of a line that is not whole yet. */
  private rest: Uint8Array = NOTHING;
  /** Another encoding or lone CRs: all of it goes the long way. */
  private textOnly = false;
  private readonly size: number;
  private taken = 0;
  private values = new Float64Array(0);

  /** @param size of the whole file in bytes, where it is known: room for its rows is then made at once */
  constructor(options: CsvOptions, size = 0) {
    this.options = options;
    this.reader = new CsvReader(options);
    this.size = size;
  }

  /** Rows so far. */
  get rows(): number {
    return this.reader.rows;
  }

  /** Nothing more will be used. */
  get ended(): boolean {
    return this.reader.over || this.refused !== null;
  }

  push(piece: Uint8Array): void {
    if (this.ended || piece.length === 0) return;
    this.taken += piece.length;
    if (this.reader.rows > 0) this.reader.expect((1.02 * this.reader.rows * this.size) / this.taken);
    if (this.textOnly) return this.reader.push(this.decoder!.decode(piece, { stream: true }));
    const bytes = this.rest.length > 0 ? joined(this.rest, piece) : piece;
    if (!this.decoder && bytes.length < SAMPLE) this.rest = bytes.slice();
    else this.take(bytes);
  }

  finish(): CsvResult {
    const { rest } = this;
    if (!this.decoder) this.take(rest);
    if (this.refused !== null) return { kind: 'unusable', issues: [{ line: 0, column: '', message: this.refused }] };
    if (!this.textOnly) this.long(this.rest);
    this.reader.push(this.decoder!.decode());
    return this.reader.finish();
  }

  private take(bytes: Uint8Array): void {
    if (!this.decoder) {
      const container = sniff(bytes);
      if (container.kind === 'gzip') this.refused = 'this is a gzip archive; unpack it first';
      if (container.kind === 'refused') this.refused = container.message;
      const encoding = this.options.choices?.encoding ?? encodingOf(bytes);
      if (encoding !== 'utf-8') this.reader = new CsvReader(this.options, encoding);
      this.decoder = new TextDecoder(encoding);
      this.textOnly = encoding !== 'utf-8';
    }
    if (this.refused !== null) return;
    this.rest = NOTHING;
    if (this.textOnly) return this.long(bytes);
    const end = bytes.lastIndexOf(LF) + 1;
    this.lines(bytes, end);
    const rest = bytes.subarray(end);
    if (this.textOnly || rest.length > LONGEST_LINE) this.long(rest);
    else this.rest = rest.slice();
  }

  /** Whole lines: the plain ones here, runs of others by the reader. */
  private lines(bytes: Uint8Array, end: number): void {
    for (let at = 0; at < end;) {
      const next = this.reader.decided ? this.plainLines(bytes, at, end) : at;
      if (next >= end) return;
      // Before the columns are known all of it, else the one line that is not plain; a quoted cell may reach over lines.
      const line = bytes.indexOf(LF, this.reader.decided ? next : Math.min(next + ENOUGH_TO_DECIDE, end - 1)) + 1;
      this.textOnly = loneReturn(bytes, next, line);
      at = this.textOnly || includes(bytes, QUOTE, next, line) ? end : line;
      this.long(bytes.subarray(next, at));
      if (this.reader.over) return;
    }
  }

  private long(bytes: Uint8Array): void {
    this.reader.push(this.decoder!.decode(bytes, { stream: true }));
  }

  /** @returns where the first line begins that is not plain, or `end` */
  private plainLines(bytes: Uint8Array, from: number, end: number): number {
    const { reader, decimal } = this;
    const plan = reader.plan();
    if (!plan) return from;
    const { separator, width } = plan;
    if (this.values.length !== width) this.values = new Float64Array(width);
    const { values } = this;
    let start = from;
    while (start < end) {
      let i = start;
      for (let cell = 0; cell < width; cell++) {
        while (bytes[i] === SPACE) i++;
        const value = decimal.read(bytes, i, end);
        if (value !== value) return start;
        values[cell] = value;
        i = decimal.at;
        while (bytes[i] === SPACE) i++;
        if (cell + 1 < width) {
          if (bytes[i] !== separator) return start;
          i++;
        }
      }
      if (bytes[i] === CR) i++;
      if (bytes[i] !== LF) return start;
      reader.numbers(values);
      start = i + 1;
    }
    return end;
  }
}

function joined(a: Uint8Array, b: Uint8Array): Uint8Array {
  const both = new Uint8Array(a.length + b.length);
  both.set(a);
  both.set(b, a.length);
  return both;
}

function includes(bytes: Uint8Array, byte: number, from: number, to: number): boolean {
  for (let i = from; i < to; i++) if (bytes[i] === byte) return true;
  return false;
}

function loneReturn(bytes: Uint8Array, from: number, to: number): boolean {
  for (let i = from; i < to; i++) if (bytes[i] === CR && bytes[i + 1] !== LF) return true;
  return false;
}
