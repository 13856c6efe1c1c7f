/** The equations of the system on the stage: as the derivation prints them, and what they are worth now. */
import { useComputed, useSignal, useSignalEffect } from '@preact/signals';
import type { ComponentChildren } from 'preact';
import { useEffect, useMemo, useRef, useState } from 'preact/hooks';
import type { Typeset } from '../../core/model/typeset.ts';
import { loadTypeset } from '../../core/systems/registry.ts';
import type { SystemView } from '../../core/model/system.ts';
import { equations as words } from './words.ts';
import { LoadingPart } from '../../ui/kit/loadingPart.tsx';
import { useUi } from '../../ui/context.ts';
import { THIN } from '../../ui/kit/format.ts';
import { useSlowTime } from '../../ui/slowTime.ts';
import { BodiesSection } from './bodiesSection.tsx';
import { ConstraintsSection } from './constraintsSection.tsx';
import { BookContext, useBook } from './context.ts';
import { CoordinatesSection } from './coordinatesSection.tsx';
import { LagrangianSection } from './lagrangianSection.tsx';
import { meaningOf } from './meaning.ts';
import { MotionSection } from './motionSection.tsx';
import { NumbersSection } from './numbersSection.tsx';
import { InputsSection } from './inputsSection.tsx';
import { ParametersSection } from './parametersSection.tsx';
import { loadKatex } from './rendering.ts';
import './equations.css';

const SLOW = 250;

export function EquationsTool() {
  const ui = useUi();
  const shown = useComputed(() => ui.app.state.motion.value?.system ?? ui.system.value);
  const view = shown.value;
  const { typeset, state } = useTypeset(view);
  if (!view) return <p class="hint pad">{words.noMotion}</p>;
  if (state === 'missing')
    return (
      <p class="hint pad" data-testid="equations-none">
        {words.none(view.meta.title)}
      </p>
    );
  if (typeset?.system !== view.meta.id) return <LoadingPart failed={state === 'failed'} />;
  return <Sections key={view.meta.id} view={view} typeset={typeset} />;
}

/** The equations of a system, with the type to set them. */
function useTypeset(view: SystemView | undefined): {
  typeset: Typeset | null;
  state: 'loading' | 'ready' | 'missing' | 'failed';
} {
  const [typeset, setTypeset] = useState<Typeset | null>(null);
  const [state, setState] = useState<'loading' | 'ready' | 'missing' | 'failed'>('loading');
  const id = view?.meta.id ?? '';
  useEffect(() => {
    let current = true;
    const loading = loadTypeset(id);
    setState(loading ? 'loading' : 'missing');
    Promise.all([loading, loadKatex()]).then(
      ([loaded]) => {
        if (!current || !loaded) return;
        setTypeset(loaded);
        setState('ready');
      },
      () => current && setState('failed'),
    );
    return () => {
      current = false;
    };
  }, [id]);
  return { typeset, state };
}

function Sections({ view, typeset }: { view: SystemView; typeset: Typeset }) {
  const { state } = useUi().app;
  const pointed = useSignal<string | null>(null);
  const said = useSignal('');
  const book = useMemo(() => ({ view, typeset, pointed, said }), [view, typeset]);
  const box = useRef<HTMLDivElement>(null);
  useSignalEffect(() => {
    const mark = pointed.value;
    box.current?.querySelectorAll('.pointed').forEach((element) => element.classList.remove('pointed'));
    if (mark !== null)
      box.current?.querySelectorAll(`[data-symbol="${mark}"]`).forEach((element) => element.classList.add('pointed'));
  });
  const point = (event: Event) => {
    const found = event.target instanceof Element ? event.target.closest<HTMLElement>('[data-symbol]') : null;
    if (!found) return;
    const mark = found.dataset['symbol']!;
    const { what, value } = meaningOf(mark, view, typeset, state.motion.peek(), state.time.peek());
    found.title = value ? `${what} = ${value}` : what;
    pointed.value = mark;
  };
  const mechanical = view.meta.order !== 1;
  const { sections } = words;
  return (
    <BookContext.Provider value={book}>
      <div
        ref={box}
        class="scroll equations"
        data-testid="equations"
        data-system={view.meta.id}
        onPointerOver={point}
        onPointerDown={point}
        onPointerLeave={() => {
          pointed.value = null;
        }}
      >
        <p class="equations-about">{words.about(view.meta.title)}</p>
        <Part title={sections.coordinates} open>
          <CoordinatesSection />
        </Part>
        {mechanical && (
          <Part title={sections.bodies}>
            <BodiesSection />
          </Part>
        )}
        {mechanical && (
          <Part title={sections.lagrangian} open>
            <LagrangianSection />
          </Part>
        )}
        <Part title={sections.motion} open>
          <MotionSection />
        </Part>
        <Part title={sections.numbers}>
          <NumbersSection />
        </Part>
        {mechanical && (
          <Part title={sections.constraints}>
            <ConstraintsSection />
          </Part>
        )}
        <Part title={sections.inputs}>
          <InputsSection />
        </Part>
        <Part title={sections.parameters}>
          <ParametersSection />
        </Part>
      </div>
      <Readout />
    </BookContext.Provider>
  );
}

/** A part that is there while it is open: closed ones set no type and follow no time. */
function Part({ title, open = false, children }: { title: string; open?: boolean; children: ComponentChildren }) {
  const [shown, setShown] = useState(open);
  return (
    <details class="section" open={open} onToggle={(event) => setShown(event.currentTarget.open)}>
      <summary>
        <h3>{title}</h3>
      </summary>
      {shown && <div class="section-body">{children}</div>}
    </details>
  );
}

/** What the symbol that is pointed at means; also says that something was copied. */
function Readout() {
  const { motion } = useUi().app.state;
  const { view, typeset, pointed, said } = useBook();
  const time = useSlowTime(SLOW);
  const mark = pointed.value;
  const meaning = mark === null ? null : meaningOf(mark, view, typeset, motion.value, time);
  return (
    <div class="equations-readout" data-testid="equations-readout">
      {meaning ? (
        <>
          <code>{mark}</code>
          <span>{meaning.what}</span>
          {meaning.value && (
            <b>
              ={THIN}
              {meaning.value}
            </b>
          )}
        </>
      ) : (
        <span class="hint">{words.meaning.hint}</span>
      )}
      <span class="hidden" role="status">
        {said.value || (mark !== null && meaning ? meaning.what : '')}
      </span>
    </div>
  );
}
