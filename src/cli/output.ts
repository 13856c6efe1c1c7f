import {
  chmodSync,
  closeSync,
  fstatSync,
  openSync,
  realpathSync,
  renameSync,
  rmSync,
  statSync,
  writeSync,
} from 'node:fs';
import { basename, dirname, join } from 'node:path';
import { UsageError, pathOf } from './usage.ts';

/** Where a run's table goes. Every failure to write is one line. */
export interface Output {
  /** @throws UsageError */
  write(content: string | Uint8Array): void;
  /** All is written: it takes the place of what stood there. @throws UsageError */
  finish(): void;
  /** What stood there stays. */
  discard(): void;
}

/**
 * Standard output, or a file that takes its place only when all of it is written, so that a run that fails or is
 * interrupted destroys nothing.
 *
 * @param out as typed; undefined: standard output
 * @param scenario as typed, `-` for standard input: never written over, by whatever name or link
 * @throws UsageError
 */
export function openOutput(out: string | undefined, scenario: string): Output {
  if (out === undefined) return direct(1, 'standard output');
  let path = pathOf(out);
  const there = attempt(() => statSync(path));
  if (there && isSame(there, scenario))
    throw new UsageError(`--out ${out} is the scenario itself: name another file for the run`);
  // A device or a pipe is written to, not replaced; a link stays a link.
  if (there && !there.isFile()) return direct(open(out, path, 'w'), out);
  path = attempt(() => realpathSync(path)) ?? path;
  const unfinished = join(dirname(path), `.${basename(path)}.${process.pid}.part`);
  const file = open(out, unfinished, 'wx', there && there.mode & 0o777);
  const { write } = direct(file, out);
  const discard = (): void => {
    closeSync(file);
    rmSync(unfinished, { force: true });
  };
  return {
    write,
    discard,
    finish() {
      told(out, () => {
        closeSync(file);
        if (there) chmodSync(unfinished, there.mode & 0o777);
        renameSync(unfinished, path);
      });
    },
  };
}

/** Written to as it is. */
function direct(file: number, name: string): Output {
  const pause = new Int32Array(new SharedArrayBuffer(4));
  return {
    write(content) {
      const bytes = typeof content === 'string' ? Buffer.from(content) : content;
      for (let at = 0; at < bytes.length;) {
        try {
          at += writeSync(file, bytes, at);
        } catch (error) {
          if ((error as NodeJS.ErrnoException).code !== 'EAGAIN') throw cannotWrite(name, error);
          // A pipe takes what it has room for, and may have none just now.
          Atomics.wait(pause, 0, 0, 1);
        }
      }
    },
    finish() {
      if (file !== 1) told(name, () => closeSync(file));
    },
    discard() {
      if (file !== 1) closeSync(file);
    },
  };
}

function isSame({ dev, ino }: { dev: number; ino: number }, scenario: string): boolean {
  const read = attempt(() => (scenario === '-' ? fstatSync(0) : statSync(pathOf(scenario))));
  return read !== undefined && read.isFile() && read.dev === dev && read.ino === ino;
}

function open(name: string, path: string, flags: 'w' | 'wx', mode?: number): number {
  return told(name, () => openSync(path, flags, mode));
}

/** In one line what a system error means. */
const MEANS: Readonly<Record<string, string>> = {
  ENOSPC: 'the disk is full',
  EDQUOT: 'the disk quota is used up',
  EFBIG: 'the file would be larger than allowed',
  EACCES: 'there is no permission to write there',
  EPERM: 'there is no permission to write there',
  EROFS: 'the disk is read-only',
  ENOENT: 'there is no such folder',
  ENOTDIR: 'a part of its path is no folder',
  EISDIR: 'it is a folder',
  ENAMETOOLONG: 'the name is too long',
  EPIPE: 'what reads it has closed',
};

/** Why something was not written, for people. */
export function cannotWrite(name: string, error: unknown): UsageError {
  const { code, message } = error as NodeJS.ErrnoException;
  return new UsageError(`${name} can't be written: ${MEANS[code ?? ''] ?? message}`);
}

function told<T>(name: string, act: () => T): T {
  try {
    return act();
  } catch (error) {
    throw cannotWrite(name, error);
  }
}

/** What `act` gives, or undefined where it fails. */
function attempt<T>(act: () => T): T | undefined {
  try {
    return act();
  } catch {
    return undefined;
  }
}
