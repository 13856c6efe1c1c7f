import type { Sketch, Value } from '../../geometry/drawing.ts';
import { ball, box, tube } from '../../geometry/solids.ts';

const radius = 0.05;
/** From the mark of zero; Euler's method of Fig. 13 swings to both sides of it. */
const reach = 1;
/** The time line, m: a second of the figure at the view's 2 m/s. */
const length = 2;

/**
 * A ball at the height y, drawing its curve along a time line from a scale from -1 to 1; both are marked in tenths.
 *
 * @param _ parameters, none of which shows
 */
export function draw(_: Value): Sketch {
  const [behind, width] = [0.08, 0.09];
  const marks = Array.from({ length: 21 }, (_, k) => k - 10).map((tenth) => {
    const [half, thick] = tenth % 10 === 0 ? [0.5, 0.006] : tenth % 5 === 0 ? [0.36, 0.004] : [0.22, 0.003];
    return box(
      [width * (0.5 - 2 * half), behind - 0.006, tenth / 10 - thick],
      [width / 2, behind, tenth / 10 + thick],
      0.001,
    );
  });
  const ticks = Array.from({ length: 10 }, (_, k) => (length * (k + 1)) / 10).map((x, k) =>
    box([x - 0.003, behind - 0.002, k === 9 || k === 4 ? -0.06 : -0.035], [x + 0.003, behind, 0], 0.001),
  );
  return {
    bodies: {
      marker: {
        about: 'The value y as a height above the mark of zero; origin at the ball.',
        parts: [{ group: 'ball', material: 'accent', triangles: ball([0, 0, 0], radius) }],
      },
    },
    fixtures: {
      scale: {
        about: 'Scale from -1 to 1, and a second of time; zero is the origin.',
        parts: [
          {
            group: 'board',
            material: 'paint',
            triangles: box([-width / 2, behind, -reach - 0.05], [width / 2, behind + 0.02, reach + 0.05], 0.004),
          },
          { group: 'marks', material: 'ink', triangles: marks.flat() },
          {
            group: 'line',
            material: 'ink',
            triangles: [...box([0, behind - 0.001, -0.004], [length + 0.1, behind, 0.004], 0.001), ...ticks.flat()],
          },
          {
            group: 'foot',
            material: 'steel',
            triangles: tube([0, behind + 0.01, -reach - 0.08], [0, behind + 0.01, -reach - 0.05], 0.12, 40),
          },
        ],
      },
    },
    stage: {
      still: true,
      facing: 'world',
      floor: -reach - 0.08,
      frame: [
        [-0.2, -0.1, -reach - 0.08],
        [length + 0.2, 0.1, reach + 0.1],
      ],
    },
  };
}
