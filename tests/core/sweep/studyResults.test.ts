// A sweep's results as the page reads them: what the table must have, the scenario behind a row, and rows as a grid.
import { describe, expect, test } from 'vitest';
import {
  gridOf,
  scenarioOfRow,
  studyResults,
  variedOf,
  type StudyColumn,
} from '../../../src/core/sweep/studyResults.ts';
import { checkStudy } from '../../../src/core/sweep/study.ts';
import { systemMetas } from '../../../src/core/systems/registry.ts';

const file = {
  version: 1,
  scenario: { version: 1, system: 'ripstik', initial: { X_dot: 1 }, duration: 1 },
  vary: { 'initial.alpha': { grid: [-0.1, 0.2, 4] }, 'parameters.casterTrail': { list: [0.03, 0.05] } },
  measures: ['final.X'],
};
const study = checkStudy(file, systemMetas);

function columns(): Map<string, StudyColumn> {
  const rows = Array.from({ length: study.runs }, (_, index) => study.values(index));
  return new Map<string, StudyColumn>([
    ['index', Float64Array.from(rows.keys())],
    ['initial.alpha', Float64Array.from(rows, ([alpha]) => alpha as number)],
    ['parameters.casterTrail', Float64Array.from(rows, ([, trail]) => trail as number)],
    ['final.X', new Float64Array(study.runs).fill(1)],
    ['reason', rows.map(() => 'end')],
    ['time', new Float64Array(study.runs).fill(1)],
  ]);
}

describe('results with their study', () => {
  const results = studyResults('basin', columns(), { study: file, shard: '1/1' }, systemMetas);

  test('each row is the scenario that the study ran', () => {
    expect(variedOf(results)).toEqual(['initial.alpha', 'parameters.casterTrail']);
    for (let row = 0; row < results.rows; row++) expect(scenarioOfRow(results, row)).toEqual(study.scenario(row));
  });

  test('rows in any order form the same grid', () => {
    const [x, y] = ['initial.alpha', 'parameters.casterTrail'].map((name) => results.columns.get(name) as Float64Array);
    const grid = gridOf(x!, y!, [7, 3, 0, 1, 2, 6, 5, 4])!;
    expect([grid.x, grid.y, grid.hidden]).toEqual([[-0.1, 0, 0.1, 0.2], [0.03, 0.05], 0]);
    grid.cells.forEach((row, cell) =>
      expect([x![row], y![row]]).toEqual([grid.x[cell % 4], grid.y[Math.floor(cell / 4)]]),
    );
  });
});

test('rows that share a cell are counted, and the first one shows', () => {
  const x = Float64Array.of(0, 1, 0, 1, 0);
  const y = Float64Array.of(0, 0, 1, 1, 0);
  expect(gridOf(x, y, [0, 1, 2, 3, 4])).toMatchObject({ hidden: 1, cells: Int32Array.of(0, 1, 2, 3) });
});

test('drawn values form no grid', () => {
  const values = Float64Array.from({ length: 50 }, (_, i) => Math.sin(i));
  expect(gridOf(values, values.map(Math.cos), [...values.keys()])).toBeNull();
});

test('a table without what a sweep writes is told by the column that it lacks', () => {
  const lacking = columns();
  lacking.delete('final.X');
  expect(() => studyResults('x', lacking, { study: file }, systemMetas)).toThrow('no column "final.X"');
  expect(() => studyResults('x', new Map([['t', new Float64Array(1)]]), {}, systemMetas)).toThrow('no column "index"');
});

test('results that tools joined, without their study, show what is varied by its names', () => {
  const joined = studyResults('x', columns(), {}, systemMetas);
  expect(variedOf(joined)).toEqual(['initial.alpha', 'parameters.casterTrail']);
  expect(scenarioOfRow(joined, 0)).toBeNull();
});
