import { conceptsIn, isTimePhrase } from '../names/phrases.ts';
import type { Encoding } from '../plan.ts';
import { isUnit } from '../units/units.ts';

/** Bytes looked at. */
const SAMPLE = 65536;
/** Share of zeros in every second byte from which text is taken for UTF-16. */
const MANY = 0.4;
const FEW = 0.02;

/**
 * By the byte order mark; without one UTF-16 shows in zeros at every second byte, and the rest is UTF-8, or, where that
 * fails, what older programs write in the language whose words it then shows, Western without any.
 */
export function encodingOf(start: Uint8Array): Encoding {
  if (start[0] === 0xff && start[1] === 0xfe) return 'utf-16le';
  if (start[0] === 0xfe && start[1] === 0xff) return 'utf-16be';
  const zeros = [0, 0];
  const length = Math.min(start.length, 4096) & ~1;
  for (let i = 0; i < length; i++) if (start[i] === 0) zeros[i & 1]!++;
  const [even, odd] = zeros.map((count) => count / (length / 2 || 1)) as [number, number];
  if (odd > MANY && even < FEW) return 'utf-16le';
  if (even > MANY && odd < FEW) return 'utf-16be';
  try {
    // A character may be cut at the end of the sample.
    new TextDecoder('utf-8', { fatal: true }).decode(start.subarray(0, SAMPLE), { stream: true });
    return 'utf-8';
  } catch {
    return olderEncodingOf(start);
  }
}

/** Tried where a file is neither UTF-8 nor UTF-16; most of Europe writes the first. */
const OLDER: readonly Encoding[] = ['windows-1252', 'windows-1251', 'windows-1250', 'shift_jis', 'gb18030', 'euc-kr'];
const HEAD = 4096;
const NOT_ASCII = /[^\0-\u007f]/;

/** The one in which most names and units of the first lines are known words. */
function olderEncodingOf(start: Uint8Array): Encoding {
  let best: { encoding: Encoding; known: number } = { encoding: 'windows-1252', known: 0 };
  for (const encoding of OLDER) {
    const cells = new TextDecoder(encoding)
      .decode(start.subarray(0, HEAD))
      .split(/[,;|\t\n\r"()[\]]/)
      .map((cell) => cell.trim())
      .filter((cell) => cell !== '' && NOT_ASCII.test(cell))
      .slice(0, 60);
    const known = cells.filter((cell) => conceptsIn(cell) !== null || isTimePhrase(cell) || isUnit(cell)).length;
    if (known > best.known) best = { encoding, known };
  }
  return best.encoding;
}
