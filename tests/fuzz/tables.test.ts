// Grammars of tables as tools write them, damaged: never a throw, every row read or named, times that rise.
import fc from 'fast-check';
import { expect, test } from 'vitest';
import { CsvByteReader } from '../../src/csv/reading/byteReader.ts';
import { metas } from '../helpers.ts';
import { damaged } from './damage.ts';

const SEED = 20261128;
const word = fc.constantFrom(
  't',
  'time',
  'Zeit',
  'Date',
  'Frame',
  'x',
  'y',
  'theta',
  'yaw',
  'qx',
  'qy',
  'qz',
  'qw',
  'der(x)',
  "x'",
  'a.b',
  '',
  'x/mm',
  'theta [deg]',
  'topic',
);
const cell = fc.constantFrom(
  '0',
  '1.5',
  '-2',
  '1,5',
  '1D-3',
  '#N/A',
  '#DIV/0!',
  '',
  'NaN',
  '2025-04-17T10:00:00Z',
  '17/04/2025',
  '10:00:01',
  '1744909208000000000',
  'x',
  '"',
  '1.234,5',
  'mm',
  's',
  'deg',
  '0x1',
);
const above = fc.constantFrom(
  '',
  'sep=;',
  '% note',
  '// Update Rate: 50Hz',
  'Rate,50 Hz',
  'inDegrees=yes',
  'Trajectories\n100',
  'NO_OF_FRAMES\t3',
  'Format Version,1.23,Take Name,T',
);
const file = fc
  .record({
    by: fc.constantFrom(',', ';', '\t', '|', ' '),
    above: fc.array(above, { maxLength: 3 }),
    head: fc.array(word, { minLength: 1, maxLength: 9 }),
    rows: fc.array(fc.array(cell, { minLength: 1, maxLength: 9 }), { maxLength: 12 }),
  })
  .map(({ by, above: lines, head, rows }) => [...lines, head.join(by), ...rows.map((row) => row.join(by))].join('\n'));

test('any table, damaged or not, is read or refused with a reason', () => {
  fc.assert(
    fc.property(fc.oneof(file, damaged(file)), fc.boolean(), (text, wide) => {
      const bytes = wide
        ? new Uint8Array(Uint16Array.from(text, (c) => c.charCodeAt(0)).buffer)
        : new TextEncoder().encode(text);
      const reader = new CsvByteReader({ systems: metas, data: true, unasked: true }, bytes.length);
      reader.push(bytes);
      const result = reader.finish();
      if (result.kind !== 'motion') {
        expect(result.kind === 'unusable' && result.issues[0]!.message.length > 5).toBe(true);
        return;
      }
      const t = result.data[0]!;
      for (let r = 1; r < result.rows; r++) expect(t[r]!).toBeGreaterThan(t[r - 1]!);
      for (const column of result.data) expect(column.length).toBe(result.rows);
    }),
    { seed: SEED, numRuns: 600 },
  );
});
