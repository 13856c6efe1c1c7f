import { ball, drum, tube } from './solids.ts';
import { type ProfilePoint, type Triangle, turned } from './shapes.ts';
import { alongY, place, type Vec3 } from './vectors.ts';
import type { MaterialName, Part } from './wavefront.ts';

export interface WheelForm {
  /** To the tread (m). */
  radius: number;
  /** Half of the tyre's width (m). */
  halfWidth: number;
  spokes: number;
  /** Radius of a spoke (m). */
  spokeRadius: number;
  tyre?: MaterialName;
  /** What shows the spin: one spoke and a piece of the tread. The part's own colour unless told otherwise. */
  marked?: MaterialName;
  hub?: Vec3;
}

/** Steps of a tyre's turn; one spoke's worth of them carries the mark. */
const SEGMENTS = 60;

/**
 * A spoked wheel about y: tyre, rim, hub, spokes, one of them marked (along -z, towards the ground, at no turn).
 *
 * @param form its measures, m
 */
export function spokedWheel(form: WheelForm): Part[] {
  const { radius: R, halfWidth: w, spokes, spokeRadius, tyre = 'grip', marked = 'accent', hub = [0, 0, 0] } = form;
  const axle = alongY(hub, [0, 0, -1]);
  const depth = Math.min(1.7 * w, 0.3 * R);
  const [inner, core] = [R - 1.35 * depth, Math.max(0.09 * R, 2.2 * spokeRadius)];
  const tread: ProfilePoint[] = [
    [R - depth, -0.62 * w],
    [R - 0.62 * depth, -w],
    [R - 0.28 * depth, -0.92 * w],
    [R - 0.07 * depth, -0.55 * w],
    [R, 0],
    [R - 0.07 * depth, 0.55 * w],
    [R - 0.28 * depth, 0.92 * w],
    [R - 0.62 * depth, w],
    [R - depth, 0.62 * w],
  ];
  const rim: ProfilePoint[] = [
    [R - depth, 0.62 * w],
    [inner, 0.5 * w],
    [inner, -0.5 * w],
    [R - depth, -0.62 * w],
  ];
  const mark = 2;
  const spoke = (k: number, thickness: number): Triangle[] => {
    const angle = (2 * Math.PI * k) / spokes;
    const reach = (radius: number): Vec3 => place(axle, radius * Math.cos(angle), radius * Math.sin(angle), 0);
    return tube(reach(0.9 * core), reach(1.01 * inner), thickness, 8);
  };
  const plain = Array.from({ length: spokes - 1 }, (_, k) => spoke(k + 1, spokeRadius)).flat();
  return [
    { group: 'tyre', material: tyre, triangles: turned(tread, SEGMENTS, axle, mark, SEGMENTS - mark) },
    {
      group: 'tyre',
      material: marked,
      triangles: [
        ...turned(tread, SEGMENTS, axle, 0, mark),
        ...turned(tread, SEGMENTS, axle, SEGMENTS - mark, SEGMENTS),
      ],
    },
    { group: 'rim', material: 'aluminium', triangles: [...turned(rim, SEGMENTS, axle), ...plain] },
    { group: 'rim', material: 'steel', triangles: drum(axle, core, 1.1 * w, 24) },
    {
      group: 'mark',
      material: marked,
      triangles: [...spoke(0, 1.8 * spokeRadius), ...ball(place(axle, 0.62 * R, 0, 0), 3.2 * spokeRadius, 16)],
    },
  ];
}
