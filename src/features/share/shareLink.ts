import type { App } from '../../app/app.ts';
import { linkOf } from '../../app/persistence/links.ts';
import { words } from './words.ts';

/**
 * Copies a link to what is in the panel, or hands it to a phone's own sheet.
 *
 * @param app whose draft it is
 * @throws Error with what is wrong with the draft
 * @returns the link where neither is possible: the person copies it
 */
export async function shareLink(app: App): Promise<string | null> {
  const link = `${location.origin}${location.pathname}#${linkOf(app)}`;
  if (await handedOver(app.state.origin.peek().title, link)) return null;
  try {
    await navigator.clipboard.writeText(link);
    app.actions.report('info', words.copied, [words.copiedHint(link.length)]);
    return null;
  } catch {
    return link; // no clipboard, or not allowed
  }
}

/** Whether the phone's own sheet took it; giving it up there is an answer too. */
async function handedOver(title: string, url: string): Promise<boolean> {
  if (!('share' in navigator) || !matchMedia('(pointer: coarse)').matches) return false;
  try {
    await navigator.share({ title, url });
    return true;
  } catch (error) {
    return (error as Error).name === 'AbortError';
  }
}
