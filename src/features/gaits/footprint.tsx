/** One stroke as a curve: roll of the back plate over roll of the front plate, and where the feet are now. */
import { targetAt, type Gait } from '../../core/gait/gait.ts';
import { useUi } from '../../ui/context.ts';
import { words } from './words.ts';

const POINTS = 96;
const SIZE = 180;
/** The picture's edge at the least, rad: a small gait looks small. */
const LEAST = 0.2;

export function Footprint({ gait }: { gait: Gait }) {
  const time = useUi().app.state.time.value;
  const at = (share: number) => [targetAt(gait, 'front', share), targetAt(gait, 'back', share)] as const;
  const points = Array.from({ length: POINTS + 1 }, (_, i) => at(i / POINTS));
  const reach = Math.max(LEAST, ...points.flat().map(Math.abs)) * 1.1;
  const x = (roll: number) => SIZE / 2 + (roll / reach) * (SIZE / 2);
  const y = (roll: number) => SIZE / 2 - (roll / reach) * (SIZE / 2);
  const [front, back] = at(time * gait.frequency);
  return (
    <svg class="footprint" viewBox={`0 0 ${SIZE} ${SIZE}`} role="img" aria-label={words.footprint}>
      <path class="axis" d={`M0 ${SIZE / 2}H${SIZE}M${SIZE / 2} 0V${SIZE}`} />
      <path
        class="stroke"
        d={points.map(([a, b], i) => `${i === 0 ? 'M' : 'L'}${x(a).toFixed(1)} ${y(b).toFixed(1)}`).join('')}
      />
      <circle class="now" cx={x(front)} cy={y(back)} r={4} />
      <text x={SIZE - 4} y={SIZE / 2 - 5} text-anchor="end">
        {words.front}
      </text>
      <text x={SIZE / 2 + 5} y={11}>
        {words.back}
      </text>
    </svg>
  );
}
