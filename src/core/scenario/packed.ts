/** Text packed for a link: DEFLATE (RFC 1951) of its UTF-8, in the letters of base64url (RFC 4648, 5), which addresses carry unchanged. */
import { deflateSync, Inflate, strFromU8, strToU8 } from 'fflate';

const LETTERS = 'ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_';

/**
 * Text in fewer characters, of letters, digits, `-` and `_` alone.
 *
 * @param text any
 */
export function packText(text: string): string {
  const bytes = deflateSync(strToU8(text), { level: 9 });
  let packed = '';
  for (let i = 0; i < bytes.length; i += 3) {
    const [a, b, c] = [bytes[i]!, bytes[i + 1], bytes[i + 2]];
    packed += LETTERS[a >> 2]! + LETTERS[((a & 3) << 4) | ((b ?? 0) >> 4)]!;
    if (b !== undefined) packed += LETTERS[((b & 15) << 2) | ((c ?? 0) >> 6)]!;
    if (c !== undefined) packed += LETTERS[c & 63]!;
  }
  return packed;
}

/**
 * The text again.
 *
 * @param packed by `packText`
 * @param most bytes that it may have: unpacking stops there, whatever the packed text promises
 * @throws Error that says in words what is wrong with it
 */
export function unpackText(packed: string, most: number): string {
  const parts: Uint8Array[] = [];
  let size = 0;
  let done = false;
  const inflate = new Inflate((part, last) => {
    size += part.length;
    if (size > most) throw new RangeError(`unpacks to more than ${most} bytes`);
    parts.push(part.slice());
    done = last;
  });
  try {
    const bytes = bytesOf(packed);
    // A little at a time, so that no more than a window beyond `most` is ever unpacked.
    for (let i = 0; i < bytes.length; i += 64) inflate.push(bytes.subarray(i, i + 64), i + 64 >= bytes.length);
  } catch (error) {
    if (error instanceof RangeError) throw error;
    throw new Error('is not whole; the link was cut or changed on its way', { cause: error });
  }
  if (!done) throw new Error('is not whole; the link was cut or changed on its way');
  const all = new Uint8Array(size);
  let at = 0;
  for (const part of parts) {
    all.set(part, at);
    at += part.length;
  }
  return strFromU8(all);
}

function bytesOf(packed: string): Uint8Array {
  const bytes = new Uint8Array(Math.floor((packed.length * 3) / 4));
  let [bits, held, at] = [0, 0, 0];
  for (const letter of packed) {
    const six = LETTERS.indexOf(letter);
    if (six < 0) throw new Error(`${letter} is no letter of a packed text`);
    bits = ((bits << 6) | six) & 0xffffff;
    held += 6;
    if (held >= 8) {
      held -= 8;
      bytes[at++] = (bits >> held) & 255;
    }
  }
  return bytes;
}
