/** Riding: keys, pads, a gamepad or a tilt steer the board while it is computed, in step with the clock. */
import { useEffect, useMemo, useState } from 'preact/hooks';
import type { App } from '../../app/app.ts';
import { useUi } from '../../ui/context.ts';
import { CourseMap } from './courseMap.tsx';
import { Session } from './session.ts';
import { PersonInputs } from '../../ui/kit/personInputs.tsx';
import { HelpLink } from '../../ui/kit/helpLink.tsx';
import { Choice, Pads } from './pads.tsx';
import { gates } from './course.ts';
import './ride.css';
import { words } from './words.ts';

/** After this much of a ride its keys are known, s: the panel leaves the view; they are told again at its end. */
const LEARNT = 12;

export function RideView({ onLeave }: { onLeave(): void }) {
  const { app } = useUi();
  const session = useMemo(() => new Session(app), []);
  const [, draw] = useState(0);
  useEffect(() => session.run(() => draw((n) => n + 1)), []);
  useKeys(session, onLeave);
  const coarse = app.state.coarse.value;
  const { phase, level, pace, speed, time, passage, waiting, measure } = session;
  return (
    <div class="push-row">
      <section
        class="ride"
        aria-label={words.label}
        data-testid="ride-view"
        data-phase={phase}
        data-kind={session.kind}
        data-passed={passage.passed}
        data-latency={measure.latency ?? ''}
        data-dropped={measure.dropped}
        data-frames={measure.frames}
        data-speed={speed.toFixed(3)}
        data-time={time.toFixed(3)}
      >
        <div class="ride-numbers">
          <CourseMap passed={passage.passed} way={session.way} ghost={session.ghost()} />
          <p>
            <strong>{words.speed(speed)}</strong> · {words.seconds(time)} · {words.gate(passage.passed, gates.length)}
            {session.best && <> · {words.best(session.best.time)}</>}
          </p>
          <p class="ride-said" role="status" data-testid="ride-said">
            {session.said}
          </p>
        </div>
        <details class="ride-more" open={phase === 'over'}>
          <summary data-testid="ride-more">
            {words.choices(words.helpLevels[level]!, words.paces[pace]!, session.kind, coarse)}
          </summary>
          <div class="ride-choices">
            <Choice
              label={words.help}
              options={words.helpLevels}
              value={level}
              testId="ride-help"
              onChange={(next) => session.setHelp(next)}
            />
            <Choice
              label={words.pace}
              options={words.paces}
              value={pace}
              testId="ride-pace"
              onChange={(next) => session.setPace(next)}
            />
            <label class="ride-rider">
              <input
                type="checkbox"
                checked={session.rider}
                data-testid="ride-rider"
                onChange={(event) => session.setRider(event.currentTarget.checked)}
              />{' '}
              {words.rider}
            </label>
            {session.rider && (
              <label class="ride-rider" title={words.freeHint}>
                <input
                  type="checkbox"
                  checked={session.free}
                  data-testid="ride-free"
                  onChange={(event) => session.setFree(event.currentTarget.checked)}
                />{' '}
                {words.free}
              </label>
            )}
            {session.rider && (
              <PersonInputs person={session.person} testId="ride" onChange={(person) => session.setPerson(person)} />
            )}
            <span class="hint">
              {words.helpHint[level]} {session.kind === 'body' && words.freeHint} {coarse && words.coarse}
            </span>
          </div>
        </details>
        <Pads session={session} />
        <div class="ride-buttons">
          <button type="button" class="primary" data-testid="ride-again" onClick={() => session.begin()}>
            {words.again}
          </button>
          {phase === 'over' ? (
            <TakeOver app={app} session={session} />
          ) : (
            <button type="button" data-testid="ride-wait" onClick={() => session.setWaiting(!waiting)}>
              {waiting ? words.goOn : words.wait}
            </button>
          )}
          <button type="button" data-testid="ride-leave" onClick={onLeave}>
            {words.leave}
          </button>
          <HelpLink document="riding.md" title={words.label} />
        </div>
        {(phase !== 'riding' || time < LEARNT) && <p class="hint ride-keys">{words.keys(session.kind)}</p>}
      </section>
    </div>
  );
}

function TakeOver({ app, session }: { app: App; session: Session }) {
  // Again from any moment that the time line is at.
  const time = app.state.time.value;
  const possible = app.state.motion.value?.written?.control?.type === 'ride' && time > 0;
  return (
    <button
      type="button"
      title={words.takeOverTitle}
      disabled={!possible}
      data-testid="ride-take-over"
      onClick={() => session.takeOver()}
    >
      {words.takeOver}
    </button>
  );
}

/** Before the page's own keys. A field keeps its keys, as a choice keeps its arrows. */
function useKeys(session: Session, onLeave: () => void): void {
  useEffect(() => {
    const onKey = (event: KeyboardEvent): void => {
      const { target, key } = event;
      if (event.ctrlKey || event.metaKey || event.altKey || document.querySelector('dialog[open]')) return;
      const field = target instanceof HTMLElement && target.matches('input:not([type=checkbox]), select, textarea');
      const pressing = target instanceof HTMLElement && target.matches('button, input[type=checkbox]') && key === ' ';
      if (event.type === 'keyup') {
        if (session.controls.release(event)) event.preventDefault();
        return;
      }
      if (field || pressing) return;
      if (key === 'Escape') onLeave();
      else if (key.toLowerCase() === 'r') session.begin();
      else if (key.toLowerCase() === 'p' && session.phase === 'riding') session.setWaiting(!session.waiting);
      else if (session.phase === 'over' || !session.controls.press(event)) return;
      event.preventDefault();
      event.stopImmediatePropagation();
    };
    const release = (): void => session.controls.releaseAll();
    window.addEventListener('keydown', onKey, true);
    window.addEventListener('keyup', onKey, true);
    window.addEventListener('blur', release);
    return () => {
      window.removeEventListener('keydown', onKey, true);
      window.removeEventListener('keyup', onKey, true);
      window.removeEventListener('blur', release);
    };
  }, []);
}
