/**
 * The pose of a body that rolls on another about the x axis of that one, among poses as views have them: place, then
 * rotation by rows, 12 numbers a body. A rider is drawn so from what carries it, with none of its equations.
 *
 * @param out poses, written at `body`
 * @param carrier index of the body that it rolls on
 * @param body its own index
 * @param angle of the roll, rad
 * @param hinge height of the axis in the carrier's axes above its origin, m
 * @param origin height of its own origin above the axis, along its own z, m
 */
export function rolledOn(
  out: Float64Array,
  carrier: number,
  body: number,
  angle: number,
  hinge: number,
  origin: number,
): void {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  for (let i = 0; i < 3; i++) {
    const row = 12 * carrier + 3 + 3 * i;
    const [x, y, z] = [out[row]!, out[row + 1]!, out[row + 2]!];
    const own = 12 * body + 3 + 3 * i;
    out[own] = x;
    out[own + 1] = c * y + s * z;
    out[own + 2] = c * z - s * y;
    out[12 * body + i] = out[12 * carrier + i]! + hinge * z + origin * out[own + 2]!;
  }
}
