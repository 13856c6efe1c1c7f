/** What the inputs reach, what no input reaches, and what the cost does not see. */
import { TableScroll } from '../../ui/kit/tableScroll.tsx';
import type { ControlAnalysis } from '../../core/control/analysis.ts';
import type { SystemMeta } from '../../core/model/system.ts';
import { Section } from '../../ui/kit/controls.tsx';
import { formatScientific } from '../../ui/kit/format.ts';
import { MathSymbol } from '../../charts/textView.tsx';
import { words } from './words.ts';
import { Movers } from './eigenvalues.tsx';
import { eigenvalueText, reachRows } from './modes.ts';
import type { Column } from '../../core/motion/columns.ts';

type Names = ReadonlyMap<string, Column>;

export function ReachSection({ analysis, names, meta }: { analysis: ControlAnalysis; names: Names; meta: SystemMeta }) {
  const {
    reachability: { dimension, margin, stages, byInput },
    eigenvalues,
    uncontrollable,
    unseen,
  } = analysis;
  return (
    <Section title={words.reach} open>
      <p data-testid="reach-summary">{words.reached(dimension, eigenvalues.length, stages.join(' + '))}</p>
      <p class="hint">
        {words.margin(
          Number.isFinite(margin.kept) ? formatScientific(margin.kept) : '–',
          formatScientific(margin.dropped),
        )}
      </p>
      {byInput.length > 0 && <Dots analysis={analysis} names={names} meta={meta} />}
      {uncontrollable.length > 0 && (
        <ModeList
          title={words.unreachable}
          testId="unreachable"
          names={names}
          modes={uncontrollable.map((mode) => ({ ...mode, note: mode.weighted ? words.weighted : '' }))}
        />
      )}
      {unseen !== null && unseen.length > 0 && (
        <ModeList title={words.unseen} testId="unseen" names={names} modes={unseen} />
      )}
    </Section>
  );
}

/** Modes by inputs: full where the input reaches them by itself. */
function Dots({ analysis, names, meta }: { analysis: ControlAnalysis; names: Names; meta: SystemMeta }) {
  const inputs = analysis.reachability.byInput;
  return (
    <TableScroll label={words.dots}>
      <table class="dots" data-testid="reach-dots">
        <caption>{words.dots}</caption>
        <thead>
          <tr>
            <th scope="col">{words.modeColumns[0]}</th>
            {inputs.map(({ input }) => (
              <InputHead key={input} name={input} meta={meta} />
            ))}
            <th scope="col">{words.modeColumns.at(-1)}</th>
          </tr>
        </thead>
        <tbody>
          {reachRows(analysis).map((row) => (
            <tr key={row.eigenvalue.join()}>
              <th scope="row" class="number">
                {eigenvalueText(row.eigenvalue)}
                {row.of > 1 && <span class="hint"> {row.of}×</span>}
              </th>
              {row.reached.map((count, i) => (
                <td key={inputs[i]!.input}>
                  <Dot count={count} of={row.of} />
                </td>
              ))}
              <td>
                <Movers moves={row.moves} names={names} />
              </td>
            </tr>
          ))}
        </tbody>
      </table>
    </TableScroll>
  );
}

export function InputHead({ name, meta, unit = false }: { name: string; meta: SystemMeta; unit?: boolean }) {
  const input = meta.inputs.find((i) => i.name === name);
  return (
    <th scope="col" title={input?.label}>
      <MathSymbol of={input?.symbol ?? name.replace(/^f_/, 'f_')} />
      <span class="hidden">{input?.label ?? name}</span>
      {unit && input && <span class="hint">, {input.unit}</span>}
    </th>
  );
}

function Dot({ count, of }: { count: number; of: number }) {
  const word = count === of ? words.reachedMark : count === 0 ? words.missedMark : words.partMark(count, of);
  return (
    <span title={word}>
      <svg width="12" height="12" aria-hidden="true">
        <circle class={count > 0 ? 'reach-full' : 'reach-none'} cx="6" cy="6" r="4.5" />
        {count > 0 && count < of && <path class="reach-part" d="M6 1.5a4.5 4.5 0 0 1 0 9z" />}
      </svg>
      {of > 1 && count > 0 && count < of && <span class="hint"> {count}</span>}
      <span class="hidden">{word}</span>
    </span>
  );
}

function ModeList({
  title,
  modes,
  names,
  testId,
}: {
  title: string;
  modes: readonly (ControlAnalysis['modes'][number] & { note?: string })[];
  names: Names;
  testId: string;
}) {
  return (
    <div>
      <h4>{title}</h4>
      <ul class="mode-list" data-testid={testId}>
        {modes.map((mode, i) => (
          <li key={i}>
            <span class="number">{eigenvalueText(mode.eigenvalue)}</span> <Movers moves={mode.moves} names={names} />
            <span class="mode-words">{mode.moves.map((name) => names.get(name)?.label ?? name).join(' · ')}</span>
            {mode.note && <span class="hint"> {mode.note}</span>}
          </li>
        ))}
      </ul>
    </div>
  );
}
