/** The bytes of a file, unpacked where they are gzip's. The first piece of what comes may be of any length. */
export function unpacked(
  stream: ReadableStream<Uint8Array<ArrayBuffer>>,
  packed: boolean,
): ReadableStream<Uint8Array<ArrayBuffer>> {
  return packed ? stream.pipeThrough(new DecompressionStream('gzip')) : stream;
}
