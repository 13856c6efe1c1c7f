/** A button that puts a mode on the stage. */
import { Matrix } from 'ml-matrix';
import type { ControlAnalysis } from '../../core/control/analysis.ts';
import { modeMotion } from '../../core/control/linearization/modeTrajectory.ts';
import type { ScenarioFile } from '../../core/scenario/types.ts';
import type { ModeRequest } from '../../app/runs/modePreview.ts';
import { useUi } from '../../ui/context.ts';
import { Icon } from '../../ui/kit/controls.tsx';
import { eigenvalueText, type ModeRow } from './modes.ts';
import { modeWords as words } from './modeWords.ts';

/** Where the tool lies over the scene: it makes way. */
const COVERED = '(min-width: 761px) and (max-width: 1240px)';

/** What the stage needs of a mode: the matrix of its own loop, its shape, the steady motion. */
export function modeRequest(
  row: ModeRow,
  { A, B, K, states, point }: ControlAnalysis,
  scenario: ScenarioFile,
): ModeRequest {
  const loop =
    row.loop === 'closed' && K ? Matrix.sub(new Matrix(A), new Matrix(B).mmul(new Matrix(K))).to2DArray() : A;
  return {
    scenario,
    title: words.mode(eigenvalueText(row.eigenvalue)),
    mode: { states, A: loop, eigenvalue: row.eigenvalue, shape: row.shape, q: point.q, v: point.v },
    motionOf: modeMotion,
  };
}

export function ShowMode({
  row,
  analysis,
  words: worded = false,
}: {
  row: ModeRow;
  analysis: ControlAnalysis;
  words?: boolean;
}) {
  const { state, actions } = useUi().app;
  const [re, im] = row.eigenvalue;
  const show = () => {
    if (matchMedia(COVERED).matches) actions.set('tool', null);
    // What grows by more than e in a radian of its swing is over before it has swung: its shape is shown first.
    actions.showMode(modeRequest(row, analysis, state.draft.peek()), im === 0 || Math.abs(re) < Math.abs(im));
  };
  const name = words.showModeOf(eigenvalueText(row.eigenvalue));
  return (
    <button
      type="button"
      class={worded ? 'show-mode' : 'square quiet show-mode'}
      aria-label={name}
      title={words.showMode}
      data-testid={worded ? 'show-mode' : `show-${row.key}`}
      onClick={show}
    >
      <Icon name="play" />
      {worded && words.showMode}
    </button>
  );
}
