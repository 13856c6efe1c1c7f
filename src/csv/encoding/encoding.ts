import type { Encoding } from '../plan.ts';

/** Bytes looked at. */
const SAMPLE = 65536;
/** Share of zeros in every second byte from which text is taken for UTF-16. */
const MANY = 0.4;
const FEW = 0.02;

/**
 * By the byte order mark; without one UTF-16 shows in zeros at every second byte, and the rest is UTF-8, or, where that
 * fails, what Windows writes (a superset of Latin-1).
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
    return 'windows-1252';
  }
}
