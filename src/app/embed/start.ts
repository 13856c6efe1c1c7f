/** The page as a part of another one: who may speak to it, and the way to the whole page. Loaded only there. */
import type { App } from '../app.ts';
import { linkOf } from '../persistence/links.ts';
import type { Embedding } from './options.ts';
import { speakWith, type Surroundings } from './partner.ts';
import { embeddedPlots, type EmbeddedPlots } from './plots.ts';

declare const __RIPSTIK_VERSION__: string;

/**
 * Address of the whole page with what is in this one's panel; of the page alone, where that makes no link.
 *
 * @param app whose panel it is
 */
export function wholePage(app: App): string {
  const page = location.origin + location.pathname;
  try {
    return `${page}#${linkOf(app)}`;
  } catch {
    return page;
  }
}

/**
 * Listens to the page around this one, where the address names it.
 *
 * @param app whose stage it is
 * @param embedding what the address asks for
 * @param around the window
 * @returns the plots that it may ask for
 */
export function startEmbedded(app: App, { partner, wrong }: Embedding, around: Surroundings): EmbeddedPlots {
  const plots = embeddedPlots(app);
  if (wrong !== null) app.actions.report('error', 'This frame answers no messages', [wrong]);
  if (partner !== null && around.parent !== (around as unknown)) {
    speakWith(app, plots, partner, __RIPSTIK_VERSION__, around);
  }
  return plots;
}
