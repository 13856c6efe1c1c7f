/** What of the stage is switched less often: names, axes, the inset, scales. A disclosure: Escape closes it, and so does pressing elsewhere. */
import { useEffect, useId, useRef, useState } from 'preact/hooks';
import { FORCE_SCALES, scaleIndex } from '../../app/state/forceScale.ts';
import type { Figure, Quality } from '../../app/state/settingsTable.ts';
import { useCommand, useUi } from '../context.ts';
import { Check, Choice, Icon } from '../kit/controls.tsx';
import { formatShort, THIN } from '../kit/format.ts';
import { text } from '../words.ts';

const words = text.viewMenu;

export function ViewMenu({ closeUp, ridden, forced }: { closeUp: boolean; ridden: boolean; forced: boolean }) {
  const ui = useUi();
  const { state, actions } = ui.app;
  const [open, setOpen] = useState(false);
  const root = useRef<HTMLDivElement>(null);
  const id = useId();
  const close = () => {
    setOpen(false);
    root.current?.querySelector('button')?.focus();
  };

  useEffect(() => {
    if (!open) return;
    root.current?.querySelector<HTMLElement>('.view-menu-body :is(input, select)')?.focus();
    const outside = (event: Event) => {
      if (!root.current?.contains(event.target as Node)) setOpen(false);
    };
    document.addEventListener('pointerdown', outside);
    return () => document.removeEventListener('pointerdown', outside);
  }, [open]);

  const onKeyDown = (event: KeyboardEvent) => {
    if (!open) return;
    event.stopPropagation();
    if (event.key === 'Escape') {
      event.preventDefault();
      close();
    }
  };
  const onFocusOut = (event: FocusEvent) => {
    if (event.relatedTarget && !root.current?.contains(event.relatedTarget as Node)) setOpen(false);
  };

  return (
    <div class="segments view-menu" ref={root} onKeyDown={onKeyDown} onFocusOut={onFocusOut}>
      <button
        type="button"
        class="toggle view-menu-button"
        aria-expanded={open}
        aria-controls={id}
        data-testid="view-menu"
        onClick={() => setOpen(!open)}
      >
        {words.menu}
        <Icon name="down" />
      </button>
      <div id={id} class="view-menu-body" role="group" aria-label={words.menu} hidden={!open}>
        <CheckOf id="names" checked={state.showNames.value} />
        <CheckOf id="frames" checked={state.showFrames.value} />
        {closeUp && <CheckOf id="inset" checked={state.showInset.value} />}
        {ui.system.value?.meta.rider && (
          <Choice
            label={words.rider}
            value={state.showRider.value}
            testId="look-rider"
            options={words.riders}
            onChange={(figure) => actions.set('showRider', figure as Figure)}
          />
        )}
        {ridden && state.view.value === 'rider' && <CheckOf id="level" checked={state.levelHorizon.value} />}
        {forced && <ForceScale />}
        <Choice
          label={words.quality}
          value={state.quality.value}
          testId="look-quality"
          options={words.qualities}
          onChange={(quality) => actions.set('quality', quality as Quality)}
        />
      </div>
    </div>
  );
}

function ForceScale() {
  const { state, actions } = useUi().app;
  const id = useId();
  const at = state.metresPerNewton.value;
  return (
    <div class="view-menu-scale">
      <label for={id}>{words.forceScale}</label>
      <output for={id}>
        {formatShort(100 * at, 2)}
        {THIN}cm/N
      </output>
      <input
        id={id}
        type="range"
        min="0"
        max={FORCE_SCALES.length - 1}
        step="1"
        value={scaleIndex(at)}
        aria-valuetext={words.perNewton(formatShort(100 * at, 2))}
        data-testid="force-scale"
        onInput={(event) => actions.set('metresPerNewton', FORCE_SCALES[Number(event.currentTarget.value)]!)}
      />
    </div>
  );
}

function CheckOf({ id, checked }: { id: string; checked: boolean }) {
  const { title, perform } = useCommand(id);
  return <Check label={title} checked={checked} testId={`look-${id}`} onChange={perform} />;
}
