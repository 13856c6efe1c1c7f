/** Parts of the application that come when they are first asked for, so that the first view need not carry them. */
import type { MessageActions } from './state/messages.ts';

/** A part on its way or here. */
export interface Later<T> {
  /**
   * Does something with the part, loading it first; a part that does not come is a message.
   * @returns what `use` returned; undefined where the part did not come
   */
  with<R>(use: (part: T) => R | Promise<R>): Promise<R | undefined>;
  /** Only where it is here already. */
  ifHere(use: (part: T) => void): void;
}

/**
 * @param load imports and makes the part; asked for anew after it failed
 * @param messages where a part that did not come is told
 */
export function later<T>(load: () => Promise<T>, messages: MessageActions): Later<T> {
  let coming: Promise<T> | null = null;
  let part: { here: T } | null = null;
  return {
    async with(use) {
      try {
        coming ??= load();
        part = { here: await coming };
      } catch {
        coming = null;
        messages.report('error', 'This part of the page could not be loaded', [
          'Check the connection and do it again; if the page has a newer version by now, load the page again. What is on the page is kept.',
        ]);
        return undefined;
      }
      return use(part.here);
    },
    ifHere(use) {
      if (part) use(part.here);
    },
  };
}
