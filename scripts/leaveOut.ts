// A Vite plugin: builds one half of the program without what a system's folder loads for the other half alone.
import { readFileSync } from 'node:fs';
import type { Plugin } from 'vite';

const FOLDER = /\/src\/core\/systems\/[\w-]+\/index\.ts$/;
const NOTHING = '\0left-out';
const NO_CASES = /\/src\/core\/systems\/[\w-]+\/cases\.ts$/;

/**
 * What is left out is not lost unseen: whoever loads it nevertheless gets an error that says where.
 *
 * @param half that is built, for the error
 * @param what paths that a system's `index.ts` imports
 */
export function leaveOut(half: string, what: RegExp): Plugin {
  return {
    name: `leaves-out-of-${half.replace(' ', '-')}`,
    apply: 'build',
    enforce: 'pre',
    resolveId: (source, importer) => (importer && FOLDER.test(importer) && what.test(source) ? NOTHING : undefined),
    load: (id) =>
      id === NOTHING
        ? `throw new Error('this part of a system is not built into ${half}');\nexport default null;`
        : undefined,
  };
}

/** Cases are what a person chooses from: a worker is given scenarios, its lists of cases are empty. */
export const withoutCases: Plugin = {
  name: 'without-cases',
  apply: 'build',
  enforce: 'pre',
  load: (id) =>
    NO_CASES.test(id)
      ? [...readFileSync(id, 'utf8').matchAll(/^export const (\w+)/gm)]
          .map(([, name]) => `export const ${name} = [];`)
          .join('\n')
      : undefined,
};
