/** The course from above: gates, the way so far, and where the best ride was at this time. */
import { gates, HALF_WIDTH } from './course.ts';
import { words } from './words.ts';

export interface Spot {
  x: number;
  y: number;
}

/** m around the course that are seen too. */
const MARGIN = 3;

export function CourseMap({ passed, way, ghost }: { passed: number; way: readonly number[]; ghost: Spot | null }) {
  const xs = [0, ...gates.map(({ x }) => x), ...way.filter((_, i) => i % 2 === 0)];
  const ys = [0, ...gates.map(({ y }) => y), ...way.filter((_, i) => i % 2 === 1)];
  const [left, right] = [Math.min(...xs) - MARGIN, Math.max(...xs) + MARGIN];
  const [low, high] = [Math.min(...ys) - MARGIN, Math.max(...ys) + MARGIN];
  const size = Math.max(right - left, high - low);
  const here = way.length >= 2 ? { x: way.at(-2)!, y: way.at(-1)! } : null;
  const points = Array.from({ length: way.length / 2 }, (_, i) => `${way[2 * i]},${-way[2 * i + 1]!}`).join(' ');
  return (
    <svg
      class="course-map"
      viewBox={`${left} ${-high} ${right - left} ${high - low}`}
      role="img"
      aria-label={`${words.course}: ${words.gate(passed, gates.length)}`}
    >
      {gates.map(({ x, y, heading }, i) => {
        const [dx, dy] = [-HALF_WIDTH * Math.sin(heading), HALF_WIDTH * Math.cos(heading)];
        return (
          <line
            key={i}
            class={i < passed ? 'gate done' : i === passed ? 'gate next' : 'gate'}
            x1={x + dx}
            y1={-(y + dy)}
            x2={x - dx}
            y2={-(y - dy)}
            stroke-width={size / 60}
          />
        );
      })}
      <polyline class="way" points={points} stroke-width={size / 90} />
      {ghost && <circle class="ghost" cx={ghost.x} cy={-ghost.y} r={size / 45} />}
      {here && <circle class="here" cx={here.x} cy={-here.y} r={size / 40} />}
    </svg>
  );
}
