/** Whether the page is shown as a part of another one, and which. */
export interface Embedding {
  /** Origin of the page that may speak to this one; null: none may. */
  partner: string | null;
  /** Why the origin that the address names cannot be used, or null. */
  wrong: string | null;
}

/**
 * `?embed=` shows the stage with its transport alone; `?embed=https://lms.example.org` lets a page of that origin speak to it.
 *
 * @param search of the address, with its `?`
 */
export function embeddingOf(search: string): Embedding | null {
  const named = new URLSearchParams(search).get('embed');
  if (named === null) return null;
  const text = named.trim();
  if (text === '') return { partner: null, wrong: null };
  let origin = 'null';
  try {
    origin = new URL(text).origin;
  } catch {
    // said below
  }
  // An opaque origin is shared by everyone who has none.
  return /^https?:/.test(origin) && [origin, `${origin}/`].includes(text)
    ? { partner: origin, wrong: null }
    : {
        partner: null,
        wrong: `embed=${text.slice(0, 80)} names no origin; right would be https://lms.example.org, without a path, or nothing`,
      };
}
