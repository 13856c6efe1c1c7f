import type { Checker } from './checker.ts';
import { compileExpression } from './expressions.ts';
import type { SystemMeta } from '../model/system.ts';

/** A path on the ground for a controller to follow, at the speed that the vehicle has. */
export type PathOptions =
  /** From a point on, in a heading (rad). */
  | { line: { x: number; y: number; heading: number } }
  /** From that point in that heading, to the left (radius above 0) or right (below). */
  | { circle: { radius: number; x: number; y: number; heading: number } }
  /** Through points, in their order. */
  | { points: [number, number][]; closed: boolean }
  /** Expressions of t, from 0 to `to`, m. */
  | { curve: { x: string | number; y: string | number; to: number }; closed: boolean };

const KINDS = ['line', 'circle', 'points', 'curve'] as const;
const MOST_POINTS = 1000;

/**
 * Checks `control.path`; undefined where it has errors, which are then collected.
 *
 * @param c collects the errors
 * @param raw `control.path` as written
 * @param meta of the system
 */
export function checkPath(c: Checker, raw: unknown, meta: SystemMeta): PathOptions | undefined {
  const path = 'control.path';
  if (!(meta.forward ?? meta.speed))
    return c.add(path, `${meta.id} has no heading to follow a path with; leave it out`);
  const given = new Map(c.entries(path, raw, [...KINDS, 'closed']));
  const kinds = KINDS.filter((kind) => given.has(kind));
  if (kinds.length !== 1) return c.add(path, `must have one of ${KINDS.join(', ')}`);
  const [kind] = kinds;
  const closed = given.get('closed') ?? false;
  if (typeof closed !== 'boolean') c.add(`${path}.closed`, 'must be true or false');
  if (given.has('closed') && (kind === 'line' || kind === 'circle'))
    c.add(`${path}.closed`, `is for points and curves; leave it out of a ${kind}`);
  const start = (more: readonly string[]): Map<string, unknown> =>
    new Map(c.entries(`${path}.${kind!}`, given.get(kind!), ['x', 'y', 'heading', ...more]));
  const number = (values: Map<string, unknown>, key: string): number =>
    values.get(key) === undefined ? 0 : (c.constant(`${path}.${kind!}.${key}`, values.get(key)) ?? 0);
  if (kind === 'line') {
    const values = start([]);
    return { line: { x: number(values, 'x'), y: number(values, 'y'), heading: number(values, 'heading') } };
  }
  if (kind === 'circle') {
    const values = start(['radius']);
    const radius = number(values, 'radius');
    if (!(Math.abs(radius) > 0))
      c.add(`${path}.circle.radius`, 'must be above 0 (to the left) or below (to the right), in m');
    return { circle: { radius, x: number(values, 'x'), y: number(values, 'y'), heading: number(values, 'heading') } };
  }
  if (kind === 'points') return checkPoints(c, given.get('points'), closed === true);
  const values = new Map(c.entries(`${path}.curve`, given.get('curve'), ['x', 'y', 'to']));
  const to = c.number(`${path}.curve.to`, values.get('to'), { above: 0, most: 1e4 }) ?? 1;
  for (const key of ['x', 'y']) c.expression(`${path}.curve.${key}`, values.get(key), ['t']);
  return { curve: { x: values.get('x') as string, y: values.get('y') as string, to }, closed: closed === true };
}

function checkPoints(c: Checker, raw: unknown, closed: boolean): PathOptions | undefined {
  const path = 'control.path.points';
  if (!Array.isArray(raw) || raw.length < 3 || raw.length > MOST_POINTS)
    return c.add(path, `must be a list of 3 to ${MOST_POINTS} points [x, y], m`);
  const points = raw.map((point, i): [number, number] => {
    if (!Array.isArray(point) || point.length !== 2) c.add(`${path}[${i}]`, 'must be a pair [x, y], m');
    const at = (k: number): number =>
      c.number(`${path}[${i}][${k}]`, Array.isArray(point) ? (point as unknown[])[k] : undefined, {}) ?? 0;
    return [at(0), at(1)];
  });
  points.forEach(([x, y], i) => {
    const before = points[i - 1];
    if (before && Math.hypot(x - before[0], y - before[1]) < 1e-6)
      c.add(`${path}[${i}]`, 'is the point before it again');
  });
  return { points, closed };
}

/**
 * Points of a path that is drawn through points, its curve sampled.
 *
 * @param path as checked, m
 */
export function pointsOf(path: Extract<PathOptions, { closed: boolean }>): [number, number][] {
  if ('points' in path) return path.points;
  const { to } = path.curve;
  const [x, y] = [path.curve.x, path.curve.y].map((text) => compileExpression(text, { variables: ['t'] }));
  const count = 400;
  const all = Array.from({ length: count + 1 }, (_, i): [number, number] => {
    const t = (to * i) / count;
    return [x!.evaluate(t), y!.evaluate(t)];
  });
  return all.filter(([px, py], i) => i === 0 || Math.hypot(px - all[i - 1]![0], py - all[i - 1]![1]) > 1e-9);
}
