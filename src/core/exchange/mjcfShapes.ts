/** What a description draws, as MJCF's geoms: to be seen, not to be touched. */
import type { BodyModel, ShapeModel } from '../description/model.ts';
import { Program } from '../description/program.ts';
import type { Source } from './source.ts';
import { add, applyInverse, type V3 } from './spatial.ts';

/** A cylinder lies along z. */
const AXES: Readonly<Record<ShapeModel['axis'], string>> = {
  x: ' quat="0.7071067811865476 0 0.7071067811865476 0"',
  y: ' quat="0.7071067811865476 0.7071067811865476 0 0"',
  z: '',
};

/**
 * One geom a shape, in the axes of the body's centre of mass; paths and meshes have none.
 *
 * @param source what is exported
 * @param body that wears them
 * @param number how numbers are written
 */
export function shapesOf(source: Source, body: BodyModel, number: (x: number) => string): string[] {
  const { model, p, q } = source;
  return model.shapes.flatMap((shape) => {
    if (model.bodies[shape.body] !== body || shape.kind === 'path' || shape.kind === 'model') return [];
    const outputs = { sizes: shape.sizes, at: shape.at, origin: body.origin, centre: body.position, R: body.frame.R };
    const [sizes, at, origin, centre, R] = Object.values(outputs).map((ids) => new Float64Array(ids.length)) as [
      Float64Array,
      Float64Array,
      Float64Array,
      Float64Array,
      Float64Array,
    ];
    new Program(model.graph, { q: model.q, p: model.p }, outputs).interpreted()(q, p, sizes, at, origin, centre, R);
    const from = applyInverse([...R], add([...origin] as V3, [...centre] as V3, -1));
    const pos = add(from, [...at] as V3);
    const [a, b, c] = sizes;
    const half = (x: number | undefined): string => number((x ?? 0) / 2);
    const where = `pos="${pos.map(number).join(' ')}"`;
    if (!(a! > 0) || (shape.kind !== 'sphere' && !(b! > 0))) return [];
    switch (shape.kind) {
      case 'box':
        return [`<geom type="box" size="${half(a)} ${half(b)} ${half(c)}" ${where}/>`];
      case 'sphere':
        return [`<geom type="sphere" size="${number(a!)}" ${where}/>`];
      default:
        return [`<geom type="cylinder" size="${number(a!)} ${half(b)}" ${where}${AXES[shape.axis]}/>`];
    }
  });
}
