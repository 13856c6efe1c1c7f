/** What the curves of a plot are, and what they are at the present time. */
import { TextView } from '../../charts/textView.tsx';
import { shownFactor, shownUnit, symbolOf, type Column } from '../../core/motion/columns.ts';
import { useSlowTime } from '../../ui/slowTime.ts';
import { Icon } from '../../ui/kit/controls.tsx';
import { formatShort } from '../../ui/kit/format.ts';
import type { PaneProps } from './paneProps.ts';
import { stylesOf, type CurveStyle } from '../../charts/columnStyles.ts';
import { text } from './words.ts';

export function Legend({ info, degrees, ...props }: PaneProps & { info: readonly Column[]; degrees: boolean }) {
  const { pane, onChange } = props;
  const styles = stylesOf(info);
  const hidden = new Set(pane.hidden);
  const toggle = (name: string) =>
    onChange({ ...pane, hidden: hidden.has(name) ? [...hidden].filter((n) => n !== name) : [...hidden, name] });
  const isolate = (name: string) => onChange({ ...pane, hidden: pane.y.filter((n) => n !== name) });
  return (
    <ul class="pane-legend">
      {info.map((c, i) => (
        <li key={c.name} class={hidden.has(c.name) ? 'off' : undefined}>
          <button
            type="button"
            aria-pressed={!hidden.has(c.name)}
            aria-label={text.hide(c.label)}
            title={`${c.label}. ${text.isolateHint}`}
            data-testid={`legend-${c.name}`}
            onClick={() => toggle(c.name)}
            onDblClick={() => isolate(c.name)}
          >
            <Sample {...styles[i]!} />
            <TextView of={symbolOf(c)} /> <LegendValue of={c} degrees={degrees} {...props} />{' '}
            <span class="unit">{shownUnit(c, degrees)}</span>
          </button>
          <button
            type="button"
            class="quiet square remove"
            aria-label={text.removeCurve(c.label)}
            title={text.removeCurve(c.label)}
            onClick={() => onChange({ ...pane, y: pane.y.filter((n) => n !== c.name) })}
          >
            <Icon name="close" />
          </button>
        </li>
      ))}
      {pane.exact && (
        <li>
          <Sample color="#8a8f98" dash={[2, 2]} /> <span>{pane.exact.label || text.exact}</span>
        </li>
      )}
    </ul>
  );
}

function Sample({ color, dash }: CurveStyle) {
  return (
    <svg width="20" height="8" aria-hidden="true">
      <line x1="0" y1="4" x2="20" y2="4" stroke={color} stroke-width="2.5" stroke-dasharray={dash?.join(' ')} />
    </svg>
  );
}

/** On its own: it follows the time, and the colours around it are not asked for again. */
function LegendValue({ of: c, values, degrees }: PaneProps & { of: Column; degrees: boolean }) {
  const time = useSlowTime();
  return <span class="number">{formatShort(values(c.name).at(time) * shownFactor(c, degrees), 4)}</span>;
}
