import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { readCsv, writeCsv, type CsvResult } from '../../src/csv/csv.ts';
import { CsvByteReader } from '../../src/csv/reading/byteReader.ts';
import { DecimalReader } from '../../src/csv/reading/decimal.ts';
import { metas } from '../helpers.ts';

const SEED = 20171208;
const names = metas.ripstik!.coordinates.map((q) => q.name);
const encoder = new TextEncoder();
const options = { systems: metas };

/** The file in pieces cut at these places. */
function fromBytes(bytes: Uint8Array, cuts: readonly number[] = [], timeStep?: number): CsvResult {
  const reader = new CsvByteReader({ ...options, ...(timeStep === undefined ? {} : { timeStep }) }, bytes.length);
  const at = [0, ...cuts.map((c) => c % (bytes.length + 1)).sort((a, b) => a - b), bytes.length];
  for (let i = 1; i < at.length; i++) reader.push(bytes.slice(at[i - 1], at[i]));
  return reader.finish();
}

describe('decimal numbers', () => {
  const reader = new DecimalReader();
  const value = (text: string): number => {
    const bytes = encoder.encode(`${text},`);
    const x = reader.read(bytes, 0, bytes.length);
    return reader.at === bytes.length - 1 ? x : NaN;
  };
  const finite = (x: number): number => (x - x === 0 ? x : NaN);

  test('every double from its shortest and from its longer texts, to the last bit', () => {
    fc.assert(
      fc.property(fc.double({ noNaN: true, noDefaultInfinity: true }), fc.integer({ min: 1, max: 21 }), (x, digits) => {
        for (const text of [String(x), x.toPrecision(17), x.toPrecision(digits), x.toExponential(), `+${Math.abs(x)}`])
          expect(value(text)).toBe(finite(+text));
      }),
      { seed: SEED, numRuns: 3000 },
    );
  });

  test('digits by chance, halfway cases among them', () => {
    const digits = fc.array(fc.integer({ min: 0, max: 9 }), { minLength: 1, maxLength: 24 }).map((d) => d.join(''));
    fc.assert(
      fc.property(digits, digits, fc.integer({ min: -340, max: 310 }), fc.boolean(), (a, b, e, negative) => {
        for (const text of [`${a}.${b}`, `.${b}`, `${a}.`, `${a}e${e}`, `${a}.${b}E${e}`]) {
          const signed = negative ? `-${text}` : text;
          expect(value(signed)).toBe(finite(+signed));
        }
      }),
      { seed: SEED, numRuns: 3000 },
    );
    // Halfway between two neighbours, a little below, a little above.
    fc.assert(
      fc.property(fc.bigInt({ min: 2n ** 52n, max: 2n ** 53n - 1n }), (m) => {
        const half = (2n * m + 1n).toString();
        for (const text of [half, `${half}.0000001`, (2n * m).toString() + '.9999999']) expect(value(text)).toBe(+text);
      }),
      { seed: SEED },
    );
  });

  test.each(['', '-', '.', 'e5', '1e', '1e+', '--1', '1..2', '0x10', 'Infinity', '1e999', '١'])(
    '%j is no number',
    (text) => expect(value(text)).toBeNaN(),
  );
});

describe('bytes give what text gives', () => {
  const cell = fc.oneof(
    { weight: 20, arbitrary: fc.double({ noNaN: true, noDefaultInfinity: true, min: -1e6, max: 1e6 }).map(String) },
    fc.double({ noNaN: true, noDefaultInfinity: true }).map((x) => x.toPrecision(17)),
    fc.constantFrom(
      '',
      ' ',
      '""',
      '"1"',
      'nan',
      'inf',
      '1,5',
      '1.5',
      ' 2 ',
      '3 # remark',
      '"',
      "'",
      '−4',
      '1e400',
      '0x1f',
      '\r',
      'é',
      '\ud800',
      '=1+1',
      '\u0000',
    ),
  );
  const row = fc.tuple(
    fc.array(cell, { minLength: names.length, maxLength: names.length + 2 }),
    fc.integer({ min: 0, max: 60 }),
  );
  const file = fc.record({
    rows: fc.array(row, { minLength: 0, maxLength: 40 }),
    separator: fc.constantFrom(',', ';', '\t'),
    end: fc.constantFrom('\n', '\r\n', '\r'),
    head: fc.constantFrom('names', 'names and rates', 'none', 'comment', 'wrong'),
    comments: fc.boolean(),
    padding: fc.integer({ min: 0, max: 3 }),
  });
  const text = ({
    rows,
    separator,
    end,
    head,
    comments,
    padding,
  }: typeof file extends fc.Arbitrary<infer T> ? T : never): string => {
    const titles = {
      names: ['t', ...names],
      'names and rates': ['t', ...names, 'alpha_dot'],
      none: null,
      comment: ['# t', ...names],
      wrong: ['a', 'b', 't'],
    }[head];
    // Enough plain rows for the fast way to begin before the strange ones come.
    const plain = padding === 0 ? 0 : 900 * padding;
    const lines = [
      ...(comments ? ['# scenario: {"version":1,"system":"ripstik"}', '# a, "remark"'] : []),
      ...(titles ? [titles.join(separator)] : []),
      ...Array.from({ length: plain }, (_, i) =>
        [
          String(i / 1000 - 10),
          ...names.map((_, c) => String(Math.sin(i + c))),
          ...(head === 'names and rates' ? ['0'] : []),
        ].join(separator),
      ),
      ...rows.map(([cells, t], i) => [String(i + t / 50), ...cells].join(separator)),
    ];
    return lines.join(end) + (rows.length % 2 ? end : '');
  };

  test('for any file of ours, damaged or not, cut anywhere', () => {
    fc.assert(
      fc.property(file, fc.array(fc.nat(), { maxLength: 6 }), (f, cuts) => {
        const bytes = encoder.encode(text(f));
        // A lone surrogate has no bytes of its own: compare with what the bytes say.
        expect(fromBytes(bytes, cuts, 1 / 60)).toEqual(
          readCsv(new TextDecoder().decode(bytes), { ...options, timeStep: 1 / 60 }),
        );
      }),
      { seed: SEED, numRuns: 150 },
    );
  });

  test('an export, cut into pieces of any length, comes back to the last bit', () => {
    const columns = ['t', ...names];
    const data = columns.map((_, c) =>
      Float64Array.from({ length: 3000 }, (_, r) => (c === 0 ? r / 997 : Math.sin(r * c) * 10 ** ((r % 40) - 20))),
    );
    const bytes = encoder.encode(writeCsv(columns, data));
    for (const length of [1e9, 65536, 4099, 997]) {
      const result = fromBytes(
        bytes,
        Array.from({ length: Math.floor(bytes.length / length) }, (_, i) => (i + 1) * length),
      );
      if (result.kind !== 'motion') throw new Error(JSON.stringify(result));
      expect(result.rows).toBe(3000);
      for (let c = 0; c < columns.length; c++) expect([...result.data[c]!]).toEqual([...data[c]!]);
    }
  });

  // Where a piece ends inside such a cell, its lines count as two: no file of numbers has one.
  test('a quoted cell over two lines', () => {
    const lines = [
      ['t', ...names].join(','),
      ...[0, 1, 2].map((i) => [i, ...names.map((_, c) => (i === 1 && c === 0 ? '"a\nb"' : '1.5'))].join(',')),
    ].join('\n');
    expect(fromBytes(encoder.encode(lines))).toEqual(readCsv(lines, options));
  });

  test('other encodings', () => {
    const plain =
      ['t', ...names].join(',').replace('alpha', 'alpha [°]') +
      '\n' +
      [0, ...names.map(() => 90)].join(',') +
      '\n' +
      [1, ...names.map(() => 90)].join(',') +
      '\n';
    const expected = readCsv(plain, options);
    expect(expected.kind).toBe('motion');
    const utf16 = new Uint8Array(new Uint16Array([0xfeff, ...[...plain].map((c) => c.charCodeAt(0))]).buffer);
    const latin = Uint8Array.from(plain, (c) => c.charCodeAt(0));
    for (const bytes of [encoder.encode(plain), encoder.encode(`\ufeff${plain}`), utf16, latin])
      expect({ ...fromBytes(bytes, [7, 40, 41]), plan: null }).toEqual({ ...expected, plan: null });
  });

  test('bytes that are no text are refused', () => {
    const noise = Uint8Array.from({ length: 5000 }, (_, i) => (i * 7919) % 256);
    expect(fromBytes(noise).kind).toBe('unusable');
    expect(fromBytes(new Uint8Array(0)).kind).toBe('unusable');
    expect(fromBytes(new Uint8Array(3e6).fill(55)).kind).toBe('unusable');
  });
});
