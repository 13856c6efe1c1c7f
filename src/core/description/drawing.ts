/** The shapes of a description as meshes, in the proportions of the parameters. */
import { sizeOf, type Sketch, type Value } from '../geometry/drawing.ts';
import { plain } from '../geometry/plain.ts';
import { along, ball, box, drum, moved, pipe, tube } from '../geometry/solids.ts';
import { add, scale, type Vec3 } from '../geometry/vectors.ts';
import type { Model, ShapeModel } from './model.ts';
import { Program } from './program.ts';

type Part = Sketch['bodies'][string]['parts'][number];

const AXES: Readonly<Record<ShapeModel['axis'], Vec3>> = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] };
/** Of what is drawn where a body has no shape of its own, m. */
const MARKER = 0.012;
/** Of the bars of a path, as a share of its length. */
const BAR = 0.012;

/**
 * @param model what was read of a description
 * @returns meshes by body for parameters by name, SI; plain markers where the description has no shapes
 */
export function sketchOf(model: Model): (value: Value) => Sketch {
  const { bodies, shapes } = model;
  const meshes = bodies.map(({ id }, k) => meshOf(model, k) ?? id);
  const sizes = new Program(model.graph, { p: model.p }, { out: shapes.flatMap((s) => [...s.at, ...s.sizes]) });
  const evaluate = sizes.interpreted();
  const out = new Float64Array(sizes.outputs[0]!.length);
  return (value) => {
    const p = Float64Array.from(model.parameters, ({ name }) => value(name));
    evaluate(p, out);
    const stage = stageOf(model, p);
    if (shapes.length === 0) return { ...plain([...new Set(meshes)]), stage };
    const parts: Part[][] = bodies.map(() => []);
    let from = 0;
    for (const shape of shapes) {
      const end = from + 3 + shape.sizes.length;
      const here = parts[shape.body]!;
      const painted = bodies[shape.body]!.role === 'neutral' ? 'paint' : 'accent';
      for (const part of partsOf(shape, [...out.subarray(from, end)].map(finite), painted))
        here.push({ ...part, group: `${part.group}-${here.length + 1}` });
      from = end;
    }
    return {
      stage,
      bodies: Object.fromEntries(
        bodies.map(({ label }, k) => [
          meshes[k]!,
          {
            about: label,
            parts:
              parts[k]!.length > 0
                ? parts[k]!
                : [{ group: 'marker', material: 'accent', triangles: ball([0, 0, 0], MARKER, 12) }],
          },
        ]),
      ),
    };
  };
}

/**
 * Name of the mesh that a body wears, where the description says one.
 *
 * @param body place in the model, from 0
 */
export function meshOf({ shapes }: Model, body: number): string | null {
  return shapes.find((shape) => shape.body === body && shape.kind === 'model')?.model ?? null;
}

const finite = (x: number): number => (Number.isFinite(x) ? Math.min(1e3, Math.max(-1e3, x)) : 0);

function partsOf({ kind, axis }: ShapeModel, numbers: readonly number[], painted: 'paint' | 'accent'): Part[] {
  const [x, y, z, ...sizes] = numbers as [number, number, number, ...number[]];
  const at: Vec3 = [x, y, z];
  const [a = 0, b = 0, c = 0] = sizes.map(sizeOf);
  const e = AXES[axis];
  const part = (group: string, material: Part['material'], triangles: Part['triangles']): Part => ({
    group,
    material,
    triangles,
  });
  switch (kind) {
    case 'box':
      return [part('box', painted, moved(box([-a / 2, -b / 2, -c / 2], [a / 2, b / 2, c / 2]), at))];
    case 'sphere':
      return [part('ball', 'accent', ball(at, a))];
    case 'cylinder':
      return [part('cylinder', painted, drum(along(e, at), a, b / 2))];
    case 'rod':
      return [part('rod', 'steel', tube(add(at, scale(e, -b / 2)), add(at, scale(e, b / 2)), a))];
    case 'disc': {
      // Two bars across it show how it turns.
      const [u, w] = axis === 'x' ? ['y', 'z'] : axis === 'y' ? ['x', 'z'] : ['x', 'y'];
      const bar = (along: 'x' | 'y' | 'z', share: number): Part['triangles'] =>
        tube(add(at, scale(AXES[along], -share * a)), add(at, scale(AXES[along], share * a)), 0.62 * b, 8);
      return [
        part('disc', painted, drum(along(e, at), a, b / 2, 48)),
        part('marks', 'ink', [...bar(u as 'x', 0.9), ...bar(w as 'x', 0.6)]),
      ];
    }
    case 'path': {
      const points: Vec3[] = [];
      for (let k = 0; k + 2 < sizes.length; k += 3) points.push(add(at, sizes.slice(k, k + 3) as unknown as Vec3));
      const span = points.reduce(
        (sum, p, k) => (k === 0 ? 0 : sum + Math.hypot(...p.map((v, i) => v - points[k - 1]![i]!))),
        0,
      );
      return [part('path', 'steel', pipe(points, sizeOf(BAR * span)))];
    }
    case 'model':
      return [part('marker', 'accent', ball(at, MARKER, 12))];
  }
}

/** What goes nowhere is looked at where it is, with the floor below all that it reaches. */
function stageOf(model: Model, p: Float64Array): NonNullable<Sketch['stage']> {
  const { coordinates, bodies, shapes, graph, q } = model;
  if (coordinates.some(({ kind }, i) => kind === 'length' && i !== model.clock)) return {};
  const places = new Program(
    graph,
    { q, p: model.p },
    {
      out: bodies.flatMap(({ origin, position }) => [...origin, ...position]),
      shapes: shapes.flatMap(({ at, sizes }) => [...at, ...sizes]),
    },
  );
  const out = new Float64Array(6 * bodies.length);
  const extents = new Float64Array(places.outputs[1]!.length);
  places.interpreted()(
    Float64Array.from(coordinates, ({ rest }) => rest ?? 0),
    p,
    out,
    extents,
  );
  const largest = (values: Float64Array, least: number): number =>
    finite(values.reduce((most, x) => Math.max(most, Math.abs(x)), least));
  // A shape reaches from its body's place by where it stands on it and half of what it measures: no more than their sum.
  let beyond = 0;
  let from = 0;
  for (const { at, sizes } of shapes) {
    const end = from + at.length + sizes.length;
    const [place, size] = [extents.subarray(from, from + at.length), extents.subarray(from + at.length, end)];
    beyond = Math.max(beyond, largest(place, 0) + largest(size, 0) / 2);
    from = end;
  }
  const reach = (largest(out, 0.1) + beyond) * 1.1;
  return {
    still: true,
    facing: 'world',
    floor: -reach,
    frame: [
      [-reach, -reach / 4, -reach],
      [reach, reach / 4, reach],
    ],
  };
}
