/** What of a scenario is not as in its case. */
import { difference } from '../../core/scenario/patch.ts';
import type { ScenarioFile } from '../../core/scenario/types.ts';
import type { SystemMeta } from '../../core/model/system.ts';
import { useUi } from '../context.ts';
import { text } from '../words.ts';

/** As many as a caption has room for. */
const SHOWN = 3;
const LONGEST = 28;

/** The plain name of an entry. */
function nameOf(path: string, meta: SystemMeta | undefined): string {
  const last = path.split('.').at(-1)!;
  const plain = last.replace(/_dot$/, '');
  const known = [...(meta?.parameters ?? []), ...(meta?.coordinates ?? []), ...(meta?.inputs ?? [])];
  const label = known.find(({ name }) => name === plain)?.label ?? text.changedNames[path] ?? path;
  return last !== plain ? text.rateOf(label) : label;
}

/** A controller is one thing, however much of it is written anew. */
function together(list: readonly (readonly [string, string])[]): (readonly [string, string])[] {
  const inControl = list.filter(([path]) => path.startsWith('control.'));
  return [
    ...list.filter((entry) => !inControl.includes(entry)),
    ...(inControl.length > 1 ? [['control', ''] as const] : inControl),
  ];
}

export function Changes({ from, to }: { from: ScenarioFile; to: ScenarioFile }) {
  const meta = useUi().app.systemOf(to.system)?.meta;
  const before = new Map(difference({ ...to }, { ...from }));
  const list = together(difference({ ...from }, { ...to }));
  const short = (value: string) =>
    (value.length > LONGEST ? `${value.slice(0, LONGEST)}…` : value).replaceAll('-', '\u2212').replace(/ deg$/, '°');
  const items = list.slice(0, SHOWN).map(([path, value]) => {
    const was = before.get(path);
    if (path === 'control') return text.changedNames[path]!;
    return `${nameOf(path, meta)} ${was ? `${short(was)} → ` : ''}${value === '' ? text.unset : short(value)}`;
  });
  return (
    <p data-testid="caption-changes">
      {text.changedHere} {items.join('; ')}
      {list.length > SHOWN ? text.andMore(list.length - SHOWN) : ''}.
    </p>
  );
}
