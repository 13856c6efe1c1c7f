/** Angles that start a whole turn or more from the regulator's point, with the same attitude at a press. */
import { heldOf } from '../../core/scenario/held.ts';
import { MathSymbol } from '../../charts/textView.tsx';
import type { SystemMeta } from '../../core/model/system.ts';
import type { LqrControl, ScenarioFile } from '../../core/scenario/types.ts';
import { turnsBetween } from '../../core/simulation/turnsAway.ts';
import { withEntry } from '../../app/state/draft.ts';
import { edit, useUi } from '../../ui/context.ts';
import { numberOf } from '../../ui/kit/useNumberField.ts';
import { lqrWords } from './lqrWords.ts';

interface Away {
  name: string;
  symbol: string;
  label: string;
  /** Of the same attitude, on the point's own turn, rad. */
  same: number;
}

/** By the numbers written; held coordinates stay where they are. */
export function anglesAway(meta: SystemMeta, draft: ScenarioFile, control: LqrControl): Away[] {
  const held = heldOf(meta, draft);
  return meta.coordinates
    .filter(({ kind, name }) => kind === 'angle' && !held.includes(name))
    .flatMap(({ name, symbol, label, rest = 0 }) => {
      const start = numberOf(draft.initial?.[name], rest);
      const turns = turnsBetween(start - numberOf(control.at?.[name], rest));
      return turns === 0 ? [] : [{ name, symbol, label, same: start - 2 * Math.PI * turns }];
    });
}

export function LqrTurns({ control, meta }: { control: LqrControl; meta: SystemMeta }) {
  const ui = useUi();
  const away = anglesAway(meta, ui.app.state.draft.value, control);
  return (
    <>
      {away.map(({ name, symbol, label, same }) => (
        <div class="lqr-turn" role="status" key={name} data-testid={`lqr-turn-${name}`}>
          <p>
            <MathSymbol of={symbol} /> {lqrWords.turnAway}
          </p>
          <button
            type="button"
            data-testid={`lqr-same-${name}`}
            onClick={() => edit(ui, label, (draft) => withEntry(draft, 'initial', name, same))}
          >
            {lqrWords.sameAttitude}
          </button>
        </div>
      ))}
    </>
  );
}
