/** A run shorter than this (ms) says nothing of itself. */
const SILENT_MS = 1000;
/** Between two lines, ms. */
const TELL_MS = 250;

export interface Progress {
  tell(time: number, duration: number, rows: number): void;
  clear(): void;
}

/**
 * How far a long run is, on one line of a terminal.
 * @param free the terminal shows nothing else meanwhile
 */
export function progressLine(free: boolean): Progress {
  if (!process.stderr.isTTY || !free) return { tell: () => {}, clear: () => {} };
  const began = performance.now();
  let told = began + SILENT_MS - TELL_MS;
  let shown = false;
  return {
    tell(time, duration, rows) {
      if (performance.now() < told + TELL_MS) return;
      told = performance.now();
      shown = true;
      const share = Math.floor((100 * time) / duration);
      process.stderr.write(`\r\x1b[Kcomputing: ${share} %, t = ${time.toFixed(3)} of ${duration} s, ${rows} rows`);
    },
    clear() {
      if (shown) process.stderr.write('\r\x1b[K');
    },
  };
}
