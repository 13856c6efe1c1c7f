/** Which plots stand there: the person's own, those of the case, or what suits the motion. */
import type { Motion } from '../../app/runs/motion.ts';
import type { PlotPane, PlotsState } from '../../app/state/plotPanes.ts';
import { columnsOf } from '../../core/motion/columns.ts';
import { cases } from '../../core/systems/registry.ts';
import { text } from './words.ts';

/** What the plots belong to: another case or system brings its own. */
export const keyOf = (motion: Motion, caseId: string): string =>
  `${motion.system.meta.id}/${motion.source === 'run' ? caseId : ''}`;

export function panesOf(motion: Motion, caseId: string, { own }: PlotsState): readonly PlotPane[] {
  return own?.key === keyOf(motion, caseId) ? own.panes : suggested(motion, caseId);
}

/** Plots of the case, on its figure's axes, and of the effort where something drives the motion; else what suits. */
export function suggested(motion: Motion, caseId: string): readonly PlotPane[] {
  const found =
    motion.source === 'run'
      ? cases.find((c) => c.id === caseId && c.scenario.system === motion.system.meta.id)
      : undefined;
  const names = new Set(columnsOf(motion.system, motion.trajectory.columns).map((c) => c.name));
  const ofCase = (found?.plots ?? []).map((p): PlotPane => ({
    title: p.title,
    x: p.x,
    y: p.y,
    ...(p.equal ? { equal: true } : {}),
    ...(p.to === undefined ? {} : { to: p.to }),
    ...(p.exact ? { exact: p.exact } : {}),
  }));
  const list = ofCase.length > 0 ? ofCase : general(motion);
  const inputs = motion.system.meta.inputs
    .map((i) => i.name)
    .filter((name) => motion.trajectory.has(name) && drives(motion, name));
  const drawn = ofCase.some((pane) => inputs.length > 0 && inputs.every((name) => pane.y.includes(name)));
  const effort: PlotPane[] =
    inputs.length > 0
      ? [
          ...(drawn ? [] : [{ title: text.names.inputs, x: 't', y: inputs }]),
          { title: text.names.power, x: 't', y: ['power'] },
        ]
      : [];
  return [...list, ...effort].filter((pane) => names.has(pane.x) && pane.y.some((y) => names.has(y)));
}

/** Whether a scenario lets this input do anything. */
function drives({ scenario }: Motion, name: string): boolean {
  if (!scenario) return true;
  const { control, inputs } = scenario;
  if (name in inputs) return true;
  return control?.type === 'lqr'
    ? control.inputs.includes(name)
    : control?.type === 'track'
      ? name in control.reference
      : false;
}

function general({ system, trajectory }: Motion): PlotPane[] {
  const { coordinates, order } = system.meta;
  const angles = coordinates.filter((c) => c.kind === 'angle').map((c) => c.name);
  const lengths = coordinates.filter((c) => c.kind === 'length').map((c) => c.name);
  if (order === 1) return [{ title: text.names.state, x: 't', y: coordinates.map((c) => c.name) }];
  const rates = angles.map((name) => `${name}_dot`).filter((name) => trajectory.has(name));
  return [
    { title: text.names.angles, x: 't', y: angles },
    ...(lengths.includes('X') && lengths.includes('Y')
      ? [{ title: text.names.path, x: 'X', y: ['Y'], equal: true }]
      : [{ title: text.names.positions, x: 't', y: lengths }]),
    { title: text.names.rates, x: 't', y: rates },
  ].filter((pane) => pane.y.length > 0);
}
