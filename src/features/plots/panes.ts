/** Which plots stand there: the person's own, those of the case, or what suits the motion. */
import type { Motion } from '../../app/runs/motion.ts';
import { plotsKey } from '../../app/state/namedPlots.ts';
import type { PlotPane, PlotsState } from '../../app/state/plotPanes.ts';
import { columnsOf, groundCoordinates } from '../../core/motion/columns.ts';
import { DATA } from '../../core/motion/dataView.ts';
import { cases } from '../../core/systems/registry.ts';
import { text } from './words.ts';

/** Of data, in one plot and all together; the person adds more. */
const MOST_CURVES = 4;
const MOST_DATA_PANES = 4;

export function panesOf(motion: Motion, caseId: string, { own }: PlotsState): readonly PlotPane[] {
  return own?.key === plotsKey(motion, caseId) ? own.panes : suggested(motion, caseId);
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

/** Of data: columns of one unit in one plot, few enough to be told apart. */
function ofData({ system, trajectory }: Motion): PlotPane[] {
  const columns = columnsOf(system, trajectory.columns).filter(({ name }) => name !== 't');
  const units = [...new Set(columns.map(({ unit }) => unit))];
  return units
    .flatMap((unit) => {
      const names = columns.filter((c) => c.unit === unit).map((c) => c.name);
      return Array.from({ length: Math.ceil(names.length / MOST_CURVES) }, (_, k) =>
        names.slice(k * MOST_CURVES, (k + 1) * MOST_CURVES),
      );
    })
    .slice(0, MOST_DATA_PANES)
    .map((y) => ({ title: y.length === 1 ? y[0]! : text.names.data, x: 't', y }));
}

function general(motion: Motion): PlotPane[] {
  const { system, trajectory } = motion;
  if (system.meta.id === DATA) return ofData(motion);
  const { meta } = system;
  const coordinates = meta.coordinates.filter(({ name }) => name !== meta.clock);
  if (meta.order === 1 && !meta.shown) return [{ title: text.names.state, x: 't', y: coordinates.map((c) => c.name) }];
  const shown = ofShown(motion);
  if (shown.length > 0) return shown;
  const angles = coordinates.filter((c) => c.kind === 'angle').map((c) => c.name);
  const lengths = coordinates.filter((c) => c.kind === 'length').map((c) => c.name);
  const rates = angles.map((name) => `${name}_dot`).filter((name) => trajectory.has(name));
  return [
    { title: text.names.angles, x: 't', y: angles },
    ...(lengths.includes('X') && lengths.includes('Y')
      ? [{ title: text.names.path, x: 'X', y: ['Y'], equal: true }]
      : [{ title: text.names.positions, x: 't', y: lengths }]),
    { title: text.names.rates, x: 't', y: rates },
  ].filter((pane) => pane.y.length > 0);
}

/** What a description says is to be shown: curves of one kind in one plot, in its order; the path where it goes over the ground. */
function ofShown({ system: { meta }, trajectory }: Motion): PlotPane[] {
  const names = (meta.shown ?? []).map((name) => name.replace(/'$/, '_dot')).filter((name) => trajectory.has(name));
  const kindOf = (name: string): keyof typeof text.names | null => {
    const coordinate = meta.coordinates.find((c) => c.name === name.replace(/_dot$/, ''));
    if (!coordinate) return null;
    if (meta.order === 1) return 'state';
    return name.endsWith('_dot') ? 'rates' : coordinate.kind === 'angle' ? 'angles' : 'positions';
  };
  const kinds = [...new Set(names.map(kindOf))].filter((kind) => kind !== null);
  const ground = groundCoordinates(meta);
  const path = ground.length === 2 && ground.every((name) => names.includes(name));
  return [
    ...kinds.map((kind) => ({ title: text.names[kind], x: 't', y: names.filter((name) => kindOf(name) === kind) })),
    ...(path ? [{ title: text.names.path, x: ground[0]!, y: [ground[1]!], equal: true }] : []),
  ];
}

export interface Preset {
  id: string;
  pane: PlotPane;
}

/** Ready plots that this motion has the columns for; phase portraits apart. */
export function presetsOf(motion: Motion): { ready: Preset[]; phases: Preset[] } {
  const { system, trajectory, constraints } = motion;
  const { coordinates, inputs, sums = [] } = system.meta;
  const columns = columnsOf(system, trajectory.columns, constraints !== null);
  const names = new Set(columns.map((c) => c.name));
  const ground = groundCoordinates(system.meta);
  const over = (id: string, title: string, y: readonly string[], x = 't', equal = false): Preset[] => {
    const there = y.filter((name) => names.has(name));
    return names.has(x) && there.length > 0 ? [{ id, pane: { title, x, y: there, ...(equal ? { equal } : {}) } }] : [];
  };
  const { names: titles } = text;
  return {
    ready: [
      ...over(
        'rolls',
        titles.rolls,
        sums.map((s) => s.name),
      ),
      ...over('energy', titles.energy, ['energy', 'kinetic', 'potential']),
      ...(ground.length === 2 ? over('path', titles.path, [ground[1]!], ground[0]!, true) : []),
      ...over('length', titles.length, ['path', 'speed']),
      ...over(
        'forces',
        titles.forces,
        columns.filter((c) => c.group === 'forces').map((c) => c.name),
      ),
      ...over(
        'effort',
        titles.inputs,
        inputs.map((i) => i.name),
      ),
      ...over('power', titles.power, ['power', 'work']),
    ],
    phases: [...coordinates, ...sums].flatMap(({ name, label }) =>
      names.has(`${name}_dot`) ? over(`phase-${name}`, text.phase(label), [`${name}_dot`], name) : [],
    ),
  };
}
