/** Eigenvalues in the complex plane and as a table; what is pointed at in one is marked in the other. */
import { TableScroll } from '../../ui/kit/tableScroll.tsx';
import { MathSymbol } from '../../charts/textView.tsx';
import { useSignal } from '@preact/signals';
import type { Signal } from '@preact/signals';
import type { ControlAnalysis } from '../../core/control/analysis.ts';
import { Section, Toggle } from '../../ui/kit/controls.tsx';
import { formatFixed, formatShort, THIN } from '../../ui/kit/format.ts';
import { words } from './words.ts';
import { clustersOf, eigenvalueText, modeRows, qualitiesOf, type Cluster, type ModeRow } from './modes.ts';
import type { Column } from '../../core/motion/columns.ts';
import { CROSS, Plane, type Place } from './plane.tsx';
import { isWide } from './planeScale.ts';
import { ShowMode } from './showMode.tsx';

type Names = ReadonlyMap<string, Column>;

export function Eigenvalues({ analysis, names }: { analysis: ControlAnalysis; names: Names }) {
  const pointed = useSignal<string | null>(null);
  const asked = useSignal<boolean | null>(null);
  const open = modeRows(analysis.modes, 'open');
  const closed = analysis.closedLoopModes ? modeRows(analysis.closedLoopModes, 'closed') : [];
  const rows = [...open, ...closed];
  const logarithmic = asked.value ?? isWide(rows.map((row) => Math.hypot(...row.eigenvalue)));
  const clusters = [...clustersOf(open), ...clustersOf(closed)];
  return (
    <Section title={words.eigenvalues} open>
      <div class="plane-head">
        <Legend closed={closed.length > 0} />
        <span class="spring" />
        <div class="segments" role="group" aria-label={words.scale}>
          <Toggle
            pressed={!logarithmic}
            onClick={() => {
              asked.value = false;
            }}
          >
            {words.linear}
          </Toggle>
          <Toggle
            pressed={logarithmic}
            onClick={() => {
              asked.value = true;
            }}
          >
            {words.logarithmic}
          </Toggle>
        </div>
      </div>
      <Plane
        eigenvalues={rows.map((row) => row.eigenvalue)}
        logarithmic={logarithmic}
        label={words.plane(rows.length)}
        testId="eigenvalue-plane"
      >
        {(place) => <Points clusters={clusters} names={names} place={place} pointed={pointed} />}
      </Plane>
      <Detail row={rows.find((row) => row.key === pointed.value)} names={names} analysis={analysis} />
      <ModeTable
        title={closed.length > 0 ? words.openLoop : ''}
        rows={open}
        names={names}
        analysis={analysis}
        pointed={pointed}
        testId="modes-open"
      />
      {closed.length > 0 && (
        <ModeTable
          title={words.closedLoop}
          rows={closed}
          names={names}
          analysis={analysis}
          pointed={pointed}
          testId="modes-closed"
        />
      )}
    </Section>
  );
}

function Legend({ closed }: { closed: boolean }) {
  return (
    <p class="legend">
      <span>
        <svg width="12" height="12" aria-hidden="true">
          <path class="mode-open" d={CROSS} transform="translate(6 6)" />
        </svg>{' '}
        {words.openLoop}
      </span>
      {closed && (
        <span>
          <svg width="12" height="12" aria-hidden="true">
            <circle class="mode-closed" cx="6" cy="6" r="4" />
          </svg>{' '}
          {words.closedLoop}
        </span>
      )}
      <span>
        <svg width="12" height="12" aria-hidden="true">
          <rect class="growing" width="12" height="12" />
        </svg>{' '}
        {words.growing}
      </span>
    </p>
  );
}

/** Arrow keys go from point to point; Tab goes past them. */
function Points({
  clusters,
  names,
  place,
  pointed,
}: {
  clusters: readonly Cluster[];
  names: Names;
  place: Place;
  pointed: Signal<string | null>;
}) {
  const keyOf = (cluster: Cluster) => cluster.rows[0]!.key;
  const order = [...clusters].sort((a, b) => a.eigenvalue[0] - b.eigenvalue[0] || a.eigenvalue[1] - b.eigenvalue[1]);
  const current = order.findIndex((c) => c.rows.some((row) => row.key === pointed.value));
  const onKeyDown = (event: KeyboardEvent) => {
    const step = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1 }[event.key];
    if (step === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    const group = (event.currentTarget as Element).querySelectorAll<SVGElement>('[tabindex]');
    group[(Math.max(0, current) + step + order.length) % order.length]?.focus();
  };
  const point = (event: PointerEvent) => {
    const near = nearest(order, place, event);
    if (near) pointed.value = keyOf(near);
  };
  return (
    <g onKeyDown={onKeyDown} onPointerMove={point} onPointerDown={point}>
      <rect class="halo" width="100%" height="100%" />
      {order.map((cluster, i) => {
        const {
          eigenvalue: [re, im],
          rows,
        } = cluster;
        const on = i === current;
        const show = () => {
          pointed.value = keyOf(cluster);
        };
        return (
          <g
            key={keyOf(cluster)}
            class={`point${on ? ' on' : ''}`}
            role="img"
            tabIndex={i === Math.max(0, current) ? 0 : -1}
            onFocus={show}
            aria-label={rows.map((row) => modeSentence(row, names)).join('; ')}
          >
            {(im === 0 ? [1] : [1, -1]).map((side) => (
              <Mark key={side} at={place([re, side * im])} cluster={cluster} label={side > 0} />
            ))}
          </g>
        );
      })}
    </g>
  );
}

/** Points crowd: the one nearest to the pointer is meant, within reach of a finger. */
const REACH = 28;

function nearest(clusters: readonly Cluster[], place: Place, event: PointerEvent): Cluster | null {
  const box = (event.currentTarget as SVGGElement).ownerSVGElement!.getBoundingClientRect();
  const [x, y] = [event.clientX - box.left, event.clientY - box.top];
  let best: { cluster: Cluster; distance: number } | null = null;
  for (const cluster of clusters) {
    for (const side of [1, -1]) {
      const at = place([cluster.eigenvalue[0], side * cluster.eigenvalue[1]]);
      const distance = Math.hypot(at.x - x, at.y - y);
      if (distance <= REACH && distance < (best?.distance ?? Infinity)) best = { cluster, distance };
    }
  }
  return best?.cluster ?? null;
}

function Mark({ at, cluster: { rows }, label }: { at: { x: number; y: number }; cluster: Cluster; label: boolean }) {
  return (
    <>
      <circle class="halo" cx={at.x} cy={at.y} r="12" />
      {rows[0]!.loop === 'open' ? (
        <path class="mode-open" d={CROSS} transform={`translate(${at.x} ${at.y})`} />
      ) : (
        <circle class="mode-closed" cx={at.x} cy={at.y} r="4.5" />
      )}
      {label && rows.length > 1 && (
        <text class="multiplicity" x={at.x + 8} y={at.y + (rows[0]!.loop === 'open' ? -7 : 16)}>
          {rows.length}×
        </text>
      )}
    </>
  );
}

function modeSentence(row: ModeRow, names: Names): string {
  const { frequency, damping, time, kind } = qualitiesOf(row.eigenvalue);
  const parts = [
    `${row.loop === 'open' ? words.openLoop : words.closedLoop} ${eigenvalueText(row.eigenvalue)} 1/s`,
    ...(frequency === null ? [] : [`${formatShort(frequency, 3)} Hz`]),
    ...(damping === null ? [] : [`${words.damping} ${formatFixed(damping, 3)}`]),
    time === null ? words.kinds[kind] : `${words.kinds[kind]} ${words.within(formatShort(time, 3))}`,
    row.moves.map((name) => names.get(name)?.label ?? name).join(', '),
  ];
  return parts.join(', ');
}

/** Always there, so that nothing jumps. */
function Detail({ row, names, analysis }: { row: ModeRow | undefined; names: Names; analysis: ControlAnalysis }) {
  if (!row) return <p class="mode-detail hint">{words.pointHint}</p>;
  const { frequency, damping, time, kind } = qualitiesOf(row.eigenvalue);
  return (
    <p class="mode-detail" data-testid="mode-detail">
      <b>
        {eigenvalueText(row.eigenvalue, 5)}
        {THIN}1/s
      </b>
      {frequency !== null && (
        <span>
          {formatShort(frequency, 4)}
          {THIN}Hz
        </span>
      )}
      {damping !== null && (
        <span>
          {words.damping} {formatFixed(damping, 3)}
        </span>
      )}
      <span>
        {words.kinds[kind]}
        {time === null ? '' : ` ${words.within(`${formatShort(time, 3)}${THIN}s`)}`}
      </span>
      <span class="movers">{row.moves.map((name) => names.get(name)?.label ?? name).join(', ')}</span>
      <ShowMode row={row} analysis={analysis} words />
    </p>
  );
}

function ModeTable({
  title,
  rows,
  names,
  analysis,
  pointed,
  testId,
}: {
  title: string;
  rows: readonly ModeRow[];
  names: Names;
  analysis: ControlAnalysis;
  pointed: Signal<string | null>;
  testId: string;
}) {
  return (
    <TableScroll label={title || words.eigenvalues}>
      <table class="modes" data-testid={testId}>
        {title && <caption>{title}</caption>}
        <thead>
          <tr>
            {words.modeColumns.map((column) => (
              <th key={column} scope="col">
                {column}
              </th>
            ))}
            <td />
          </tr>
        </thead>
        <tbody>
          {rows.map((row) => {
            const { frequency, damping, time, kind } = qualitiesOf(row.eigenvalue);
            return (
              <tr
                key={row.key}
                class={row.key === pointed.value ? 'on' : undefined}
                data-kind={kind}
                onPointerEnter={() => {
                  pointed.value = row.key;
                }}
              >
                <th scope="row" class="number">
                  {eigenvalueText(row.eigenvalue)}
                </th>
                <td class="number">{frequency === null ? '–' : formatShort(frequency, 4)}</td>
                <td class="number">{damping === null ? '–' : formatFixed(damping, 3)}</td>
                <td class="number">{time === null ? '–' : formatShort(time, 3)}</td>
                <td class={`kind ${kind}`}>{words.kinds[kind]}</td>
                <td>
                  <Movers moves={row.moves} names={names} />
                </td>
                <td class="mode-show">
                  <ShowMode row={row} analysis={analysis} />
                </td>
              </tr>
            );
          })}
        </tbody>
      </table>
    </TableScroll>
  );
}

/** What moves, the largest first, as symbols; in words for those who point or listen. */
export function Movers({ moves, names, most = 5 }: { moves: readonly string[]; names: Names; most?: number }) {
  const label = moves.map((name) => names.get(name)?.label ?? name).join(', ');
  return (
    <span class="movers" title={label}>
      {moves.slice(0, most).map((name) => (
        <MathSymbol key={name} of={names.get(name)?.symbol ?? name} rate={names.get(name)?.rate} />
      ))}
      {moves.length > most && <span aria-hidden="true">…</span>}
      <span class="hidden">{label}</span>
    </span>
  );
}
