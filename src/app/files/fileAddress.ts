/** `?file=`: a CSV, scenario or sweep's results beside the page, fetched with progress. Loaded when an address asks for one. */
import { fileText as text } from './addressWords.ts';
import type { App } from '../app.ts';

/** Bytes; all of it passes through memory before it is read, unlike a file from the disk. */
const LARGEST_FETCHED = 400e6;

/**
 * The address that a `?file=` stands for.
 * @param page address of the page
 * @throws Error for anything but a relative path to a .csv, .txt, .json, .parquet or .md of the page's own origin
 */
export function fileAddress(file: string, page: string): URL {
  const shown = file.length > 80 ? `${file.slice(0, 79)}…` : file;
  // Browsers leave control characters out of addresses, so that they could hide another origin.
  if (/^[/\\]|^[a-z][a-z0-9+.-]*:|[\\\u0000-\u001f]/i.test(file.trim())) throw new Error(text.sameOrigin(shown));
  const here = new URL(page);
  let address: URL;
  try {
    address = new URL(file.trim(), here);
  } catch {
    throw new Error(text.sameOrigin(shown));
  }
  if (address.origin !== here.origin || address.username !== '' || address.password !== '')
    throw new Error(text.sameOrigin(shown));
  if (!/\.(csv|txt|json|parquet|md)$/i.test(address.pathname)) throw new Error(text.ending(shown));
  address.hash = '';
  return address;
}

/** Puts it on the stage; a refusal is told and leaves everything as it is. */
export async function openFileAddress(app: App, file: string): Promise<void> {
  const { actions } = app;
  try {
    const address = fileAddress(file, location.href);
    const name = nameOf(address);
    await actions.openFile(name, await fetched(address, (share) => actions.setLoading({ name, share })));
  } catch (error) {
    actions.report('error', text.refused, [(error as Error).message]);
  } finally {
    actions.setLoading(null);
  }
}

function nameOf({ pathname }: URL): string {
  const name = pathname.split('/').at(-1)!;
  try {
    return decodeURIComponent(name);
  } catch {
    return name;
  }
}

async function fetched(address: URL, progress: (share: number | null) => void): Promise<Blob> {
  progress(null);
  // A redirect could lead to another origin, and a stranger's address gets no one's cookies.
  const response = await fetch(address, { redirect: 'error', credentials: 'omit' }).catch(() => {
    throw new Error(text.unreachable);
  });
  if (!response.ok || !response.body) throw new Error(text.answered(response.status));
  if (response.headers.get('content-type')?.includes('html')) throw new Error(text.page);
  const length = Number(response.headers.get('content-length') ?? 0);
  if (length > LARGEST_FETCHED) throw new Error(text.large(LARGEST_FETCHED / 1e6));
  const reader = response.body.getReader();
  const parts: Uint8Array<ArrayBuffer>[] = [];
  let got = 0;
  for (let chunk = await reader.read(); !chunk.done; chunk = await reader.read()) {
    parts.push(chunk.value);
    got += chunk.value.length;
    if (got > LARGEST_FETCHED) {
      await reader.cancel();
      throw new Error(text.large(LARGEST_FETCHED / 1e6));
    }
    progress(length > 0 ? Math.min(1, got / length) : null);
  }
  return new Blob(parts);
}
