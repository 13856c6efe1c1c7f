import { spawnSync } from 'node:child_process';
import { fileURLToPath, pathToFileURL } from 'node:url';

/**
 * Measurements in a process of their own, as the page gives every run a worker of its own: code that another method
 * has left in the compiler's memory changes a figure by a third.
 */

/** A function by the module that exports it under `name`; arguments and result are JSON. */
export interface Job<Arguments extends readonly unknown[], Result> {
  module: string;
  name: string;
  run(...args: Arguments): Result;
}

/** How jobs are run: `here` or `apart`. */
export type Caller = <Arguments extends readonly unknown[], Result>(
  job: Job<Arguments, Result>,
  ...args: Arguments
) => Result;

export const here: Caller = (job, ...args) => job.run(...args);

export const apart: Caller = (job, ...args) => {
  const child = spawnSync(
    process.execPath,
    [...process.execArgv, fileURLToPath(import.meta.url), job.module, job.name, JSON.stringify(args)],
    {
      encoding: 'utf8',
      stdio: ['ignore', 'pipe', 'inherit'],
      maxBuffer: 1 << 26,
    },
  );
  if (child.status !== 0)
    throw new Error(`${job.name}(${JSON.stringify(args)}) failed: ${child.error?.message ?? `status ${child.status}`}`);
  return JSON.parse(child.stdout) as ReturnType<typeof job.run>;
};

/** The child's side: does the job it was called for. */
async function serve([module, name, args]: readonly string[]): Promise<void> {
  const jobs = (await import(module!)) as Record<string, Job<unknown[], unknown>>;
  process.stdout.write(JSON.stringify(jobs[name!]!.run(...(JSON.parse(args!) as unknown[]))));
}

const entry = process.argv[1];
// Bundled with the command line, it is no program of its own.
if (entry?.endsWith('apart.ts') && import.meta.url === pathToFileURL(entry).href) void serve(process.argv.slice(2));
