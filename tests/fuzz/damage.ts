import fc from 'fast-check';

/** What strangers put where it does not belong. */
export const awkward = fc.constantFrom(
  '__proto__',
  'constructor',
  'toString',
  '{',
  '}',
  '[',
  ']',
  '"',
  '\\',
  '\u0000',
  '\ufeff',
  '\u202e',
  '\ud800',
  '1e999',
  '-0',
  'NaN',
  'Infinity',
  'null',
  '<script>',
  '../',
  'javascript:',
  '9'.repeat(400),
  '['.repeat(3000),
  '(((((',
  '^^^',
  ',',
  '\n',
  '#',
  '%s',
  '🛹',
);
const edit = fc.tuple(
  fc.double({ min: 0, max: 1, noNaN: true }),
  fc.integer({ min: 0, max: 60 }),
  fc.oneof(awkward, fc.constant(''), fc.string({ maxLength: 8 })),
);
/** A text with up to four pieces cut out or replaced. */
export const damaged = (original: fc.Arbitrary<string>): fc.Arbitrary<string> =>
  fc.tuple(original, fc.array(edit, { minLength: 0, maxLength: 4 })).map(([text, edits]) =>
    edits.reduce((now, [where, length, put]) => {
      const at = Math.floor(where * now.length);
      return now.slice(0, at) + put + now.slice(at + length);
    }, text),
  );
