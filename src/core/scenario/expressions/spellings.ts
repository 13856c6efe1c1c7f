/** Characters that keyboards, documents and other programs bring, and what they stand for: signs, and names of constants. */
export const SPELLINGS: ReadonlyMap<string, string> = new Map([
  ['−', '-'],
  ['–', '-'],
  ['×', '*'],
  ['·', '*'],
  ['⋅', '*'],
  ['÷', '/'],
  ['π', 'pi'],
  ['°', 'deg'],
  ['º', 'deg'],
  ['≤', '<='],
  ['≥', '>='],
  ['≠', '!='],
]);

/** Raised digits and signs: a run of them is one exponent. */
export const RAISED: ReadonlyMap<string, string> = new Map(
  [...'⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻'].map((raised, i) => [raised, '0123456789+-'[i]!]),
);
