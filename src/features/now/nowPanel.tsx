/** The state at the playback time, in numbers. Follows at most 15 times a second. */
import type { Motion } from '../../app/runs/motion.ts';
import type { ColourRole, CoordinateMeta } from '../../core/model/system.ts';
import type { Trajectory } from '../../core/motion/trajectory.ts';
import { useUi } from '../../ui/context.ts';
import { Slot } from '../../ui/slot.tsx';
import { sample, useSlowTime } from '../../ui/slowTime.ts';
import { formatFixed, formatTime, formatValue, THIN } from '../../ui/kit/format.ts';
import { Chip, MathSymbol } from '../../ui/kit/symbol.tsx';
import { words } from './words.ts';

/** With what the features have to say of what is on the stage. */
export function NowTool() {
  return (
    <div class="scroll" tabIndex={0} role="region" aria-label={words.title}>
      <NowPanel />
      <Slot name="notes" />
    </div>
  );
}

export function NowPanel() {
  const { state } = useUi().app;
  const time = useSlowTime();
  const motion = state.motion.value;
  if (!motion || motion.trajectory.length === 0) return <p class="hint pad">{words.empty}</p>;
  const multipliers = motion.trajectory.columns.filter((name) => name.startsWith('lambda_'));
  return (
    <div class="now">
      <table data-testid="now">
        <caption>
          t = {formatTime(time)}
          {THIN}s
        </caption>
        <thead>
          <tr>
            <th scope="col">
              <span class="hidden">{words.title}</span>
            </th>
            <th scope="col" colSpan={2}>
              {words.value}
            </th>
            <th scope="col" colSpan={2}>
              {words.rate}
            </th>
          </tr>
        </thead>
        <tbody>
          {motion.system.meta.coordinates.map((c) => (
            <Row key={c.name} coordinate={c} trajectory={motion.trajectory} time={time} />
          ))}
        </tbody>
      </table>
      {multipliers.length > 0 && <Multipliers motion={motion} names={multipliers} time={time} />}
    </div>
  );
}

function Row({
  coordinate: c,
  trajectory,
  time,
}: {
  coordinate: CoordinateMeta;
  trajectory: Trajectory;
  time: number;
}) {
  const [value, rate] = [sample(trajectory, c.name, time), sample(trajectory, `${c.name}_dot`, time)];
  const angle = c.kind === 'angle';
  return (
    <tr>
      <th scope="row" title={c.label}>
        <Chip role={c.role} />
        <MathSymbol of={c.symbol} />
        <span class="hidden">{c.label}</span>
      </th>
      <td class="number" data-testid={`now-${c.name}`}>
        {value === null ? '–' : formatValue(value, c.kind)}
      </td>
      <td class="unit">{angle ? '°' : 'm'}</td>
      <td class="number">{rate === null ? '–' : formatValue(rate, c.kind)}</td>
      <td class="unit">{rate === null ? '' : angle ? '°/s' : 'm/s'}</td>
    </tr>
  );
}

function Multipliers({ motion, names, time }: { motion: Motion; names: readonly string[]; time: number }) {
  const forces = new Map<number, { role: ColourRole; label: string }>();
  for (const { role, label, lateral, vertical } of motion.system.contacts) {
    forces.set(lateral, { role, label: `${label}, ${words.lateral}` });
    forces.set(vertical, { role, label: `${label}, ${words.vertical}` });
  }
  return (
    <table data-testid="now-multipliers">
      <caption>{words.multipliers}</caption>
      <tbody>
        {names.map((name, i) => {
          const force = forces.get(i);
          const value = sample(motion.trajectory, name, time);
          return (
            <tr key={name}>
              <th scope="row">
                <Chip role={force?.role ?? 'neutral'} />
                <MathSymbol of={name.replace('lambda', 'λ')} /> <span class="name">{force?.label ?? ''}</span>
              </th>
              <td class="number" data-testid={`now-${name}`}>
                {value === null ? '–' : formatFixed(value, 3)}
              </td>
              <td class="unit">{force ? 'N' : ''}</td>
            </tr>
          );
        })}
      </tbody>
    </table>
  );
}
