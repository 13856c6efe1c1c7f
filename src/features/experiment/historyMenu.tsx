/** The list of changes, newest first: a press goes to where that change is the last in force. */
import { useUi } from '../../ui/context.ts';
import { Menu } from '../../ui/kit/menu.tsx';
import { difference } from '../../core/scenario/patch.ts';
import type { DraftEdit } from '../../app/state/experiment.ts';
import { words } from './words.ts';

/** As many as a list can be read of. */
const SHOWN = 40;
const LONGEST = 24;

const short = (value: string | undefined): string => {
  const text = value || words.none;
  return text.length > LONGEST ? `${text.slice(0, LONGEST)}…` : text;
};

/** `5 deg → 8 deg`, where a change is of one entry. */
export function changeInWords({ before, after }: Pick<DraftEdit, 'before' | 'after'>): string {
  if (before.origin !== after.origin) return '';
  const there = difference({ ...before.draft }, { ...after.draft });
  if (there.length !== 1) return there.length > 1 ? words.changes(there.length) : '';
  const back = difference({ ...after.draft }, { ...before.draft });
  return `${short(back[0]?.[1])} → ${short(there[0]![1])}`.replaceAll('-', '\u2212');
}

export function HistoryMenu() {
  const { state, actions } = useUi().app;
  const [list, at] = [state.history.value, state.historyAt.value];
  const from = Math.max(0, list.length - SHOWN);
  const items = [
    ...list
      .slice(from)
      .map((edit, i) => ({
        id: String(from + i + 1),
        title: edit.label,
        summary: changeInWords(edit),
        current: from + i + 1 === at,
        choose: () => actions.goToEdit(from + i + 1),
      }))
      .reverse(),
    ...(from === 0
      ? [
          {
            id: '0',
            title: words.historyStart,
            summary: list[0]!.before.origin.title,
            current: at === 0,
            choose: () => actions.goToEdit(0),
          },
        ]
      : []),
  ];
  return (
    <Menu label={words.history} title={words.history} items={items} testId="history" align="right" above>
      {at} / {list.length}
    </Menu>
  );
}
