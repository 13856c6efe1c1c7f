import { expect, test } from 'vitest';
import { withHeld } from '../../../src/core/motion/heldColumns.ts';
import { metas } from '../../helpers.ts';

const meta = metas['ripstik-rider']!;
const old = meta.coordinates.map(({ name }) => name).filter((name) => !meta.held!.includes(name));
const columns = (names: readonly string[]) => names.map((_, i) => Float64Array.of(i, i + 1));

test('rows from before the rider had legs and hips have them stand at 0, in the order of the coordinates', () => {
  const names = ['t', ...old, ...old.map((name) => `${name}_dot`), 'tau_af'];
  const { names: all, data, added } = withHeld(meta, names, columns(names));
  const order = meta.coordinates.map(({ name }) => name);
  expect(all).toEqual(['t', ...order, ...order.map((name) => `${name}_dot`), 'tau_af']);
  expect(added).toEqual(['crouch', 'twist']);
  names.forEach((name, i) => expect(data[all.indexOf(name)]).toEqual(Float64Array.of(i, i + 1)));
  for (const name of added) expect(data[all.indexOf(name)]).toEqual(new Float64Array(2));
});

test('what is there stays as it is, and rates are added where there are rates alone', () => {
  const names = ['t', ...old, 'crouch'];
  const { names: all, added } = withHeld(meta, names, columns(names));
  expect(all).toEqual([...names, 'twist']);
  expect(added).toEqual(['twist']);
  const board = metas['ripstik']!;
  expect(withHeld(board, ['t', 'X'], columns(['t', 'X'])).names).toEqual(['t', 'X']);
});
