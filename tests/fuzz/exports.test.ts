// Tables as tools export them, by a grammar: no row is lost without a word, and the encoding changes nothing.
import fc from 'fast-check';
import { expect, test } from 'vitest';
import { CsvByteReader } from '../../src/csv/reading/byteReader.ts';
import type { CsvResult } from '../../src/csv/csv.ts';
import { metas } from '../helpers.ts';

const SEED = 20261128;

const read = (bytes: Uint8Array): CsvResult => {
  const reader = new CsvByteReader({ systems: metas, data: true, unasked: true }, bytes.length);
  reader.push(bytes);
  return reader.finish();
};

/** What a cell of a coordinate may hold that is no number. */
const GAPS = ['', 'NaN', '#N/A', '#WERT!', '#DIV/0!', '1.#QNAN', '-', 'null', 'broken', '12:ab', 'inf'];

/** A tool's way of writing: names, times, numbers, what stands between them, what stands above. */
const tool = fc.record({
  by: fc.constantFrom(',', ';', '\t', '|'),
  comma: fc.boolean(),
  eol: fc.constantFrom('\n', '\r\n', '\r'),
  names: fc.constantFrom(
    ['t', 'x', 'y', 'theta'],
    ['Zeit [s]', 'Position x [mm]', 'Position y [mm]', 'Gierwinkel [°]'],
    ['Tiempo (s)', 'posición_x (m)', 'posición_y (m)', 'θ (rad)'],
    ['time', 'board.x', 'board.y', 'board.theta'],
    ['timestamp_ms', '/robot/x', '/robot/y', '/robot/yaw'],
    ['ts', 'board_x', 'board_y', 'board_theta'],
    ['$t$ [s]', '$x$ [m]', '$y$ [m]', '$\\theta$ [rad]'],
    ['Temps écoulé (s)', 'Coordonnée X (mm)', 'Coordonnée Y (mm)', 'Angle de lacet (°)'],
    ['tempo decorrido (s)', 'x_est', 'y_est', 'guinada_est'],
    ['tijd [s]', 'positie x [mm]', 'positie y [mm]', 'gierhoek [graden]'],
    ['Czas [s]', 'położenie x [mm]', 'położenie y [mm]', 'kąt odchylenia [stopnie]'],
    ['Время, с', 'координата x, мм', 'координата y, мм', 'курс, град'],
    ['経過時間 [秒]', 'x座標 [mm]', 'y座標 [mm]', 'ヨー角 [度]'],
  ),
  extra: fc.constantFrom([], ['der(x)'], ['energy'], ['note'], ['acc.x'], ['gyro_y', 'error x'], ['Kraft y']),
  below: fc.constantFrom('', '', '', 'float64', '<dbl>', '----', 'no remark'),
  end: fc.constantFrom('', '', 'blank rows', '\n\n', '\u001a', '\n\0\0\0'),
  clock: fc.constantFrom('number', 'iso', 'h:m:s'),
  quoted: fc.boolean(),
  above: fc.constantFrom('', 'sep', 'Recorder{by}Élan 2\nRate{by}50 Hz\n', '# made by a tool\n', '% größe\n'),
  index: fc.boolean(),
});

const rows = fc.array(
  fc.record({
    cells: fc.tuple(...[0, 1, 2].map(() => fc.integer({ min: -99999, max: 99999 }))),
    gap: fc.option(fc.tuple(fc.integer({ min: 0, max: 2 }), fc.constantFrom(...GAPS)), { freq: 8, nil: null }),
    between: fc.constantFrom('', '', '', '', '\n', '# a remark\n'),
  }),
  { minLength: 6, maxLength: 40 },
);

interface Written {
  text: string;
  /** 1-based lines of rows, and of those with a gap. */
  lines: number[];
  gaps: number[];
}

const file = fc.tuple(tool, rows).map(([way, list]): Written => {
  const { by, eol, names, extra, clock, quoted, index } = way;
  // Between commas a decimal comma stands in quotes, or not at all.
  const comma = way.comma && (by !== ',' || quoted);
  const number = (x: number): string => (comma ? (x / 1000).toFixed(3).replace('.', ',') : (x / 1000).toFixed(3));
  const cell = (text: string): string => (quoted ? `"${text}"` : text);
  const title = clock === 'number' ? names[0]! : 'time';
  const pad = (i: number): string => (i / 50).toFixed(3).padStart(6, '0');
  const time = (i: number): string => {
    if (clock === 'iso') return `2025-04-17T10:30:${pad(i)}Z`;
    return clock === 'h:m:s' ? `0:00:${pad(i)}` : number(1000 * (title.endsWith('ms') ? 20 * i : i / 50));
  };
  const above = way.above === 'sep' ? `sep=${by}\n` : way.above.replaceAll('{by}', by);
  const titles = [...(index ? [''] : []), title, ...names.slice(1), ...extra];
  let text = above + titles.map(cell).join(by) + '\n';
  if (way.below) text += titles.map(() => cell(way.below)).join(by) + '\n';
  const [lines, gaps]: [number[], number[]] = [[], []];
  for (const [i, { cells, gap, between }] of list.entries()) {
    text += between;
    const line = text.split('\n').length;
    (gap ? gaps : lines).push(line);
    const values = cells.map((x, k) => (gap?.[0] === k ? gap[1] : number(x)));
    text +=
      [...(index ? [String(i)] : []), time(i), ...values, ...extra.map((name) => (name === 'note' ? 'ok' : number(i)))]
        .map(cell)
        .join(by) + '\n';
  }
  text += way.end === 'blank rows' ? `${by.repeat(titles.length - 1)}\n`.repeat(2) : way.end;
  return { text: text.replaceAll('\n', eol), lines, gaps };
});

/** Bytes of a text in each encoding that has all of its letters. */
function encodings(text: string): [name: string, bytes: Uint8Array][] {
  const wide = (big: boolean, mark: boolean): Uint8Array => {
    const units = mark ? `\ufeff${text}` : text;
    const bytes = new DataView(new ArrayBuffer(2 * units.length));
    for (let i = 0; i < units.length; i++) bytes.setUint16(2 * i, units.charCodeAt(i), !big);
    return new Uint8Array(bytes.buffer);
  };
  const latin = [...text].every((c) => c.charCodeAt(0) < 256);
  return [
    ['UTF-8 with a mark', new TextEncoder().encode(`\ufeff${text}`)],
    ['UTF-16, little end first, with a mark', wide(false, true)],
    ['UTF-16, little end first', wide(false, false)],
    ['UTF-16, big end first, with a mark', wide(true, true)],
    ['UTF-16, big end first', wide(true, false)],
    ...(latin ? [['Latin-1', Uint8Array.from(text, (c) => c.charCodeAt(0))] as [string, Uint8Array]] : []),
  ];
}

test('every row is read or named', () => {
  fc.assert(
    fc.property(file, ({ text, lines, gaps }) => {
      const result = read(new TextEncoder().encode(text));
      if (result.kind !== 'motion') {
        expect(lines.length, JSON.stringify(result)).toBeLessThan(3);
        return;
      }
      expect(result.systemId, result.notes.join('; ')).toBe('chaplygin-sleigh');
      // Columns with times of their own are interpolated.
      if (result.plan.sparse) return;
      const named = new Set(
        result.issues.flatMap(({ line, to = line }) => Array.from({ length: to - line + 1 }, (_, i) => line + i)),
      );
      for (const line of gaps) expect(named, `line ${line} of\n${text}`).toContain(line);
      expect(result.rows, text).toBe(lines.length);
      expect(result.skippedRows).toBe(gaps.length);
    }),
    { seed: SEED, numRuns: 300 },
  );
});

test('rows and a zero at the beginning of a serial line change nothing', () => {
  fc.assert(
    fc.property(file, fc.constantFrom('\0', '\0\0', '\u0001'), ({ text }, noise) => {
      expect(read(new TextEncoder().encode(noise + text))).toEqual(read(new TextEncoder().encode(text)));
    }),
    { seed: SEED, numRuns: 60 },
  );
});

test('every encoding gives the same', () => {
  fc.assert(
    fc.property(file, ({ text }) => {
      const plain = read(new TextEncoder().encode(text));
      for (const [name, bytes] of encodings(text)) {
        const other = read(bytes);
        expect(other.kind, name).toBe(plain.kind);
        if (plain.kind !== 'motion' || other.kind !== 'motion') continue;
        expect(other.columns, name).toEqual(plain.columns);
        expect(other.data, name).toEqual(plain.data);
        expect(other.issues, name).toEqual(plain.issues);
      }
    }),
    { seed: SEED, numRuns: 150 },
  );
});
