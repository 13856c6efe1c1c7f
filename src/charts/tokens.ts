/** Design tokens for what draws by itself. */
const known = new Map<string, string>();
let theme: string | undefined;

/**
 * Value of a token of `style/tokens.css` (`--accent`) in the theme in force; empty when there is no such token.
 * All are set at the root, and each is asked for once a theme: an answer has the whole page's styles worked out.
 */
export function token(name: string): string {
  const now = document.documentElement.dataset['theme'];
  if (now !== theme) known.clear();
  theme = now;
  let value = known.get(name);
  if (value === undefined) {
    value = getComputedStyle(document.documentElement).getPropertyValue(name).trim();
    if (value !== '') known.set(name, value);
  }
  return value;
}
