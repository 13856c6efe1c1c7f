const TOKEN =
  /[ \t\n\r]+|"(?:[^"\\\u0000-\u001f]|\\(?:["\\/bfnrt]|u[0-9a-fA-F]{4}))*"|-?(?:0|[1-9]\d*)(?:\.\d+)?(?:[eE][+-]?\d+)?(?![\w.])|(?:true|false|null)\b|[{}[\],:]/y;

/**
 * Where a text stops being JSON: engines word this differently, and some leave the place out.
 *
 * @param text that should be JSON
 * @returns 0-based position and what would be right there, or null when it is JSON
 */
export function jsonFault(text: string): { position: number; message: string } | null {
  const open: string[] = [];
  let expected = 'value';
  for (let at = 0; at < text.length; at = TOKEN.lastIndex) {
    TOKEN.lastIndex = at;
    const token = TOKEN.exec(text)?.[0];
    if (token === undefined) return { position: at, message: strange(text, at, expected) };
    if (/^\s/.test(token)) continue;
    const next = after(token, expected, open);
    if (next === null)
      return {
        position: at,
        message: `${token.length > 20 ? `${token.slice(0, 19)}…` : token} where ${WORDS[expected]} is expected`,
      };
    expected = next;
  }
  return expected === 'end'
    ? null
    : { position: text.length, message: `the text ends where ${WORDS[expected]} is expected` };
}

/**
 * 1-based line and column of a position.
 *
 * @param text as written
 * @param position 0-based
 */
export function placeIn(text: string, position: number): { line: number; column: number } {
  const before = text.slice(0, position).split(/\r\n|\n|\r/);
  return { line: before.length, column: before.at(-1)!.length + 1 };
}

const WORDS: Record<string, string> = {
  value: 'a value',
  'value or ]': 'a value or ]',
  'key or }': 'a name in double quotes or }',
  key: 'a name in double quotes',
  colon: 'a colon',
  more: 'a comma or the closing bracket',
  end: 'the end of the text',
};

/** What a token is followed by, or null where it has no place; `open` holds the brackets around it. */
function after(token: string, expected: string, open: string[]): string | null {
  const closed = (): string => (open.length > 0 ? 'more' : 'end');
  const first = token[0]!;
  if (expected === 'colon') return first === ':' ? 'value' : null;
  if (expected === 'key' || (expected === 'key or }' && first !== '}')) return first === '"' ? 'colon' : null;
  if (first === '}' || first === ']') {
    const right = expected === 'more' || expected === (first === '}' ? 'key or }' : 'value or ]');
    return right && open.pop() === (first === '}' ? '{' : '[') ? closed() : null;
  }
  if (expected === 'more') return first === ',' ? (open.at(-1) === '{' ? 'key' : 'value') : null;
  if (!expected.startsWith('value') || first === ',' || first === ':') return null;
  if (first !== '{' && first !== '[') return closed();
  open.push(first);
  return first === '{' ? 'key or }' : 'value or ]';
}

function strange(text: string, at: number, expected: string): string {
  const c = String.fromCodePoint(text.codePointAt(at)!);
  if (c === '"') return 'a text in double quotes is not closed on its line, or holds a wrong escape';
  if (c === "'") return 'names and texts stand in double quotes';
  if (c === '/' || c === '#') return 'comments are not allowed';
  return `${JSON.stringify(c)} where ${WORDS[expected]} is expected`;
}
